//! Geometry: numbers, vectors, primitives, and the tree that finds them.
//!
//! Every predicate (hit, order, inside) stands here once, generic over [`Real`].
//!
//! This page owns every tolerance of the project; no other file may contain one. None of them takes part in the
//! decision whether a ray hits: a ray that leaves a primitive skips the root at its origin instead of an epsilon.

mod polygon_plane;
mod real;
mod vec3;

pub use polygon_plane::{PolygonPlane, polygon_plane};
pub use real::{Mask, Real, power_by_squaring};
pub use vec3::{Vec3, vec3};

/// Directions closer than this (in radians) count as parallel when a scene is checked.
pub const SMALLEST_ANGLE: f64 = 1e-9;

/// Points of a polygon may be off its plane by this share of the polygon's size: files round to about six digits.
pub const POLYGON_FLATNESS: f64 = 1e-3;

/// Facets of a mesh without normals belong to one surface if their normals differ by less (in radians).
pub const FACET_ANGLE: f64 = 1e-6;
