//! Carriers that agree within rounding become one.

use std::collections::BTreeMap;

use brt_geometry::{Cone, Cylinder, Disc, Plane, Polygon, Primitive, Sphere, Triangle, Vec3};

use super::key::{Key, reach};
use crate::margins::{CARRIER_ROUNDINGS, LEAST_COSINE};
use crate::products::Carrier;
use crate::run::Cancel;

/// What coordinates round by, and what that may move hits by.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rounding {
    /// The greatest coordinate of where the scene was before it was moved to the origin: its numbers were rounded there.
    pub(super) offset: f64,
    /// How far hits may lie beside a primitive because of another's plane: a quarter of the room that they have.
    pub(super) room: f64,
}

impl Rounding {
    /// Of what has coordinates up to this. Never so much that it could be seen: where numbers are coarser than that, what looks
    /// the same may be two things.
    fn of(&self, size: f64) -> f64 {
        (CARRIER_ROUNDINGS * (size + self.offset)).min(MOST_MOVED * self.room)
    }

    /// The same where the scene had not been moved.
    fn here(size: f64) -> f64 {
        CARRIER_ROUNDINGS * size
    }
}

/// By this share of its own size, and of the room that hits have, a primitive may be off a carrier: what stands apart stays
/// apart.
const MOST_MOVED: f64 = 0.05;

