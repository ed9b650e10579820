//! The primitives: each with its definition, its first hit, its normal and its box.

mod cone;
mod cylinder;
mod disc;
mod plane;
mod polygon;
mod polygon_plane;
mod sphere;

pub use cone::Cone;
pub use cylinder::Cylinder;
pub use disc::Disc;
pub use plane::Plane;
pub use polygon::{Polygon, Triangle};
pub use polygon_plane::{PolygonPlane, area_share, polygon_plane};
pub use sphere::Sphere;

use crate::{Aabb, Hit, Ray, Real, Start, Vec3};

/// Anything that a ray can hit.
#[derive(Clone, Debug, PartialEq)]
pub enum Primitive {
    /// A sphere.
    Sphere(Sphere),
    /// An infinite plane.
    Plane(Plane),
    /// A triangle.
    Triangle(Triangle),
    /// A convex polygon.
    Polygon(Polygon),
    /// A disc.
    Disc(Disc),
    /// The side of a cylinder.
    Cylinder(Cylinder),
    /// The side of a cone.
    Cone(Cone),
}

impl Primitive {
    /// The nearest hit ahead of the ray.
    #[inline(always)]
    pub fn first_hit<R: Real>(&self, ray: &Ray<R>, start: Start) -> Hit<R> {
        match self {
            Self::Sphere(p) => p.first_hit(ray, start),
            Self::Plane(p) => p.first_hit(ray, start),
            Self::Triangle(p) => p.first_hit(ray, start),
            Self::Polygon(p) => p.first_hit(ray, start),
            Self::Disc(p) => p.first_hit(ray, start),
            Self::Cylinder(p) => p.first_hit(ray, start),
            Self::Cone(p) => p.first_hit(ray, start),
        }
    }

    /// Unit normal of the surface at a point of it, on its front or outer side.
    #[inline(always)]
    pub fn normal_at<R: Real>(&self, point: Vec3<R>) -> Vec3<R> {
        match self {
            Self::Sphere(p) => p.normal_at(point),
            Self::Plane(p) => p.normal.lift(),
            Self::Triangle(p) => p.plane.normal.lift(),
            Self::Polygon(p) => p.plane.normal.lift(),
            Self::Disc(p) => p.plane.normal.lift(),
            Self::Cylinder(p) => p.normal_at(point),
            Self::Cone(p) => p.normal_at(point),
        }
    }

    /// A box around it; `None` for an infinite plane.
    pub fn bounds(&self) -> Option<Aabb> {
        match self {
            Self::Sphere(p) => Some(p.bounds()),
            Self::Plane(_) => None,
            Self::Triangle(p) => Some(p.bounds()),
            Self::Polygon(p) => Some(p.bounds()),
            Self::Disc(p) => Some(p.bounds()),
            Self::Cylinder(p) => Some(p.bounds()),
            Self::Cone(p) => Some(p.bounds()),
        }
    }

    /// The plane that a flat primitive lies in.
    pub fn plane(&self) -> Option<&Plane> {
        match self {
            Self::Plane(p) => Some(p),
            Self::Triangle(p) => Some(&p.plane),
            Self::Polygon(p) => Some(&p.plane),
            Self::Disc(p) => Some(&p.plane),
            Self::Sphere(_) | Self::Cylinder(_) | Self::Cone(_) => None,
        }
    }

    /// Does it lie in a plane? Rays that leave it do not meet it again.
    pub fn is_flat(&self) -> bool {
        self.plane().is_some()
    }

    /// The plane and the corners of a flat primitive with straight edges; an infinite plane has none.
    pub fn flat(&self) -> Option<(&Plane, &[Vec3])> {
        match self {
            Self::Plane(p) => Some((p, &[])),
            Self::Triangle(p) => Some((&p.plane, &p.corners)),
            Self::Polygon(p) => Some((&p.plane, &p.corners)),
            Self::Sphere(_) | Self::Disc(_) | Self::Cylinder(_) | Self::Cone(_) => None,
        }
    }

    /// Points whose convex hull contains it; none for an infinite plane.
    pub fn hull(&self) -> Vec<Vec3> {
        match self {
            Self::Triangle(p) => p.corners.to_vec(),
            Self::Polygon(p) => p.corners.to_vec(),
            _ => self.bounds().map(|b| b.corners().to_vec()).unwrap_or_default(),
        }
    }
}
