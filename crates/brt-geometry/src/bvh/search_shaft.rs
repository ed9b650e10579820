//! Which boxes does a shaft touch?

use std::ops::ControlFlow;

use wide::f32x4;

use super::{ALL_CHILDREN, Bvh, Child, Node, Traversal, push_sorted};
use crate::{
    Shaft,
    margins::{OFFSET_ROUNDINGS, SHAFT_SLACK},
    shaft::{HalfSpace, MOST_FACES},
};

impl Bvh {
    /// Visits items whose boxes the shaft may touch until `visit` says false; returns whether it never did.
    pub fn touched_by(&self, shaft: &Shaft, mut visit: impl FnMut(u32) -> bool) -> bool {
        if self.items.is_empty() {
            return true;
        }
        let faces: [Option<RoundedFace>; MOST_FACES] =
            std::array::from_fn(|i| shaft.faces().get(i).map(|face| self.rounded(face)));
        let mut open = vec![Child::ROOT];
        while let Some(child) = open.pop() {
            if !child.is_inner() {
                if !self.leaf(child).iter().all(|&item| visit(item)) {
                    return false;
                }
                continue;
            }
            let node = &self.nodes[child.first as usize];
            let touched =
                faces.iter().flatten().fold(ALL_CHILDREN, |left, face| left & face.touched_children(node));
            open.extend((0..4).filter(|lane| touched >> lane & 1 == 1).map(|lane| node.child[lane]));
        }
        true
    }

    /// Visits items whose boxes the shaft may touch, near ones first.
    ///
    /// `visit` gets an item and says whether to go on: with all that begins no farther than this, measured along the
    /// shaft's [axis](Shaft::axis) from the scene's origin.
    pub fn touched_in_order(
        &self,
        shaft: &Shaft,
        walk: &mut Traversal,
        mut visit: impl FnMut(u32) -> ControlFlow<(), f64>,
    ) {
        if self.items.is_empty() {
            return;
        }
        let faces: [Option<RoundedFace>; MOST_FACES] =
            std::array::from_fn(|i| shaft.faces().get(i).map(|face| self.rounded(face)));
        let along =
            |limit: f64| self.rounded(&HalfSpace { normal: shaft.axis(), offset: limit + shaft.margin() });
        let mut end = along(f64::INFINITY);
        walk.stack.clear();
        walk.stack.push((Child::ROOT, f32::NEG_INFINITY));
        while let Some((child, near)) = walk.stack.pop() {
            if near > end.limit() {
                continue;
            }
            if !child.is_inner() {
                for &item in self.leaf(child) {
                    match visit(item) {
                        ControlFlow::Break(()) => return,
                        ControlFlow::Continue(limit) if limit < f64::INFINITY => end = along(limit),
                        ControlFlow::Continue(_) => {}
                    }
                }
                continue;
            }
            walk.nodes_visited += 1;
            let node = &self.nodes[child.first as usize];
            let near = end.deepest(node);
            let touched = faces
                .iter()
                .flatten()
                .fold(end.touched_children(node), |left, face| left & face.touched_children(node));
            push_sorted(&mut walk.stack, node, touched, near.to_array());
        }
    }

    fn rounded(&self, face: &HalfSpace) -> RoundedFace {
        // To unit size, so that single precision neither under- nor overflows.
        let n = face.normal;
        let scale = 1.0 / n.x.abs().max(n.y.abs()).max(n.z.abs());
        let offset = (face.offset - n.dot(self.center)) * scale;
        let rounding = OFFSET_ROUNDINGS * (face.offset.abs() + (n.length() * self.center.length())) * scale;
        let normal = [n.x * scale, n.y * scale, n.z * scale].map(|x| x as f32);
        let slack = SHAFT_SLACK as f32 * 3.0 * self.reach;
        let offset = ((offset + rounding) as f32).next_up();
        RoundedFace {
            normal: normal.map(f32x4::splat),
            far_side: normal.map(|x| usize::from(x < 0.0)),
            offset: f32x4::splat(offset + slack),
        }
    }
}

/// A half-space in the tree's coordinates.
struct RoundedFace {
    normal: [f32x4; 3],
    /// Which planes of a box lie deepest inside.
    far_side: [usize; 3],
    offset: f32x4,
}

impl RoundedFace {
    /// Bits of the children that may reach into the half-space: all but those that are certainly outside, so what is not a
    /// number counts as touched.
    #[inline(always)]
    fn touched_children(&self, node: &Node) -> u32 {
        !self.deepest(node).simd_gt(self.offset).to_bitmask() & ALL_CHILDREN
    }

    /// How deep inside the children's boxes reach.
    #[inline(always)]
    fn deepest(&self, node: &Node) -> f32x4 {
        let product = |axis: usize| node.planes[self.far_side[axis]][axis] * self.normal[axis];
        product(0) + product(1) + product(2)
    }

    fn limit(&self) -> f32 {
        self.offset.to_array()[0]
    }
}
