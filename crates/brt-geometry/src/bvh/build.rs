//! Building the tree.

use obvhs::BvhBuildParams;
use obvhs::bvh2::leaf_collapser::collapse;
use obvhs::bvh2::reinsertion::ReinsertionOptimizer;
use obvhs::bvh2::{Bvh2, DEFAULT_MAX_STACK_DEPTH};

use super::ploc::cluster;
use super::{Bvh, Child, Node};
use crate::{Aabb, BOX_MARGIN, Vec3};

impl Bvh {
    /// The tree over boxes with their items, which walks hand out, so many of them at most together.
    pub fn build(boxes: &[(u32, Aabb)], most_per_leaf: u32) -> Self {
        let whole = boxes.iter().map(|b| b.1).reduce(Aabb::union);
        let Some(whole) = whole else {
            return Self { nodes: vec![Node::EMPTY], items: Vec::new(), center: Vec3::ZERO, reach: 0.0 };
        };
        let center = (whole.lo + whole.hi) * 0.5;
        let size = whole.hi - whole.lo;
        let margin = BOX_MARGIN * size.x.max(size.y).max(size.z);
        let rounded: Vec<obvhs::aabb::Aabb> =
            boxes.iter().map(|(_, b)| round_outward(b, center, margin)).collect();
        let uneven: Vec<obvhs::aabb::Aabb> =
            (0_u64..).zip(&rounded).map(|(i, bounds)| uneven(bounds, i)).collect();
        let mut binary = binary_tree(&uneven, most_per_leaf);
        refit(&mut binary, &rounded);
        let items = binary.primitive_indices.iter().map(|&i| boxes[i as usize].0).collect();
        let reach = (0.5 * size.x.max(size.y).max(size.z) + 2.0 * margin) as f32 * 1.001;
        let mut tree = Self { nodes: Vec::new(), items, center, reach };
        tree.fold(&binary);
        tree
    }

    /// Folds two levels of the binary tree into one.
    fn fold(&mut self, binary: &Bvh2) {
        self.nodes.push(Node::EMPTY);
        // (node of the binary tree, where its children go)
        let mut open = vec![(0_u32, 0_usize)];
        while let Some((source, target)) = open.pop() {
            for (slot, below) in children_of(binary, source).into_iter().enumerate() {
                let node = &binary.nodes[below as usize];
                let bounds = node.aabb();
                for axis in 0..3 {
                    self.nodes[target].planes[0][axis].as_mut_array()[slot] = bounds.min[axis];
                    self.nodes[target].planes[1][axis].as_mut_array()[slot] = bounds.max[axis];
                }
                self.nodes[target].child[slot] = if node.is_leaf() {
                    Child { first: node.first_index, count: node.prim_count }
                } else {
                    self.nodes.push(Node::EMPTY);
                    open.push((below, self.nodes.len() - 1));
                    Child::inner((self.nodes.len() - 1) as u32)
                };
            }
        }
    }
}

/// The box, grown by a small part of its size that differs from item to item.
///
/// PLOC joins two nodes only where each is the other's nearest neighbour, and of equally near ones it takes the first: in an
/// evenly spaced row all would look to the same side, and a pass would join but one pair. Uneven boxes have no equally near
/// neighbours. They only decide which nodes are joined: the tree is [`refit`] to the boxes themselves.
fn uneven(bounds: &obvhs::aabb::Aabb, index: u64) -> obvhs::aabb::Aabb {
    let size = bounds.max - bounds.min;
    let growth = size.x.max(size.y).max(size.z) * MOST_GROWTH * share_of(index);
    obvhs::aabb::Aabb { min: bounds.min - growth, max: bounds.max + growth }
}

/// How much of its size a box grows by at most: enough to tell boxes apart in single precision, too little to matter for
/// what is near.
const MOST_GROWTH: f32 = 1.0 / 64.0;

