//! The space between lights and a patch: where nothing that casts shadows reaches into it, no shadow ray is needed.

use brt_geometry::{BOX_MARGIN, Primitive, SMALLEST_ANGLE, Vec3};

use super::bounding_spheres::{BoundingSpheres, Bundle};
use crate::products::{PreparedLight, PreparedScene};

/// Bits of those among the first 64 lights that nothing can hide from any of these points of a primitive, each with its
/// geometric normal on the viewer's side.
pub(crate) fn lights_surely_seen(
    scene: &PreparedScene,
    spheres: &BoundingSpheres,
    on: u32,
    points: &[(Vec3, Vec3)],
) -> u64 {
    let lo = points.iter().map(|p| p.0).fold(Vec3::splat(f64::INFINITY), Vec3::min);
    let hi = points.iter().map(|p| p.0).fold(Vec3::splat(f64::NEG_INFINITY), Vec3::max);
    let patch = Ball { center: (lo + hi) * 0.5, radius: 0.5 * (hi - lo).length() };
    let mut seen = 0;
    for (bit, light) in scene.lights.iter().enumerate().take(64) {
        let end = light_end(light, patch.center, spheres);
        let hides = |id: u32| {
            let primitive = &scene.primitives[id as usize];
            let itself = id == on && hides_nothing_itself(primitive, points, end);
            scene.infos[id as usize].casts_shadow && !itself && !is_beside(primitive, &patch, light)
        };
        if !spheres.touched_by(&shadow_bundle(&patch, end)).any(hides) {
            seen |= 1 << bit;
        }
    }
    seen
}

/// All points within `radius` of `center`.
pub(super) struct Ball {
    pub(super) center: Vec3,
    pub(super) radius: f64,
}

/// Where a light stands; of one infinitely far away, a point beyond everything.
pub(super) fn light_end(light: &PreparedLight, from: Vec3, spheres: &BoundingSpheres) -> Vec3 {
    match light {
        PreparedLight::Point { position, .. } => *position,
        PreparedLight::Directional { towards, .. } => {
            from + *towards * (4.0 * spheres.reach() + 2.0 * from.length())
        }
    }
}

/// All rays from a patch to a light. They draw together, or stay parallel: a ray's point is never farther from the
/// axis's than where it starts.
pub(super) fn shadow_bundle(patch: &Ball, end: Vec3) -> Bundle {
    Bundle { origin: patch.center, axis: end - patch.center, spread: patch.radius, turn: 0.0, end: 1.0 }
}

/// Is it certain that no ray from these points to the light meets the primitive again?
fn hides_nothing_itself(primitive: &Primitive, points: &[(Vec3, Vec3)], light: Vec3) -> bool {
    match primitive {
        // From outside a ball, towards a light above its horizon.
        Primitive::Sphere(sphere) => points.iter().all(|(point, normal)| {
            let towards = light - *point;
            let outward = (*point - sphere.center).dot(*normal) > 0.0;
            outward && normal.dot(towards) > SMALLEST_ANGLE * towards.length()
        }),
        _ => primitive.is_flat(),
    }
}

/// Do a patch and all ways from it to a light lie on one side of a flat primitive?
pub(super) fn is_beside(primitive: &Primitive, patch: &Ball, light: &PreparedLight) -> bool {
    let Some(plane) = primitive.plane() else { return false };
    let height = |p: Vec3| plane.normal.dot(p) - plane.distance;
    let size = |p: Vec3| p.length() + plane.distance.abs();
    let here = height(patch.center);
    // A light far away is approached for ever: what counts is whether that leads to the plane.
    let (there, scale) = match light {
        PreparedLight::Point { position, .. } => (height(*position), size(*position)),
        PreparedLight::Directional { towards, .. } => {
            return here.abs() > patch.radius + BOX_MARGIN * size(patch.center)
                && plane.normal.dot(*towards) * here >= 0.0;
        }
    };
    let margin = patch.radius + BOX_MARGIN * (size(patch.center) + scale);
    here.abs() > margin && there.abs() > margin && (here > 0.0) == (there > 0.0)
}
