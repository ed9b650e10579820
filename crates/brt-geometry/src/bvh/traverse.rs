//! Walking the tree along a ray.
//!
//! A node's slabs are tested in `f32`, four children at once. No box is left out that the exact ray touches, nor one that a
//! hit may lie beside by rounding: the ray's origin is rounded both ways by [`BOX_MARGIN`] of its distance, and distances are
//! widened by [`TREE_SLACK`]. Rays from far outside are first moved to where they enter the tree, in `f64`: single precision
//! could not hold where they start.

use wide::f32x4;

use super::{ALL_CHILDREN, Bvh, Child, Node, Open, push_sorted};
use crate::margins::{BOX_MARGIN, TREE_SLACK};
use crate::{Ray, Vec3};

/// Working memory of a walk, kept to spare allocations, and its count of nodes.
#[derive(Clone, Debug, Default)]
pub struct Traversal {
    pub(super) stack: Open,
    /// Nodes visited by all walks so far.
    pub nodes_visited: u64,
}

const SLACK: f32 = TREE_SLACK as f32;

/// Rays that start farther outside than this, in units of the tree's reach, are moved to where they enter it. Nothing rests on
/// it: their margin grows with their distance, and would be as large as the tree.
const FAR_OUTSIDE: f64 = 4.0;

impl Bvh {
    /// Visits items whose boxes the ray touches before `t_max`, near boxes first.
    ///
    /// `visit` gets an item and returns the new `t_max`.
    #[inline(always)]
    pub fn closest(&self, ray: &Ray, t_max: f64, walk: &mut Traversal, mut visit: impl FnMut(u32) -> f64) {
        if self.items.is_empty() {
            return;
        }
        let Some(rounded) = RoundedRay::new(ray, self) else { return };
        let mut limit = rounded.limit(t_max);
        walk.stack.clear();
        walk.stack.push((Child::ROOT, 0.0));
        while let Some((child, near)) = walk.stack.pop() {
            if near > limit {
                continue;
            }
            if child.is_inner() {
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
        let Some(rounded) = RoundedRay::new(ray, self) else { return false };
        let limit = rounded.limit(t_max);
        walk.stack.clear();
        walk.stack.push((Child::ROOT, 0.0));
        while let Some((child, _)) = walk.stack.pop() {
            if child.is_inner() {
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
    /// How far the origin was moved along the ray, in units of the ray's direction.
    moved: f64,
}

impl RoundedRay {
    /// `None` where the ray passes the whole tree by.
    #[inline(always)]
    fn new(ray: &Ray, tree: &Bvh) -> Option<Self> {
        let d = ray.direction;
        let scale = d.x.abs().max(d.y.abs()).max(d.z.abs());
        let inverse_scale = 1.0 / scale;
        let mut origin = ray.origin - tree.center;
        let distance = origin.x.abs() + origin.y.abs() + origin.z.abs();
        // Half of it for hits beside the ray. The other half is more than what rounding to `f32` adds, 2⁻²⁴ of a
        // coordinate.
        let margin = 2.0 * BOX_MARGIN * distance;
        let mut moved = 0.0;
        if distance > FAR_OUTSIDE * f64::from(tree.reach) {
            moved = tree.entered_at(origin, d, margin)?;
            origin = origin + d * moved;
        }
        let mut rounded = Self {
            near_side: [0; 3],
            origin_near: [0.0; 3],
            origin_far: [0.0; 3],
            inverse: [0.0; 3],
            scale,
            moved,
        };
        for axis in 0..3 {
            let (down, up) = ((origin[axis] - margin) as f32, (origin[axis] + margin) as f32);
            let backward = d[axis] < 0.0;
            rounded.near_side[axis] = usize::from(backward);
            rounded.origin_near[axis] = if backward { down } else { up };
            rounded.origin_far[axis] = if backward { up } else { down };
            // Never infinite, for 0·∞ is NaN. A ray along a slab is so taken as almost along it; the boxes' margin is
            // far more than what it drifts.
            let inverse = 1.0 / ((d[axis].abs() * inverse_scale) as f32).max(f32::MIN_POSITIVE);
            rounded.inverse[axis] = if backward { -inverse } else { inverse };
        }
        Some(rounded)
    }

    /// A distance in units of the ray's direction as a bound on ours, rounded up.
    #[inline(always)]
    fn limit(&self, t: f64) -> f32 {
        (((t - self.moved) * self.scale) as f32) * (1.0 + SLACK)
    }

    /// Puts the children that may be touched before `limit` on the stack, the nearest last: all but those that certainly
    /// are not, so what is not a number counts as touched.
    #[inline(always)]
    fn push_children(&self, node: &Node, limit: f32, stack: &mut Open) {
        let (mut near, mut far) = (f32x4::ZERO, f32x4::splat(limit));
        for axis in 0..3 {
            let side = self.near_side[axis];
            let inverse = f32x4::splat(self.inverse[axis]);
            let enter = node.planes[side][axis] - f32x4::splat(self.origin_near[axis]);
            let leave = node.planes[1 - side][axis] - f32x4::splat(self.origin_far[axis]);
            // Of NaN and a number these give either: the number is as if this axis said nothing, NaN is touched.
            near = (enter * inverse * f32x4::splat(1.0 - SLACK)).fast_max(near);
            far = (leave * inverse * f32x4::splat(1.0 + SLACK)).fast_min(far);
        }
        let touched = !near.simd_gt(far).to_bitmask() & ALL_CHILDREN;
        push_sorted(stack, node, touched, near.to_array());
    }
}

impl Bvh {
    /// Where a ray from outside enters the box around the whole tree, grown by a margin; `None` where it certainly does not.
    #[cold]
    fn entered_at(&self, origin: Vec3, direction: Vec3, margin: f64) -> Option<f64> {
        let half = f64::from(self.reach) + margin;
        let (mut enter, mut leave) = (0.0_f64, f64::INFINITY);
        for axis in 0..3 {
            let inverse = 1.0 / direction[axis];
            let (a, b) = ((-half - origin[axis]) * inverse, (half - origin[axis]) * inverse);
            // Of NaN and a number these take the number: such an axis says nothing.
            enter = enter.max(a.min(b));
            leave = leave.min(a.max(b));
        }
        (enter <= leave).then_some(enter)
    }
}
