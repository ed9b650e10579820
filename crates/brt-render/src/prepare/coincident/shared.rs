//! Carriers that agree within rounding become one.

use std::collections::BTreeMap;

use brt_geometry::{Cone, Cylinder, Plane, Primitive, Sphere, Vec3};

use super::key::{Key, reach};
use crate::products::Carrier;

/// Roundings by which a primitive may lie off a carrier that it is given, as a share of the greatest of its coordinates and
/// the carrier's distance. Rays then meet it by up to that over [`brt_geometry::LEAST_SINE`] beside where it is: 1.8·10⁻⁸ of
/// both. Each is at most 4.5 sizes of the scene, so this is 1.6·10⁻⁷ of it, a sixth of [`brt_geometry::BOX_MARGIN`].
const ROUNDINGS: f64 = 32.0 * f64::EPSILON;

/// Cosine of the angle between faces that may share a plane. (Corners alone say nothing of faces that are as small as
/// rounding.)
const LEAST_COSINE: f64 = 1.0 - 1e-6;

/// Compares the primitives of a run. Each gets a carrier that it lies on: one of the largest primitives', else that with the
/// nearest key.
pub(super) fn share(run: &mut [Key], primitives: &mut [Primitive], carriers: &mut [Carrier]) {
    run.sort_unstable_by(|a, b| b.size.total_cmp(&a.size).then(a.id.cmp(&b.id)));
    let mut owners = Owners::default();
    for key in &*run {
        let primitive = &primitives[key.id as usize];
        let shared = owners
            .near(key)
            .find_map(|owner| Some((owner, on_carrier_of(&primitives[owner as usize], primitive)?)));
        match shared {
            Some((owner, moved)) => {
                primitives[key.id as usize] = moved;
                carriers[key.id as usize] = carriers[owner as usize];
            }
            None => owners.add(key),
        }
    }
}

/// Primitives that have a carrier of their own.
///
/// Faces of a plate whose corners are rounded a little off one plane all have nearly the same key, and none lies on the plane
/// of another: were each compared with all, time would grow with the square of their number. What does coincide was computed
/// from the same corners, or from such as differ by rounding, and so its key is nearest.
#[derive(Default)]
struct Owners<'k> {
    largest: Vec<&'k Key>,
    /// By [`ordinal`] and id.
    by_number: BTreeMap<(u64, u32), &'k Key>,
}

impl<'k> Owners<'k> {
    /// So many of the largest are always compared: on a floor lie many small things, whose keys are known less well.
    const LARGEST: usize = 8;

    /// So many are compared to each side of a key.
    const NEAREST: usize = 16;

    fn add(&mut self, key: &'k Key) {
        if self.largest.len() < Self::LARGEST {
            self.largest.push(key);
        }
        self.by_number.insert((ordinal(key.number), key.id), key);
    }

    /// Ids of those whose keys are the same but for their errors.
    fn near(&self, key: &Key) -> impl Iterator<Item = u32> {
        let place = (ordinal(key.number), key.id);
        let below = self.by_number.range(..place).rev().take(Self::NEAREST);
        let above = self.by_number.range(place..).take(Self::NEAREST);
        let (number, error) = (key.number, key.error);
        let nearest = below.chain(above).map(|(_, owner)| owner);
        self.largest
            .iter()
            .chain(nearest)
            .filter(move |owner| (owner.number - number).abs() <= owner.error + error)
            .map(|owner| owner.id)
    }
}

/// An integer that is greater for a greater number.
fn ordinal(number: f64) -> u64 {
    let bits = number.to_bits();
    if bits >> 63 == 0 { bits | 1 << 63 } else { !bits }
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
    // By the greatest coordinate of all corners: one that is at the origin was rotated with the others, and rounds as they do.
    let lies_on = |corners: &[Vec3]| {
        let size = reach(corners) + plane.distance.abs();
        corners.iter().all(|&corner| off(corner) <= ROUNDINGS * size)
    };
    let tilt = (own.normal - shared.normal).length();
    if turn * cosine < LEAST_COSINE {
        return None;
    }
    match primitive {
        Primitive::Triangle(face) => lies_on(&face.corners).then(|| {
            let mut face = *face;
            face.plane = shared;
            Primitive::Triangle(face)
        }),
        Primitive::Polygon(face) => lies_on(&face.corners).then(|| {
            let mut face = face.clone();
            face.plane = shared;
            Primitive::Polygon(face)
        }),
        Primitive::Disc(disc) => {
            let size = reach(&[disc.center]) + disc.radius + plane.distance.abs();
            (tilt * disc.radius + off(disc.center) <= ROUNDINGS * size)
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
