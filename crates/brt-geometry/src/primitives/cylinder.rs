//! Circular cylinders without their caps, which are discs.

use super::disc::circle_extent;
use crate::{Aabb, Hit, LEAST_SINE, Mask, Ray, Real, Start, Vec3};

/// The curved side of a cylinder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cylinder {
    /// A point of the axis, from which heights count.
    pub base: Vec3,
    /// Unit vector along the axis.
    pub axis: Vec3,
    /// Height where the side begins.
    pub low: f64,
    /// Height where it ends, > `low`.
    pub high: f64,
    /// Radius, > 0.
    pub radius: f64,
}

impl Cylinder {
    /// The nearest hit ahead.
    #[inline(always)]
    pub fn first_hit<R: Real>(&self, ray: &Ray<R>, start: Start) -> Hit<R> {
        let axis = self.axis.lift::<R>();
        let from_base = ray.origin - self.base.lift();
        let (height, climb) = (from_base.dot(axis), ray.direction.dot(axis));
        let across = ray.direction - axis * climb;
        let from_axis = from_base - axis * height;
        let a = across.length_squared();
        let b = from_axis.dot(across);
        let zero = R::constant(0.0);
        // Rays along the axis miss: of where they come to the side only rounding would tell.
        let crosses = a.gt(R::constant(LEAST_SINE * LEAST_SINE) * ray.dd);
        let on_side = |t: R| {
            let h = height + climb * t;
            Hit::at(t, crosses & h.ge(R::constant(self.low)) & h.le(R::constant(self.high)))
        };
        if start == Start::OnPrimitive {
            let t = R::constant(-2.0) * b / a;
            let hit = on_side(t);
            return Hit { found: hit.found & ray.gets_away(t), t };
        }
        // As of a sphere: the square of half the chord, from where the ray is nearest to the axis.
        let inverse = R::constant(1.0) / a;
        let nearest = from_axis - across * (b * inverse);
        let half_chord = R::constant(self.radius * self.radius) - nearest.length_squared();
        let meets = half_chord.ge(zero);
        if !meets.any() {
            return Hit::none();
        }
        let root = (half_chord.max(zero) * a).sqrt();
        let hit = on_side((-b - root) * inverse).nearer(on_side((root - b) * inverse));
        Hit { found: hit.found & meets, t: hit.t }
    }

    /// Unit normal at a point of it, away from the axis.
    #[inline(always)]
    pub fn normal_at<R: Real>(&self, point: Vec3<R>) -> Vec3<R> {
        let axis = self.axis.lift::<R>();
        let from_base = point - self.base.lift();
        (from_base - axis * from_base.dot(axis)) * R::constant(1.0 / self.radius)
    }

    /// A box around it.
    pub fn bounds(&self) -> Aabb {
        let end = circle_extent(self.axis) * self.radius;
        let at = |height: f64| Aabb::around(self.base + self.axis * height, end);
        at(self.low).union(at(self.high))
    }
}
