//! Carriers that agree within rounding become one.

use brt_geometry::{Cone, Cylinder, Plane, Primitive, Sphere, Vec3};

use super::key::{Key, reach};
use crate::products::Carrier;

/// Roundings by which a primitive may lie off a carrier that it is given, as a share of its coordinates. Rays then meet it
/// by up to that over [`brt_geometry::LEAST_SINE`] beside where it is: 1.8·10⁻⁸ of its coordinates, a fiftieth of
/// [`brt_geometry::BOX_MARGIN`].
const ROUNDINGS: f64 = 32.0 * f64::EPSILON;

/// Cosine of the angle between faces that may share a plane. (Corners alone say nothing of faces that are as small as
/// rounding.)
const LEAST_COSINE: f64 = 1.0 - 1e-6;

/// Compares the primitives of a run. Each gets the first carrier that it lies on, that of the largest primitive.
pub(super) fn share(run: &mut [Key], primitives: &mut [Primitive], carriers: &mut [Carrier]) {
    run.sort_unstable_by(|a, b| b.size.total_cmp(&a.size).then(a.id.cmp(&b.id)));
    let mut owners: Vec<&Key> = Vec::new();
    for key in &*run {
        let is_near = |owner: &&&Key| (owner.number - key.number).abs() <= owner.error + key.error;
        let primitive = &primitives[key.id as usize];
        let shared = owners
            .iter()
            .filter(is_near)
            .find_map(|owner| Some((owner.id, on_carrier_of(&primitives[owner.id as usize], primitive)?)));
        match shared {
            Some((owner, moved)) => {
                primitives[key.id as usize] = moved;
                carriers[key.id as usize] = carriers[owner as usize];
            }
            None => owners.push(key),
        }
    }
}

/// A primitive on the carrier of `owner`; `None` if it does not lie on it.
fn on_carrier_of(owner: &Primitive, primitive: &Primitive) -> Option<Primitive> {
    match (owner, primitive) {
        (Primitive::Sphere(owner), Primitive::Sphere(ball)) => {
            is_same_ball(owner, ball).then_some(Primitive::Sphere(*owner))
        }
        (Primitive::Cylinder(owner), Primitive::Cylinder(side)) => {
            let ends = ends_of(side.base, side.axis, [side.low, side.high]);
            let [low, high] = on_axis(owner.base, owner.axis, ends)?;
            let size = reach(&ends) + side.radius;
            is_close(owner.radius, side.radius, size).then_some(Primitive::Cylinder(Cylinder {
                low,
                high,
                ..*owner
            }))
        }
        (Primitive::Cone(owner), Primitive::Cone(side)) => {
            let ends = ends_of(side.base, side.axis, [side.low, side.high]);
            let heights = ends.map(|end| owner.axis.dot(end - owner.base));
            let [low, high] = on_axis(owner.base, owner.axis, ends)?;
            let size = reach(&ends) + side.base_radius + (side.slope * side.high).abs();
            let is_same =
                |height: f64, own: f64| is_close(radius_at(owner, height), radius_at(side, own), size);
            (is_same(heights[0], side.low) && is_same(heights[1], side.high))
                .then_some(Primitive::Cone(Cone { low, high, ..*owner }))
        }
        _ => on_plane(owner.plane()?, primitive),
    }
}

fn is_close(a: f64, b: f64, size: f64) -> bool {
    (a - b).abs() <= ROUNDINGS * size
}

fn is_same_ball(a: &Sphere, b: &Sphere) -> bool {
    let size = reach(&[a.center, b.center]) + b.radius;
    (a.center - b.center).length() <= ROUNDINGS * size && is_close(a.radius, b.radius, size)
}

fn ends_of(base: Vec3, axis: Vec3, heights: [f64; 2]) -> [Vec3; 2] {
    heights.map(|height| base + axis * height)
}

fn radius_at(cone: &Cone, height: f64) -> f64 {
    cone.base_radius + cone.slope * height
}

/// The heights of two points of an axis, in their order; `None` if they do not lie on it.
fn on_axis(base: Vec3, axis: Vec3, ends: [Vec3; 2]) -> Option<[f64; 2]> {
    let size = reach(&ends) + reach(&[base]);
    let [a, b] = ends.map(|end| {
        let height = axis.dot(end - base);
        let off = (end - base - axis * height).length();
        (off <= ROUNDINGS * size).then_some(height)
    });
    let (a, b) = (a?, b?);
    Some([a.min(b), a.max(b)])
}

/// A flat primitive in this plane. Which side is its front stays as it is.
fn on_plane(plane: &Plane, primitive: &Primitive) -> Option<Primitive> {
    let own = primitive.plane()?;
    let cosine = own.normal.dot(plane.normal);
    let turn = if cosine < 0.0 { -1.0 } else { 1.0 };
    let shared = Plane { normal: plane.normal * turn, distance: plane.distance * turn, ..*own };
    let off = |p: Vec3| (plane.normal.dot(p) - plane.distance).abs();
    let is_on = |p: Vec3| off(p) <= ROUNDINGS * (reach(&[p]) + plane.distance.abs());
    let tilt = (own.normal - shared.normal).length();
    if turn * cosine < LEAST_COSINE {
        return None;
    }
    match primitive {
        Primitive::Triangle(face) => face.corners.iter().all(|p| is_on(*p)).then(|| {
            let mut face = *face;
            face.plane = shared;
            Primitive::Triangle(face)
        }),
        Primitive::Polygon(face) => face.corners.iter().all(|p| is_on(*p)).then(|| {
            let mut face = face.clone();
            face.plane = shared;
            Primitive::Polygon(face)
        }),
        Primitive::Disc(disc) => {
            let is_level = tilt * disc.radius <= ROUNDINGS * (reach(&[disc.center]) + disc.radius);
            (is_level && is_on(disc.center))
                .then_some(Primitive::Disc(brt_geometry::Disc { plane: shared, ..*disc }))
        }
        Primitive::Plane(own) => {
            let is_level = tilt <= ROUNDINGS;
            (is_level && is_close(own.distance, shared.distance, own.distance.abs()))
                .then_some(Primitive::Plane(shared))
        }
        Primitive::Sphere(_) | Primitive::Cylinder(_) | Primitive::Cone(_) => None,
    }
}
