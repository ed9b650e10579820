//! Spatial indices: which primitives may a ray meet?

use crate::{Bvh, Extents, Grid, Ray, Traversal};

/// One of the structures that save tests of primitives.
#[derive(Clone, Debug)]
pub enum SpatialIndex {
    /// None: every item is visited.
    Everything(Vec<u32>),
    /// Bounding spheres.
    Extents(Extents),
    /// A uniform grid.
    Grid(Grid),
    /// A bounding volume hierarchy.
    Bvh(Bvh),
}

impl SpatialIndex {
    /// Visits items that the ray may meet before `t_max`; `visit` gets an item and returns the new `t_max`.
    #[inline(always)]
    pub fn closest(&self, ray: &Ray, t_max: f64, walk: &mut Traversal, mut visit: impl FnMut(u32) -> f64) {
        match self {
            Self::Bvh(bvh) => bvh.closest(ray, t_max, walk, visit),
            Self::Grid(grid) => grid.closest(ray, t_max, walk, visit),
            Self::Extents(extents) => extents.closest(ray, t_max, walk, visit),
            Self::Everything(items) => items.iter().for_each(|&item| {
                visit(item);
            }),
        }
    }

    /// Visits items that the ray may meet before `t_max` until `visit` says true; returns whether it did.
    #[inline(always)]
    pub fn any(
        &self,
        ray: &Ray,
        t_max: f64,
        walk: &mut Traversal,
        mut visit: impl FnMut(u32) -> bool,
    ) -> bool {
        match self {
            Self::Bvh(bvh) => bvh.any(ray, t_max, walk, visit),
            Self::Grid(grid) => grid.any(ray, t_max, walk, visit),
            Self::Extents(extents) => extents.any(ray, t_max, walk, visit),
            Self::Everything(items) => items.iter().any(|&item| visit(item)),
        }
    }
}
