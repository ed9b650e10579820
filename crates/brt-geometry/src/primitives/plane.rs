//! Infinite planes.

use crate::{Hit, Mask, Ray, Real, SMALLEST_ANGLE, Start, Vec3};

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

    /// The nearest hit ahead.
    #[inline(always)]
    pub fn first_hit<R: Real>(&self, ray: &Ray<R>, start: Start) -> Hit<R> {
        if start == Start::OnPrimitive {
            return Hit::none();
        }
        Hit::at(self.ahead(ray) / self.facing(ray), R::Mask::TRUE)
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

    /// The nearest hit ahead with a flat piece of the plane: rays along it meet its edge at most, and miss.
    #[inline(always)]
    pub(crate) fn first_hit_of_part<R: Real>(&self, ray: &Ray<R>, start: Start) -> Hit<R> {
        let hit = self.first_hit(ray, start);
        let facing = self.facing(ray);
        let crosses = (facing * facing).gt(R::constant(SMALLEST_ANGLE * SMALLEST_ANGLE) * ray.dd);
        Hit { found: hit.found & crosses, t: hit.t }
    }
}
