//! Spheres.

use crate::{Aabb, Hit, Mask, Ray, Real, Start, Vec3};

/// All points at one distance from a centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Centre.
    pub center: Vec3,
    /// Radius, > 0.
    pub radius: f64,
}

impl Sphere {
    /// The nearest hit ahead.
    #[inline(always)]
    pub fn first_hit<R: Real>(&self, ray: &Ray<R>, start: Start) -> Hit<R> {
        let from_center = ray.origin - self.center.lift();
        let b = from_center.dot(ray.direction);
        if start == Start::OnPrimitive {
            // c = 0: the roots are 0 and -2b/a.
            let t = R::constant(-2.0) * b * ray.inv_dd;
            return Hit::at(t, ray.gets_away(t));
        }
        let zero = R::constant(0.0);
        let radius_squared = R::constant(self.radius * self.radius);
        // The square of half the chord, from where the ray is nearest to the centre. The textbook's b² − dd·c is the same in
        // units of dd, but of a ball far away it is a difference of numbers that are all rounding: it would look thousands
        // of times its size (Haines, Günther, Akenine-Möller 2019).
        let to_nearest = b * ray.inv_dd;
        let nearest = from_center - ray.direction * to_nearest;
        let half_chord = radius_squared - nearest.length_squared();
        // From inside, where the way to the middle of the chord is shorter than half of it, or towards the middle.
        let is_ahead = (b * to_nearest).le(half_chord) | b.lt(zero);
        let meets = half_chord.ge(zero) & is_ahead;
        if !meets.any() {
            return Hit::none();
        }
        let root = (half_chord.max(zero) * ray.dd).sqrt();
        let near = -b - root;
        let t = R::select(near.gt(zero), near, root - b) * ray.inv_dd;
        Hit::at(t, meets)
    }

    /// Unit normal at a point of it, outward.
    #[inline(always)]
    pub fn normal_at<R: Real>(&self, point: Vec3<R>) -> Vec3<R> {
        (point - self.center.lift()) * R::constant(1.0 / self.radius)
    }

    /// Smallest box around it.
    pub fn bounds(&self) -> Aabb {
        Aabb::around(self.center, Vec3::splat(self.radius))
    }
}
