//! Geometry: numbers, vectors, primitives, and the tree that finds them.
//!
//! Every predicate (hit, order, inside) stands here once, generic over [`Real`].
//!
//! Every constant that a proof rests on stands on one page, with its inequality (`margins.rs`). A ray that leaves a primitive
//! skips the root at its origin instead of an epsilon.

mod aabb;
mod affine;
mod bvh;
mod extents;
mod grid;
mod index;
mod lanes;
mod margins;
mod numbers;
mod primitives;
mod ray;
mod ray_block;
mod ray_shaft;
mod shaft;
mod taylor;
mod triangulate;
mod trilean;

pub use aabb::Aabb;
pub use affine::Affine;
pub use bvh::{Bvh, Traversal};
pub use extents::Extents;
pub use grid::Grid;
pub use index::SpatialIndex;
pub use lanes::{LANES, LaneMask, Lanes, SimdLevel, UnknownSimdLevel};
pub use margins::{
    BOX_MARGIN, COORDINATE_ROUNDING, FACE_FLATNESS, FACET_ANGLE, FARTHEST, LEAST_SINE, Margin,
    POLYGON_FLATNESS, SMALLEST_ANGLE, SMALLEST_LENGTH,
};
pub use numbers::{Across, Exponent, Mask, Real, Vec3, vec3};
pub use primitives::{
    Cone, Cylinder, Disc, Plane, Polygon, PolygonPlane, Primitive, Sphere, Triangle, area_share,
    polygon_plane,
};
pub use ray::{Hit, Ray, Start};
pub use ray_block::RayBlock;
pub use ray_shaft::LaneRays;
pub use shaft::Shaft;
pub use taylor::Taylor;
pub use triangulate::{is_convex, triangulate};
pub use trilean::Trilean;
