//! Extents: a bounding sphere around each object, tested before its primitives (Whitted 1980, §4). Paper: P1.

use crate::{Aabb, BOX_MARGIN, Ray, Traversal, Vec3};

/// Bounding spheres over groups of items.
#[derive(Clone, Debug, Default)]
pub struct Extents {
    spheres: Vec<Extent>,
    items: Vec<u32>,
}

#[derive(Clone, Debug)]
struct Extent {
    center: Vec3,
    radius: f64,
    first: usize,
    count: usize,
}

impl Extents {
    /// A sphere around each run of boxes with the same group; every box comes with its item and group.
    pub fn build(boxes: &[(u32, Aabb)], group_of: impl Fn(u32) -> usize) -> Self {
        let mut extents = Self { spheres: Vec::new(), items: boxes.iter().map(|b| b.0).collect() };
        let whole = boxes.iter().map(|b| b.1).reduce(Aabb::union);
        let margin = whole.map_or(0.0, |b| BOX_MARGIN * (b.hi - b.lo).length());
        let mut first = 0;
        for run in boxes.chunk_by(|a, b| group_of(a.0) == group_of(b.0)) {
            let around = run.iter().map(|b| b.1).reduce(Aabb::union).unwrap_or(run[0].1);
            let radius = 0.5 * (around.hi - around.lo).length() + margin;
            let center = (around.lo + around.hi) * 0.5;
            extents.spheres.push(Extent { center, radius, first, count: run.len() });
            first += run.len();
        }
        extents
    }

    /// Visits items whose spheres the ray touches before `t_max`; `visit` returns the new `t_max`.
    pub fn closest(&self, ray: &Ray, t_max: f64, walk: &mut Traversal, mut visit: impl FnMut(u32) -> f64) {
        let mut limit = t_max;
        for extent in &self.spheres {
            walk.nodes_visited += 1;
            if extent.is_touched(ray, limit) {
                for &item in self.items_of(extent) {
                    limit = visit(item);
                }
            }
        }
    }

    /// Visits items whose spheres the ray touches before `t_max` until `visit` says true; returns whether it did.
    pub fn any(
        &self,
        ray: &Ray,
        t_max: f64,
        walk: &mut Traversal,
        mut visit: impl FnMut(u32) -> bool,
    ) -> bool {
        self.spheres.iter().any(|extent| {
            walk.nodes_visited += 1;
            extent.is_touched(ray, t_max) && self.items_of(extent).iter().any(|&item| visit(item))
        })
    }

    fn items_of(&self, extent: &Extent) -> &[u32] {
        &self.items[extent.first..extent.first + extent.count]
    }
}

impl Extent {
    /// Does the ray come as near to the centre as the radius, not beyond `t_max`? The radius has a margin for rounding.
    #[inline(always)]
    fn is_touched(&self, ray: &Ray, t_max: f64) -> bool {
        let to_center = self.center - ray.origin;
        let along = to_center.dot(ray.direction) * ray.inv_dd;
        let nearest = along.clamp(0.0, t_max);
        let off = to_center - ray.direction * nearest;
        // Of a point far away even a small share is more than the margin.
        let radius = self.radius + BOX_MARGIN * (to_center.x.abs() + to_center.y.abs() + to_center.z.abs());
        off.length_squared() <= radius * radius
    }
}
