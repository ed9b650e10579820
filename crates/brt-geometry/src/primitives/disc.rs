//! Flat discs.

use crate::{Aabb, Hit, Plane, Ray, Real, Start, Vec3, vec3};

/// A flat disc.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc {
    /// The plane that it lies in.
    pub plane: Plane,
    /// Centre.
    pub center: Vec3,
    /// Radius, > 0.
    pub radius: f64,
}

impl Disc {
    /// The disc around `center` with this unit normal.
    pub fn new(center: Vec3, normal: Vec3, radius: f64) -> Self {
        Self { plane: Plane::through(center, normal), center, radius }
    }

    /// The nearest hit ahead.
    #[inline(always)]
    pub fn first_hit<R: Real>(&self, ray: &Ray<R>, start: Start) -> Hit<R> {
        let hit = self.plane.first_hit(ray, start);
        let from_center = (ray.origin - self.center.lift()) + ray.direction * hit.t;
        let inside = from_center.length_squared().le(R::constant(self.radius * self.radius));
        Hit { found: hit.found & inside, t: hit.t }
    }

    /// Smallest box around it.
    pub fn bounds(&self) -> Aabb {
        Aabb::around(self.center, circle_extent(self.plane.normal) * self.radius)
    }
}

/// Half the size of the box around a unit circle with this unit normal.
pub(crate) fn circle_extent(normal: Vec3) -> Vec3 {
    let along = |n: f64| (1.0 - n * n).max(0.0).sqrt();
    vec3(along(normal.x), along(normal.y), along(normal.z))
}
