//! Infinite planes.

use crate::{Hit, LEAST_SINE, Ray, Real, Start, Vec3};

/// All points p with `normal · p = distance`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// Unit normal.
    pub normal: Vec3,
    /// Signed distance from the origin of space.
    pub distance: f64,
}

impl Plane {
    /// The plane through a point.
    pub fn through(point: Vec3, normal: Vec3) -> Self {
        Self { normal, distance: normal.dot(point) }
    }

    /// The nearest hit ahead; rays along it ([`LEAST_SINE`]) miss.
    #[inline(always)]
    pub fn first_hit<R: Real>(&self, ray: &Ray<R>, start: Start) -> Hit<R> {
        if start == Start::OnPrimitive {
            return Hit::none();
        }
        let facing = self.facing(ray);
        let crosses = (facing * facing).gt(R::constant(LEAST_SINE * LEAST_SINE) * ray.dd);
        Hit::at(self.ahead(ray) / facing, crosses)
    }

    /// How far the plane is from the ray's start, along the normal.
    #[inline(always)]
    pub fn ahead<R: Real>(&self, ray: &Ray<R>) -> R {
        R::constant(self.distance) - self.normal.lift().dot(ray.origin)
    }

    /// How far the ray's direction goes along the normal.
    #[inline(always)]
    pub fn facing<R: Real>(&self, ray: &Ray<R>) -> R {
        self.normal.lift().dot(ray.direction)
    }
}
