//! Proves that a light is seen from all points of a patch that face it, or from none.
//!
//! From: the shaft between the light and the patch; what reaches into it and casts shadows. Nothing: lit. A primitive
//! that all ways certainly meet before the light, and nothing in the way that dims it: dark, as is a patch that faces
//! away. (Where it is not certain that a patch faces the light, a highlight would not end with the surface: open.) A flat
//! primitive with the patch and the light on one side of its plane is in no way between them.

use brt_geometry::{
    BOX_MARGIN, COORDINATE_ROUNDING, Hit, Mask, Primitive, Ray, RayBlock, Real, Shaft, Taylor, Trilean, Vec3,
};

use super::clear::Clear;
use super::{MOST_CLASSIFIED, hides_together};
use crate::margins::LIGHT_MARGIN;
use crate::methods::certified::candidates::{Candidates, MOST_LISTED};
use crate::methods::certified::known_history::KnownLighting;
use crate::products::PreparedLight;
use crate::tracing::{LightWays, Patch};

/// How the points of a patch see a light, given what is known of it, and of how ways leave the patch.
pub(in crate::methods::certified) fn lighting(
    candidates: &mut Candidates,
    patch: &Patch,
    left: Option<&Clear>,
    light: &PreparedLight,
    ways: &LightWays,
    known: KnownLighting,
) -> KnownLighting {
    let scene = candidates.scene;
    let inherited = match known {
        KnownLighting::Seen | KnownLighting::Hidden => return known,
        KnownLighting::Among(list) => Some(list),
        KnownLighting::Unknown => None,
    };
    let faces = patch.faces(ways);
    if faces == Some(false) {
        return KnownLighting::Hidden;
    }
    let Some(shaft) = shaft_of(candidates, patch, light, ways) else { return known };
    let may_hide = |id: u32| {
        let primitive = &scene.primitives[id as usize];
        let is_itself = scene.carrier(id) == patch.carrier && primitive.is_flat();
        scene.infos[id as usize].casts_shadow && !is_itself && !is_beside(primitive, &patch.point, light)
    };
    if !candidates.find(&shaft, inherited, MOST_LISTED, may_hide) {
        let is_hidden = hides_together(candidates, &shaft, patch, light, ways);
        return if is_hidden { KnownLighting::Hidden } else { known };
    }
    if candidates.found.len() > MOST_CLASSIFIED {
        return among_found(candidates);
    }
    let ray = Ray::new(patch.point, ways.towards);
    let block = match light {
        PreparedLight::Point { position, .. } => RayBlock::to_point(ray, *position),
        PreparedLight::Directional { .. } => RayBlock::new(ray),
    };
    let leaving = left.filter(|_| !scene.has_dimmers).and_then(|clear| clear.leaving(&ways.towards));
    let mut is_hidden = false;
    candidates.found.retain(|&id| {
        let primitive = &scene.primitives[id as usize];
        let before = before_light(&block.first_hit(primitive, scene.start(id, patch.carrier)), ways);
        is_hidden |= before.all() && !scene.dims(id);
        before.all()
            || (before.any() && !leaving.as_ref().is_some_and(|leaving| leaving.never_meets(primitive)))
    });
    if is_hidden && !meets_dimmer(candidates) {
        return KnownLighting::Hidden;
    }
    // Highlights end where the surface turns away: light that passes an open end must not bring one from behind.
    let is_lit = faces == Some(true) || patch.material.specular == 0.0;
    match candidates.found.is_empty() && is_lit {
        true => KnownLighting::Seen,
        false => among_found(candidates),
    }
}

/// Is what ways to a light meet before it?
pub(in crate::methods::certified) fn before_light(hit: &Hit<Taylor>, ways: &LightWays) -> Trilean {
    // An infinite limit is met by every hit; comparing with it would say nothing.
    match ways.t_max {
        t_max if t_max.is_finite() => hit.found & hit.t.lt(Taylor::constant(t_max)),
        _ => hit.found,
    }
}

/// One of those found, if any, hides the light. Where one of them only dims it, a list would say too little.
fn among_found(candidates: &mut Candidates) -> KnownLighting {
    if meets_dimmer(candidates) {
        return KnownLighting::Unknown;
    }
    KnownLighting::Among(candidates.keep_found())
}

/// May a way to the light lead through something that dims it? Rays start anew behind that, rounded anew, so nothing
/// that is proven of the way as a whole is proven of them.
fn meets_dimmer(candidates: &Candidates) -> bool {
    let scene = candidates.scene;
    scene.has_dimmers && candidates.found.iter().any(|&id| scene.dims(id))
}

/// All ways between the patch and the light. Those to a point are taken from there: they spread towards the patch.
pub(in crate::methods::certified) fn shaft_of(
    candidates: &Candidates,
    patch: &Patch,
    light: &PreparedLight,
    ways: &LightWays,
) -> Option<Shaft> {
    match light {
        PreparedLight::Point { position, .. } => candidates.shaft(&position.lift(), &-ways.towards, 1.0),
        PreparedLight::Directional { .. } => candidates.shaft(&patch.point, &ways.towards, f64::INFINITY),
    }
}

/// Does a light lie so nearly in a plane that it counts as seen from points that are at least `nearest` off the plane?
///
/// From a point at height h a light at height −a is hidden at h / (h + a) of the way, which is within [`LIGHT_MARGIN`] of its end
/// if a is at most 10⁻⁹ h. A quarter of that is for the light's height as it is computed; both heights and the distance found
/// along the way each round by less than [`COORDINATE_ROUNDING`] of all that they are made of, which is another quarter each.
fn lies_in_plane(above: f64, nearest: f64, scale: f64) -> bool {
    let room = 0.25 * LIGHT_MARGIN * nearest;
    above.abs() <= room && COORDINATE_ROUNDING * scale <= room
}

/// Do a patch and all ways from it to a light lie on one side of a flat primitive?
pub(in crate::methods::certified) fn is_beside(
    primitive: &Primitive,
    points: &Vec3<Taylor>,
    light: &PreparedLight,
) -> bool {
    let Some(plane) = primitive.plane() else { return false };
    let heights = points.along(plane.normal);
    let [lo, hi] = heights.range().map(|height| height - plane.distance);
    let size = |p: Vec3| p.x.abs() + p.y.abs() + p.z.abs();
    let scale = lo.abs().max(hi.abs()) + 2.0 * plane.distance.abs();
    let of_points =
        [points.x, points.y, points.z].map(|x| x.range().map(f64::abs).into_iter().fold(0.0, f64::max));
    let (above, margin) = match light {
        PreparedLight::Point { position, .. } => {
            let above = plane.normal.dot(*position) - plane.distance;
            let nearest = if lo > 0.0 { lo } else { -hi };
            if lies_in_plane(above, nearest, scale + of_points.iter().sum::<f64>() + size(*position)) {
                return true;
            }
            (above, BOX_MARGIN * (scale + size(*position)))
        }
        // A light far away is approached for ever: what counts is whether that leads to the plane.
        PreparedLight::Directional { towards, .. } => {
            let rise = plane.normal.dot(*towards);
            let margin = BOX_MARGIN * scale;
            return (lo > margin && rise >= 0.0) || (hi < -margin && rise <= 0.0);
        }
    };
    (lo > margin && above > margin) || (hi < -margin && above < -margin)
}
