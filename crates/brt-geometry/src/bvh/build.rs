//! Building the tree. The only file that names obvhs.

use std::time::Duration;

use obvhs::BvhBuildParams;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::build_bvh2;

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
        let binary = build_bvh2(&rounded, parameters(most_per_leaf), &mut Duration::default());
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
                    Child { first: (self.nodes.len() - 1) as u32, count: 0 }
                };
            }
        }
    }
}

fn parameters(most_per_leaf: u32) -> BvhBuildParams {
    BvhBuildParams { max_prims_per_leaf: most_per_leaf, ..BvhBuildParams::medium_build() }
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
