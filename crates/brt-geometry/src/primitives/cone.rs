//! Circular cones and frusta without their caps, which are discs.

use super::disc::circle_extent;
use crate::{Aabb, Hit, LEAST_SINE, Mask, Ray, Real, Start, Vec3};

/// The curved side of a cone or frustum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cone {
    /// A point of the axis, from which heights count.
    pub base: Vec3,
    /// Unit vector along the axis.
    pub axis: Vec3,
    /// Height where the side begins.
    pub low: f64,
    /// Height where it ends, > `low`.
    pub high: f64,
    /// Radius at height 0. Between `low` and `high` the radius is not negative.
    pub base_radius: f64,
    /// Growth of the radius per unit of the axis.
    pub slope: f64,
}

impl Cone {
    /// The nearest hit ahead.
    #[inline(always)]
    pub fn first_hit<R: Real>(&self, ray: &Ray<R>, start: Start) -> Hit<R> {
        let axis = self.axis.lift::<R>();
        let slope = R::constant(self.slope);
        let from_base = ray.origin - self.base.lift();
        let (height, climb) = (from_base.dot(axis), ray.direction.dot(axis));
        let across = ray.direction - axis * climb;
        let from_axis = from_base - axis * height;
        let (radius, widening) = (R::constant(self.base_radius) + slope * height, slope * climb);
        let (spread, steepness) = (across.length_squared(), widening * widening);
        let a = spread - steepness;
        // Rays along the axis of what is nearly a cylinder miss, as they miss a cylinder.
        let crosses = (spread + steepness).gt(R::constant(LEAST_SINE * LEAST_SINE) * ray.dd);
        // Counted from where the distance from the axis and the radius, as one vector, are least: both are then no more than
        // √2 times the radius where the cone is met, so that the quadratic rounds by as much. Counted from the ray's start, or
        // from near the base, it would round by the square of the way from there to the hit, and tips would look thick.
        let skipped = match start {
            Start::OnPrimitive => R::constant(0.0),
            Start::Elsewhere => -(from_axis.dot(across) + radius * widening) / (spread + steepness),
        };
        let (from_axis, radius) = (from_axis + across * skipped, radius + widening * skipped);
        let height = height + climb * skipped;
        let b = from_axis.dot(across) - radius * widening;
        let zero = R::constant(0.0);
        // Between its ends the radius is not negative, so the other nappe never counts.
        let on_side = |t: R| {
            let h = height + climb * t;
            Hit::at(skipped + t, crosses & h.ge(R::constant(self.low)) & h.le(R::constant(self.high)))
        };
        if start == Start::OnPrimitive {
            let t = R::constant(-2.0) * b / a;
            let hit = on_side(t);
            return Hit { found: hit.found & ray.gets_away(t), t };
        }
        let c = from_axis.length_squared() - radius * radius;
        let discriminant = b * b - a * c;
        let meets = discriminant.ge(zero);
        if !meets.any() {
            return Hit::none();
        }
        let root = discriminant.max(zero).sqrt();
        // q has no cancellation and the second root stays finite where a vanishes (ray along the side).
        let q = R::select(b.lt(zero), root - b, -b - root);
        let hit = on_side(q / a).nearer(on_side(c / q));
        Hit { found: hit.found & meets, t: hit.t }
    }

    /// Unit normal at a point of it, outward.
    #[inline(always)]
    pub fn normal_at<R: Real>(&self, point: Vec3<R>) -> Vec3<R> {
        let axis = self.axis.lift::<R>();
        let from_base = point - self.base.lift();
        let across = from_base - axis * from_base.dot(axis);
        let outward = across - axis * (across.length() * R::constant(self.slope));
        outward.normalize()
    }

    /// A box around it.
    pub fn bounds(&self) -> Aabb {
        let extent = circle_extent(self.axis);
        let at = |height: f64| {
            let radius = (self.base_radius + self.slope * height).max(0.0);
            Aabb::around(self.base + self.axis * height, extent * radius)
        };
        at(self.low).union(at(self.high))
    }
}