/// A number from 0 to 1 that looks random (the finalizer of SplitMix64: Steele, Lea, Flood 2014).
fn share_of(index: u64) -> f32 {
    let x = index.wrapping_add(1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    let x = (x ^ (x >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let x = (x ^ (x >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    ((x ^ (x >> 31)) >> 40) as f32 / (1_u32 << 24) as f32
}

/// Gives the nodes the smallest boxes around their items.
fn refit(binary: &mut Bvh2, boxes: &[obvhs::aabb::Aabb]) {
    let Bvh2 { nodes, primitive_indices, .. } = binary;
    for leaf in nodes.iter_mut().filter(|node| node.is_leaf()) {
        let first = leaf.first_index as usize;
        let items = &primitive_indices[first..first + leaf.prim_count as usize];
        let around = items.iter().map(|&i| boxes[i as usize]).reduce(|a, b| a.union(&b));
        leaf.set_aabb(around.unwrap_or(obvhs::aabb::Aabb::empty()));
    }
    binary.refit_all();
}

/// Mean of the inner nodes' areas, as a share of the whole's, beyond which boxes lie in each other more than side by side.
const LARGE_NODES: f32 = 1.0 / 16.0;

fn mean_size(tree: &Bvh2) -> f32 {
    let inner = tree.nodes.iter().filter(|node| !node.is_leaf()).map(|node| node.aabb().half_area());
    inner.sum::<f32>() / (tree.nodes.len() as f32 * 0.5 * tree.nodes[0].aabb().half_area())
}

/// Clusters, with parts put where they fit better (Meister, Bittner: *Parallel reinsertion for bounding volume hierarchy
/// optimization*, CGF 37 (2), 2018), and leaves joined where testing their items costs less than entering nodes.
fn binary_tree(boxes: &[obvhs::aabb::Aabb], most_per_leaf: u32) -> Bvh2 {
    let BvhBuildParams {
        reinsertion_batch_ratio: ratio,
        post_collapse_reinsertion_batch_ratio_multiplier: further,
        collapse_traversal_cost,
        ..
    } = BvhBuildParams::medium_build();
    let mut tree = cluster(boxes);
    // In chains of nested boxes parts may wander deeper than the optimizer keeps count of; and where most nodes are nearly as
    // large as the whole, it looks at most of the tree for each part that it moves, and finds no better place.
    let is_hopeless = tree.max_depth > DEFAULT_MAX_STACK_DEPTH / 2 || mean_size(&tree) > LARGE_NODES;
    tree.max_depth = tree.max_depth.max(DEFAULT_MAX_STACK_DEPTH);
    let mut optimizer = ReinsertionOptimizer::default();
    if !is_hopeless {
        optimizer.run(&mut tree, ratio, None);
    }
    collapse(&mut tree, most_per_leaf.clamp(1, 255), collapse_traversal_cost);
    if !is_hopeless {
        optimizer.run(&mut tree, ratio * further, None);
    }
    tree
}

/// Up to four descendants of a node of the binary tree: the widest boxes are opened first.
fn children_of(binary: &Bvh2, source: u32) -> Vec<u32> {
    let mut children = vec![source];
    while children.len() < 4 {
        let widest = (0..children.len())
            .filter(|&i| !binary.nodes[children[i] as usize].is_leaf())
            .max_by(|&i, &j| area(binary, children[i]).total_cmp(&area(binary, children[j])));
        let Some(widest) = widest else { break };
        let first = binary.nodes[children[widest] as usize].first_index;
        children[widest] = first;
        children.push(first + 1);
    }
    children
}

fn area(binary: &Bvh2, node: u32) -> f32 {
    binary.nodes[node as usize].aabb().half_area()
}

fn round_outward(bounds: &Aabb, center: Vec3, margin: f64) -> obvhs::aabb::Aabb {
    let margin = Vec3::splat(margin);
    let (lo, hi) = (bounds.lo - center - margin, bounds.hi - center + margin);
    let down = |x: f64| (x as f32).next_down();
    let up = |x: f64| (x as f32).next_up();
    obvhs::aabb::Aabb::new([down(lo.x), down(lo.y), down(lo.z)].into(), [up(hi.x), up(hi.y), up(hi.z)].into())
}
