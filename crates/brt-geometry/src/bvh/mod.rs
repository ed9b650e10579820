//! A tree of boxes with four children a node.
//!
//! A binary tree over boxes rounded outward to `f32` ([`ploc`]; Meister, Bittner 2018), which obvhs improves by reinsertion,
//! is folded by [`build`] into nodes of four. Traversal is ours, because obvhs's rays are `f32` and lose hits: here a
//! node is entered whenever an exact ray could touch it, and the primitives decide in `f64`.

mod build;
mod ploc;
mod search_shaft;
mod traverse;

pub use traverse::Traversal;

use wide::f32x4;

use crate::Vec3;

/// A bounding volume hierarchy over boxes with indices.
#[derive(Clone, Debug)]
pub struct Bvh {
    nodes: Vec<Node>,
    /// Indices of the boxes, leaf by leaf.
    items: Vec<u32>,
    /// Node coordinates are relative to this point, so that scenes far from the origin lose no precision.
    center: Vec3,
    /// No coordinate of a node is greater.
    reach: f32,
}

/// Four children side by side, so that one instruction serves all of them.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
struct Node {
    /// Lower and upper planes of the children's boxes: `planes[side][axis][child]`.
    planes: [[f32x4; 3]; 2],
    child: [Child; 4],
}

/// What hangs below: the inner node `first`, or a leaf of `count` items from `first`.
///
/// Where nothing hangs below, it is a leaf without items. So a walk ends whatever it enters, even one whose numbers are
/// not numbers and which enters everything.
#[derive(Clone, Copy, Debug)]
struct Child {
    first: u32,
    count: u32,
}

impl Child {
    const ROOT: Self = Self::inner(0);
    const EMPTY: Self = Self { first: 0, count: 0 };

    const fn inner(node: u32) -> Self {
        Self { first: node, count: u32::MAX }
    }

    #[inline(always)]
    fn is_inner(self) -> bool {
        self.count == u32::MAX
    }
}

/// Bits of all children of a node.
const ALL_CHILDREN: u32 = 0b1111;

/// Children on their way to be visited, the next one last, with the distance where each begins.
type Open = Vec<(Child, f32)>;

/// Adds the children of these bits, the nearest last.
#[inline(always)]
fn push_sorted(open: &mut Open, node: &Node, touched: u32, near: [f32; 4]) {
    let start = open.len();
    for lane in (0..4).filter(|lane| touched >> lane & 1 == 1) {
        let mut at = open.len();
        open.push((node.child[lane], near[lane]));
        while at > start && open[at - 1].1 < near[lane] {
            open.swap(at - 1, at);
            at -= 1;
        }
    }
}

impl Node {
    const EMPTY: Self = Self {
        planes: [[f32x4::splat(f32::INFINITY); 3], [f32x4::splat(f32::NEG_INFINITY); 3]],
        child: [Child::EMPTY; 4],
    };
}