/// Compares the primitives of a run. Each gets a carrier that it lies on: one of the largest primitives', else that with the
/// nearest key.
pub(super) fn share(
    run: &mut [Key],
    primitives: &mut [Primitive],
    carriers: &mut [Carrier],
    rounding: Rounding,
    cancel: Cancel,
) {
    run.sort_unstable_by(|a, b| b.size.total_cmp(&a.size).then(a.id.cmp(&b.id)));
    let mut owners = Owners::default();
    for key in &*run {
        if cancel.is_set() {
            return;
        }
        let primitive = &primitives[key.id as usize];
        let shared = owners.near(key).find_map(|owner| {
            Some((owner, on_carrier_of(&primitives[owner as usize], primitive, rounding)?))
        });
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
fn on_carrier_of(owner: &Primitive, primitive: &Primitive, rounding: Rounding) -> Option<Primitive> {
    match (owner, primitive) {
        (Primitive::Sphere(owner), Primitive::Sphere(ball)) => {
            is_same_ball(owner, ball, rounding).then_some(Primitive::Sphere(*owner))
        }
        (Primitive::Cylinder(owner), Primitive::Cylinder(side)) => {
            let ends = ends_of(side.base, side.axis, [side.low, side.high]);
            let [low, high] = on_axis(owner.base, owner.axis, ends, rounding)?;
            let size = reach(&ends) + side.radius;
            let is_same = is_close(owner.radius, side.radius, rounding.of(size))
                && is_no_more_than_its_size(rounding.of(size), side.radius);
            is_same.then_some(Primitive::Cylinder(Cylinder { low, high, ..*owner }))
        }
        (Primitive::Cone(owner), Primitive::Cone(side)) => {
            let ends = ends_of(side.base, side.axis, [side.low, side.high]);
            let heights = ends.map(|end| owner.axis.dot(end - owner.base));
            let [low, high] = on_axis(owner.base, owner.axis, ends, rounding)?;
            let size = reach(&ends) + side.base_radius + (side.slope * side.high).abs();
            let is_same = |height: f64, own: f64| {
                is_close(radius_at(owner, height), radius_at(side, own), rounding.of(size))
            };
            let widest = side.base_radius.max(radius_at(side, side.high));
            (is_same(heights[0], side.low)
                && is_same(heights[1], side.high)
                && is_no_more_than_its_size(rounding.of(size), widest))
            .then_some(Primitive::Cone(Cone { low, high, ..*owner }))
        }
        _ => on_plane(owner.plane()?, primitive, rounding),
    }
}

fn is_close(a: f64, b: f64, error: f64) -> bool {
    (a - b).abs() <= error
}

fn is_same_ball(a: &Sphere, b: &Sphere, rounding: Rounding) -> bool {
    let error = rounding.of(reach(&[a.center, b.center]) + b.radius);
    (a.center - b.center).length() <= error
        && is_close(a.radius, b.radius, error)
        && is_no_more_than_its_size(error, b.radius)
}

fn is_no_more_than_its_size(error: f64, size: f64) -> bool {
    error <= MOST_MOVED * size
}

fn ends_of(base: Vec3, axis: Vec3, heights: [f64; 2]) -> [Vec3; 2] {
    heights.map(|height| base + axis * height)
}

fn radius_at(cone: &Cone, height: f64) -> f64 {
    cone.base_radius + cone.slope * height
}

/// The heights of two points of an axis, in their order; `None` if they do not lie on it.
fn on_axis(base: Vec3, axis: Vec3, ends: [Vec3; 2], rounding: Rounding) -> Option<[f64; 2]> {
    let error = rounding.of(reach(&ends) + reach(&[base]));
    let [a, b] = ends.map(|end| {
        let height = axis.dot(end - base);
        let off = (end - base - axis * height).length();
        (off <= error).then_some(height)
    });
    let (a, b) = (a?, b?);
    Some([a.min(b), a.max(b)])
}

/// A flat primitive in this plane. Which side is its front stays as it is.
///
/// Rays meet it where they meet the plane: beside it by how far it is off over their sine, for which hits have room. What was
/// rounded far from the origin may be farther off: it is moved into the plane, so that all that bounds it bounds its hits.
fn on_plane(plane: &Plane, primitive: &Primitive, rounding: Rounding) -> Option<Primitive> {
    let own = primitive.plane()?;
    let cosine = own.normal.dot(plane.normal);
    let turn = if cosine < 0.0 { -1.0 } else { 1.0 };
    if turn * cosine < LEAST_COSINE {
        return None;
    }
    let shared = |greatest: f64| {
        let sine = greatest / rounding.room;
        Plane {
            normal: plane.normal * turn,
            distance: plane.distance * turn,
            least_sine_squared: own.least_sine_squared.max(sine * sine),
        }
    };
    let tilt = (own.normal - plane.normal * turn).length();
    match primitive {
        Primitive::Triangle(face) => {
            let mut corners = face.corners;
            let plane = shared(move_into(plane, &mut corners, rounding)?);
            Some(Primitive::Triangle(Triangle { plane, corners }))
        }
        Primitive::Polygon(face) => {
            let mut corners = face.corners.clone();
            let plane = shared(move_into(plane, &mut corners, rounding)?);
            Some(Primitive::Polygon(Polygon { plane, corners }))
        }
        Primitive::Disc(disc) => {
            let size = reach(&[disc.center]) + disc.radius + plane.distance.abs();
            let off = tilt * disc.radius + height(plane, disc.center).abs();
            let is_on = off <= rounding.of(size) && is_no_more_than_its_size(off, disc.radius);
            let mut center = [disc.center];
            let is_far = off > Rounding::here(size);
            is_on.then(|| {
                if is_far {
                    project(plane, &mut center);
                }
                let off = if is_far { height(plane, center[0]).abs() } else { off };
                Primitive::Disc(Disc { plane: shared(off), center: center[0], ..*disc })
            })
        }
        Primitive::Plane(own) => {
            // It has no size, and nothing bounds it.
            let error = Rounding::here(own.distance.abs() + rounding.offset);
            let is_same = tilt <= CARRIER_ROUNDINGS && is_close(own.distance, turn * plane.distance, error);
            is_same.then(|| Primitive::Plane(Plane::new(plane.normal * turn, plane.distance * turn)))
        }
        Primitive::Sphere(_) | Primitive::Cylinder(_) | Primitive::Cone(_) => None,
    }
}

/// Moves the corners of a face into a plane if they are farther off than they would be here; returns how far they are off.
/// `None` if they do not lie on it.
fn move_into(plane: &Plane, corners: &mut [Vec3], rounding: Rounding) -> Option<f64> {
    let off = |corners: &[Vec3]| corners.iter().map(|p| height(plane, *p).abs()).fold(0.0, f64::max);
    // By the greatest coordinate of all corners: one that is at the origin was rotated with the others, and rounds as they do.
    let size = reach(corners) + plane.distance.abs();
    let before = off(corners);
    let extent = corners.iter().map(|p| (*p - corners[0]).length()).fold(0.0, f64::max);
    if !(before <= rounding.of(size) && is_no_more_than_its_size(before, extent)) {
        return None;
    }
    if before > Rounding::here(size) {
        project(plane, corners);
    }
    Some(off(corners))
}

fn project(plane: &Plane, points: &mut [Vec3]) {
    points.iter_mut().for_each(|p| *p = *p - plane.normal * height(plane, *p));
}

fn height(plane: &Plane, p: Vec3) -> f64 {
    plane.normal.dot(p) - plane.distance
}
