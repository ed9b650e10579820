//! Walking the tree along a ray.
//!
//! A node's slabs are tested in `f32`, four children at once. The ray's origin is rounded both ways and distances are
//! widened by [`SLACK`], so that no box is left out that the exact ray touches.

use wide::f32x4;

use super::{Bvh, Child, Node, Open, push_sorted};
use crate::{Ray, Vec3};

/// Working memory of a walk, kept to spare allocations, and its count of nodes.
#[derive(Clone, Debug, Default)]
pub struct Traversal {
    pub(super) stack: Open,
    /// Nodes visited by all walks so far.
    pub nodes_visited: u64,
}

/// Six roundings of 2⁻²⁴ at most lie between the exact distance to a plane and ours.
const SLACK: f32 = 1.0 / (1 << 21) as f32;

impl Bvh {
    /// Visits items whose boxes the ray touches before `t_max`, near boxes first.
    ///
    /// `visit` gets an item and returns the new `t_max`.
    #[inline(always)]
    pub fn closest(&self, ray: &Ray, t_max: f64, walk: &mut Traversal, mut visit: impl FnMut(u32) -> f64) {
        if self.items.is_empty() {
            return;
        }
        let rounded = RoundedRay::new(ray, self.center);
        let mut limit = rounded.limit(t_max);
        walk.stack.clear();
        walk.stack.push((Child { first: 0, count: 0 }, 0.0));
        while let Some((child, near)) = walk.stack.pop() {
            if near > limit {
                continue;
            }
            if child.count == 0 {
                walk.nodes_visited += 1;
                rounded.push_children(&self.nodes[child.first as usize], limit, &mut walk.stack);
                continue;
            }
            for &item in self.leaf(child) {
                limit = limit.min(rounded.limit(visit(item)));
            }
        }
    }

    /// Visits items whose boxes the ray touches before `t_max` until `visit` says true; returns whether it did.
    #[inline(always)]
    pub fn any(
        &self,
        ray: &Ray,
        t_max: f64,
        walk: &mut Traversal,
        mut visit: impl FnMut(u32) -> bool,
    ) -> bool {
        if self.items.is_empty() {
            return false;
        }
        let rounded = RoundedRay::new(ray, self.center);
        let limit = rounded.limit(t_max);
        walk.stack.clear();
        walk.stack.push((Child { first: 0, count: 0 }, 0.0));
        while let Some((child, _)) = walk.stack.pop() {
            if child.count == 0 {
                walk.nodes_visited += 1;
                rounded.push_children(&self.nodes[child.first as usize], limit, &mut walk.stack);
            } else if self.leaf(child).iter().any(|&item| visit(item)) {
                return true;
            }
        }
        false
    }

    #[inline(always)]
    pub(super) fn leaf(&self, child: Child) -> &[u32] {
        &self.items[child.first as usize..(child.first + child.count) as usize]
    }
}

/// A ray in the tree's `f32` coordinates. Distances are in units of the direction's greatest coordinate.
struct RoundedRay {
    /// Which of a node's planes is met first, per axis.
    near_side: [usize; 3],
    /// The origin, rounded such that distances to near planes come out low.
    origin_near: [f32; 3],
    /// The origin, rounded such that distances to far planes come out high.
    origin_far: [f32; 3],
    inverse: [f32; 3],
    scale: f64,
}

impl RoundedRay {
    #[inline(always)]
    fn new(ray: &Ray, center: Vec3) -> Self {
        let d = ray.direction;
        let scale = d.x.abs().max(d.y.abs()).max(d.z.abs());
        let inverse_scale = 1.0 / scale;
        let origin = ray.origin - center;
        let mut rounded =
            Self { near_side: [0; 3], origin_near: [0.0; 3], origin_far: [0.0; 3], inverse: [0.0; 3], scale };
        for axis in 0..3 {
            let o = origin[axis] as f32;
            // An origin that underflows to 0 is off by far less than the boxes' margin.
            let (down, up) = (o - o.abs() * f32::EPSILON, o + o.abs() * f32::EPSILON);
            let backward = d[axis] < 0.0;
            rounded.near_side[axis] = usize::from(backward);
            rounded.origin_near[axis] = if backward { down } else { up };
            rounded.origin_far[axis] = if backward { up } else { down };
            // Never infinite, for 0·∞ is NaN. A ray along a slab is so taken as almost along it; the boxes' margin is
            // far more than what it drifts.
            let inverse = 1.0 / ((d[axis].abs() * inverse_scale) as f32).max(f32::MIN_POSITIVE);
            rounded.inverse[axis] = if backward { -inverse } else { inverse };
        }
        rounded
    }

    /// A distance in units of the ray's direction as a bound on ours, rounded up.
    #[inline(always)]
    fn limit(&self, t: f64) -> f32 {
        ((t * self.scale) as f32) * (1.0 + SLACK)
    }

    /// Puts the children that are touched before `limit` on the stack, the nearest last.
    #[inline(always)]
    fn push_children(&self, node: &Node, limit: f32, stack: &mut Open) {
        let (mut near, mut far) = (f32x4::ZERO, f32x4::splat(limit));
        for axis in 0..3 {
            let side = self.near_side[axis];
            let inverse = f32x4::splat(self.inverse[axis]);
            let enter = node.planes[side][axis] - f32x4::splat(self.origin_near[axis]);
            let leave = node.planes[1 - side][axis] - f32x4::splat(self.origin_far[axis]);
            near = (enter * inverse * f32x4::splat(1.0 - SLACK)).fast_max(near);
            far = (leave * inverse * f32x4::splat(1.0 + SLACK)).fast_min(far);
        }
        let touched = near.simd_le(far).to_bitmask();
        push_sorted(stack, node, touched, near.to_array());
    }
}
