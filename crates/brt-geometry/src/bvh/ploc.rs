//! A binary tree by parallel locally-ordered clustering (Meister, Bittner: *Parallel locally-ordered clustering for bounding
//! volume hierarchy construction*, IEEE TVCG 24 (3), 2018).
//!
//! Clusters stand along a Morton curve. In each pass every cluster looks for the neighbour with which it makes the smallest
//! box, and those that choose each other are joined. In nested or steadily shrinking boxes all choose the next smaller one,
//! so that a pass joins but one pair, and time grows with the square of their number. Where a pass joins too few, neighbours
//! are joined two by two instead: such a tree could not be a good one anyway.

use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::node::Bvh2Node;
use obvhs::ploc::morton::morton_encode_u64;
use rayon::prelude::*;

/// How many neighbours to each side are looked at.
const REACH: usize = 14;

/// Only the next ones in the first passes, which have the most clusters.
const SHORT_PASSES: usize = 3;

/// A pass that joins fewer than one in so many clusters is not worth its time.
const FEWEST_JOINED: usize = 32;

/// Clusters whose costs are computed together: they stay in the cache.
const PORTION: usize = 2048;

/// A binary tree with an item in each leaf; `max_depth` says how deep it is at most.
pub(super) fn cluster(boxes: &[Aabb]) -> Bvh2 {
    let mut tree = Bvh2::zeroed(boxes.len());
    tree.primitive_indices = (0..boxes.len() as u32).collect();
    let mut clusters = along_curve(boxes);
    let (mut next, mut partners) = (Vec::new(), vec![0; boxes.len()]);
    // Children go to the end of the nodes first: they stand behind their parents.
    let mut free = tree.nodes.len();
    let mut passes = 0;
    while clusters.len() > 1 {
        let reach = if passes < SHORT_PASSES { 1 } else { REACH };
        partners.truncate(clusters.len());
        find_partners(&clusters, reach, &mut partners);
        let is_joined = |&i: &usize| partners[i] != i && partners[partners[i]] == i;
        let joined = (0..clusters.len()).filter(is_joined).count() / 2;
        if joined * FEWEST_JOINED < clusters.len() {
            (0..clusters.len()).for_each(|i| partners[i] = (i ^ 1).min(clusters.len() - 1));
        }
        next.clear();
        for (i, cluster) in clusters.iter().enumerate() {
            let partner = partners[i];
            if partner == i || partners[partner] != i {
                next.push(*cluster);
            } else if partner < i {
                free -= 2;
                (tree.nodes[free], tree.nodes[free + 1]) = (*cluster, clusters[partner]);
                let around = cluster.aabb().union(clusters[partner].aabb());
                next.push(Bvh2Node::new(around, 0, free as u32));
            }
        }
        std::mem::swap(&mut clusters, &mut next);
        passes += 1;
    }
    tree.nodes[0] = clusters[0];
    tree.max_depth = passes + 1;
    tree.children_are_ordered_after_parents = true;
    tree
}

/// A leaf for each box, in the order of their middles on a Morton curve of 2²¹ places along each axis.
fn along_curve(boxes: &[Aabb]) -> Vec<Bvh2Node> {
    let mut whole = Aabb::empty();
    boxes.iter().for_each(|b| whole = whole.union(b));
    let place = |b: &Aabb| {
        let axis = |axis: usize| {
            let (lo, hi) = (f64::from(whole.min[axis]), f64::from(whole.max[axis]));
            let scale = 1.0 / (hi - lo);
            // Where there is no extent this is not a number, which becomes 0.
            ((f64::from(b.center_axis(axis)) * scale - lo * scale) * f64::from(1 << 21)) as u32
        };
        morton_encode_u64(axis(0), axis(1), axis(2))
    };
    let mut places: Vec<(u64, u32)> =
        boxes.par_iter().enumerate().map(|(i, b)| (place(b), i as u32)).collect();
    places.par_sort_unstable();
    places.iter().map(|&(_, i)| Bvh2Node::new(boxes[i as usize], 1, i)).collect()
}

/// For each cluster the one that it would best be joined with; of equally good ones the last.
fn find_partners(clusters: &[Bvh2Node], reach: usize, partners: &mut [usize]) {
    partners.par_chunks_mut(PORTION).enumerate().for_each_init(
        Costs::default,
        |costs, (portion, partners)| {
            let begin = portion * PORTION;
            let first = begin.saturating_sub(reach);
            costs.measure(clusters, first, begin + partners.len(), reach);
            for (i, partner) in (begin..).zip(partners) {
                *partner = costs.best(i, first, clusters.len(), reach);
            }
        },
    );
}

/// Half the areas of the boxes around pairs of clusters.
#[derive(Default)]
struct Costs {
    /// Of each cluster of a portion with the one that comes so many, and one, later.
    with_later: [Vec<f32>; REACH],
}

impl Costs {
    fn measure(&mut self, clusters: &[Bvh2Node], first: usize, end: usize, reach: usize) {
        for (k, costs) in (1..=reach).zip(&mut self.with_later) {
            costs.clear();
            let earlier = &clusters[first..end];
            let later = &clusters[(first + k).min(clusters.len())..];
            costs.extend(earlier.iter().zip(later).map(|(a, b)| a.aabb().union(b.aabb()).half_area()));
        }
    }

    fn best(&self, i: usize, first: usize, count: usize, reach: usize) -> usize {
        let (mut partner, mut least) = (i, f32::INFINITY);
        let mut consider = |other: usize, cost: f32| {
            if cost <= least {
                (partner, least) = (other, cost);
            }
        };
        for k in (1..=reach.min(i - first)).rev() {
            consider(i - k, self.with_later[k - 1][i - k - first]);
        }
        for k in 1..=reach.min(count - 1 - i) {
            consider(i + k, self.with_later[k - 1][i - first]);
        }
        partner
    }
}
