//! Infinite planes.

use crate::margins::{LEAST_SINE, SLIVER_ROUNDINGS};
use crate::{Hit, Ray, Real, Start, Vec3};

/// All points p with `normal · p = distance`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// Unit normal.
    pub normal: Vec3,
    /// Signed distance from the origin of space.
    pub distance: f64,
    /// Square of the sine from which rays meet what lies in the plane: [`LEAST_SINE`], more for slivers.
    pub least_sine_squared: f64,
}

impl Plane {
    /// The plane with this unit normal and distance.
    pub fn new(normal: Vec3, distance: f64) -> Self {
        Self { normal, distance, least_sine_squared: LEAST_SINE * LEAST_SINE }
    }

    /// The plane through a point.
    pub fn through(point: Vec3, normal: Vec3) -> Self {
        Self::new(normal, normal.dot(point))
    }

    /// The same plane with the limit of a flat primitive of this [area share](crate::PolygonPlane::area_share). Seen along
    /// itself a sliver is thinner than rounding, and all of the line that it lies on would count as inside.
    #[must_use]
    pub fn for_area_share(self, area_share: f64) -> Self {
        let least_sine = LEAST_SINE.max(SLIVER_ROUNDINGS / area_share);
        Self { least_sine_squared: least_sine * least_sine, ..self }
    }

    /// The nearest hit ahead; rays along it miss.
    #[inline(always)]
    pub fn first_hit<R: Real>(&self, ray: &Ray<R>, start: Start) -> Hit<R> {
        if start == Start::OnPrimitive {
            return Hit::none();
        }
        let facing = self.facing(ray);
        let crosses = (facing * facing).gt(R::constant(self.least_sine_squared) * ray.dd);
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
