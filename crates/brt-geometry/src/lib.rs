//! Geometry: numbers, vectors, primitives, and the tree that finds them.
//!
//! Every predicate (hit, order, inside) stands here once, generic over [`Real`].
//!
//! This page owns every tolerance of geometry and rendering, but for the units of rounding that bounds add up
//! (`taylor.rs`, `bvh/traverse.rs`). A ray that leaves a primitive skips the
//! root at its origin instead of an epsilon.

mod aabb;
mod affine;
mod bvh;
mod extents;
mod grid;
mod index;
mod lanes;
mod polygon_plane;
mod primitives;
mod ray;
mod ray_block;
mod ray_shaft;
mod real;
mod shaft;
mod taylor;
mod triangulate;
mod trilean;
mod vec3;

pub use aabb::Aabb;
pub use affine::Affine;
pub use bvh::{Bvh, Traversal};
pub use extents::Extents;
pub use grid::Grid;
pub use index::SpatialIndex;
pub use lanes::{LANES, LaneMask, Lanes, SimdLevel, UnknownSimdLevel};
pub use polygon_plane::{PolygonPlane, area_share, polygon_plane};
pub use primitives::{Cone, Cylinder, Disc, Plane, Polygon, Primitive, Sphere, Triangle};
pub use ray::{Across, Hit, Ray, Start};
pub use ray_block::RayBlock;
pub use ray_shaft::LaneRays;
pub use real::{Exponent, Mask, Real};
pub use shaft::Shaft;
pub use taylor::Taylor;
pub use triangulate::{is_convex, triangulate};
pub use trilean::Trilean;
pub use vec3::{Vec3, vec3};

/// Directions closer than this (in radians) count as parallel when a scene is checked and prepared.
pub const SMALLEST_ANGLE: f64 = 1e-9;

/// Lengths below this cannot be traced: their fourth powers must stay far from 0.
pub const SMALLEST_LENGTH: f64 = 1e-30;

/// Rays along a plane, closer to it than this (as a sine), do not meet what lies in it. What corners and rays are off by
/// rounding, over this, is how far along a ray a hit may be from the primitive: less than [`BOX_MARGIN`]. Nor are infinite
/// planes met so far away that nothing is known of the place.
pub const LEAST_SINE: f64 = 4e-7;

/// Points of a polygon may be off its plane by this share of the polygon's size: files round to about six digits.
pub const POLYGON_FLATNESS: f64 = 1e-3;

/// Corners of a face may be off its plane by this share of its size. Polygons within [`POLYGON_FLATNESS`] that are not as
/// flat are cut into triangles: rays nearly along them would be hit far from where their outline is (see [`LEAST_SINE`]).
pub const FACE_FLATNESS: f64 = 2e-13;

/// Facets of a mesh without normals belong to one surface if their normals differ by less (in radians).
pub const FACET_ANGLE: f64 = 1e-6;

/// Boxes in the BVH grow by this share of the whole scene's size on each side: far more than the rounding of any
/// hit, far less than anything seen.
pub const BOX_MARGIN: f64 = 1e-6;

/// Depths and projected outlines are widened by this share (of the distance, and of a sample) when they only serve
/// to leave out what cannot be seen.
pub const PROJECTION_MARGIN: f64 = 1e-6;

/// Hits beyond this distance (in units of the ray's direction) do not count. Finite, so that bounds can tell.
pub const FARTHEST: f64 = 1e300;

/// Distances along a grid's walk are taken shorter by this share, more than their rounding.
pub const WALK_MARGIN: f64 = 1e-9;

/// Rounding of coordinates relative to their magnitude, generously.
pub const COORDINATE_ROUNDING: f64 = 1e-12;
