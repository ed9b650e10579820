//! Numbers by which primitives that may share a carrier are found next to each other.

use brt_geometry::{Aabb, Primitive, Vec3, vec3};
use rayon::prelude::*;

use crate::margins::{KEY_ROUNDINGS, WORST_KEY};

/// By how much of its radius the place of something round is moved: concentric ones have places of their own.
const BY_RADIUS: Vec3 = Vec3 { x: 0.3, y: 0.5, z: 0.7 };

/// A primitive's place among all others.
pub(super) struct Key {
    /// The same for all primitives on one carrier, but for an error.
    pub(super) number: f64,
    pub(super) error: f64,
    /// How well its carrier is known: of coinciding primitives the largest says where the carrier is.
    pub(super) size: f64,
    pub(super) id: u32,
}

/// From where carriers are looked at, and along which direction their places are projected to a number. Neither has
/// anything to do with the axes or the middle of a scene, so that different carriers rarely have the same number.
struct View {
    from: Vec3,
    along: Vec3,
    /// The greatest coordinate of where numbers were rounded before the scene was moved to the origin.
    offset: f64,
}

/// The keys of all primitives.
pub(super) fn keys(primitives: &[Primitive], bounds: &Aabb, offset: f64) -> Vec<Key> {
    let size = bounds.longest_side().max(f64::MIN_POSITIVE);
    let view = View {
        from: bounds.center() + vec3(1.617, 2.239, -1.423) * size,
        along: vec3(0.563, -0.327, 0.759),
        offset,
    };
    let keys = primitives.par_iter().enumerate().map(|(id, primitive)| {
        let (place, error, size) = view.place_of(primitive);
        let error = error.min(WORST_KEY * (place - view.from).length());
        let rounding = KEY_ROUNDINGS * (place.length() + view.from.length() + offset);
        Key { number: place.dot(view.along), error: error + rounding, size, id: id as u32 }
    });
    keys.collect()
}

impl View {
    /// A point that belongs to the carrier whichever way round it is described, how far it may be off by rounding, and the
    /// size by which the carrier is known.
    fn place_of(&self, primitive: &Primitive) -> (Vec3, f64, f64) {
        match primitive {
            Primitive::Sphere(ball) => (ball.center + BY_RADIUS * ball.radius, 0.0, ball.radius),
            Primitive::Cylinder(side) => {
                let foot = self.foot_on_axis(side.base, side.axis, [side.low, side.high]);
                foot.with_radius(side.radius, 0.0)
            }
            Primitive::Cone(side) => {
                let foot = self.foot_on_axis(side.base, side.axis, [side.low, side.high]);
                foot.with_radius(side.base_radius + side.slope * foot.height, side.slope)
            }
            Primitive::Plane(plane) => (
                self.from + plane.normal * (plane.distance - plane.normal.dot(self.from)),
                0.0,
                f64::INFINITY,
            ),
            Primitive::Triangle(face) => self.foot_on_plane(face.plane.normal, &face.corners),
            Primitive::Polygon(face) => self.foot_on_plane(face.plane.normal, &face.corners),
            Primitive::Disc(disc) => {
                let (normal, size) = (disc.plane.normal, disc.radius);
                let away = normal.dot(disc.center - self.from);
                let tilt = KEY_ROUNDINGS * (reach(&[disc.center]) + self.offset) / size;
                (self.from + normal * away, tilt * away.abs(), size)
            }
        }
    }

    /// The point of a face's plane that is nearest to the view.
    fn foot_on_plane(&self, normal: Vec3, corners: &[Vec3]) -> (Vec3, f64, f64) {
        let away = normal.dot(corners[0] - self.from);
        let spread = |p: &Vec3| (*p - corners[0]).length_squared();
        let size = corners.iter().map(spread).fold(0.0, f64::max).sqrt();
        let twice_area = (1..corners.len() - 1)
            .map(|i| normal.dot((corners[i] - corners[0]).cross(corners[i + 1] - corners[0])))
            .sum::<f64>();
        // How far a corner is off the plane turns it about the face's width.
        let tilt = KEY_ROUNDINGS * (reach(corners) + self.offset) * size / twice_area.abs();
        (self.from + normal * away, tilt * away.abs(), twice_area.abs() / size)
    }

    /// The point of an axis that is nearest to the view.
    fn foot_on_axis(&self, base: Vec3, axis: Vec3, [low, high]: [f64; 2]) -> Foot {
        let (height, length) = (axis.dot(self.from - base), high - low);
        let tilt = KEY_ROUNDINGS * (reach(&[base]) + low.abs() + high.abs() + self.offset) / length;
        let error = tilt * (height.abs() + (base - self.from).length());
        Foot { place: base + axis * height, height, error, length }
    }
}

/// The point of an axis that is nearest to the view.
struct Foot {
    place: Vec3,
    /// Above the base.
    height: f64,
    error: f64,
    /// Of the primitive along the axis.
    length: f64,
}

impl Foot {
    /// On one axis the radius there tells carriers apart.
    fn with_radius(&self, radius: f64, slope: f64) -> (Vec3, f64, f64) {
        // The slope is a difference of radii over the length, the foot as far away as it is.
        let of_radius = KEY_ROUNDINGS
            * (radius.abs() + slope.abs() * self.height.abs())
            * (1.0 + self.height.abs() / self.length);
        let error = self.error * (1.0 + slope.abs()) + of_radius;
        (self.place + BY_RADIUS * radius, error, self.length)
    }
}

/// The greatest coordinate of points.
pub(super) fn reach(points: &[Vec3]) -> f64 {
    points.iter().map(|p| p.x.abs().max(p.y.abs()).max(p.z.abs())).fold(0.0, f64::max)
}

/// Runs of keys whose numbers may be the same but for their errors; alone is no run.
pub(super) fn runs(keys: &mut [Key]) -> impl Iterator<Item = &mut [Key]> {
    keys.par_sort_unstable_by(|a, b| {
        (a.number - a.error).total_cmp(&(b.number - b.error)).then(a.id.cmp(&b.id))
    });
    let mut rest = keys;
    std::iter::from_fn(move || {
        loop {
            let all = std::mem::take(&mut rest);
            if all.is_empty() {
                return None;
            }
            let mut end = all[0].number + all[0].error;
            let mut count = 1;
            // What is not a number is near nothing.
            while count < all.len() && all[count].number - all[count].error <= end {
                end = end.max(all[count].number + all[count].error);
                count += 1;
            }
            let (run, others) = all.split_at_mut(count);
            rest = others;
            if count > 1 {
                return Some(run);
            }
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_hold_what_may_be_the_same() {
        let key = |id: u32, number: f64, error: f64| Key { number, error, size: 1.0, id };
        let runs_of = |mut keys: Vec<Key>| -> Vec<Vec<u32>> {
            runs(&mut keys).map(|run| run.iter().map(|k| k.id).collect()).collect()
        };
        let keys =
            vec![key(0, 1.0, 0.1), key(1, 2.0, 0.3), key(2, 2.4, 0.2), key(3, 2.55, 0.0), key(4, 9.0, 0.1)];
        assert_eq!(runs_of(keys), [[1, 2, 3]]);
        // One whose error reaches over its neighbours.
        assert_eq!(runs_of(vec![key(0, 1.0, 0.0), key(1, 1.1, 0.0), key(2, 1.2, 0.5)]), [[2, 0, 1]]);
    }
}
