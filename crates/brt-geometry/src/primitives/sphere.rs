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
            return Hit::at(R::constant(-2.0) * b * ray.inv_dd, R::Mask::TRUE);
        }
        let c = from_center.length_squared() - R::constant(self.radius * self.radius);
        let zero = R::constant(0.0);
        let discriminant = b * b - ray.dd * c;
        let meets = discriminant.ge(zero) & (c.le(zero) | b.lt(zero));
        if !meets.any() {
            return Hit::none();
        }
        let root = discriminant.max(zero).sqrt();
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
