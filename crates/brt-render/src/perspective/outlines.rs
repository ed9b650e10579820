//! Where on the picture a primitive can be at most.

use brt_geometry::{COORDINATE_ROUNDING, Primitive, Vec3};

use crate::margins::PROJECTION_MARGIN;
use crate::prepare::PreparedCamera;
use crate::products::{Area, PreparedScene, SampleGrid};

/// A rectangle of samples that a primitive does not leave, and the least depth at which it is met.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Outline {
    pub(crate) primitive: u32,
    /// First and last sample column and row.
    pub(crate) x: [u32; 2],
    pub(crate) y: [u32; 2],
    /// No hit is nearer than this.
    pub(crate) nearest: f64,
}

impl Outline {
    pub(super) fn meets(&self, area: &Area) -> bool {
        self.x[0] < area.x1 && self.x[1] >= area.x0 && self.y[0] < area.y1 && self.y[1] >= area.y0
    }

    pub(super) fn contains(&self, area: &Area) -> bool {
        self.x[0] <= area.x0 && self.x[1] + 1 >= area.x1 && self.y[0] <= area.y0 && self.y[1] + 1 >= area.y1
    }

    /// The part of an area inside it.
    pub(super) fn clip(&self, area: &Area) -> Option<Area> {
        let part = Area {
            x0: area.x0.max(self.x[0]),
            y0: area.y0.max(self.y[0]),
            x1: area.x1.min(self.x[1] + 1),
            y1: area.y1.min(self.y[1] + 1),
        };
        (part.x0 < part.x1 && part.y0 < part.y1).then_some(part)
    }
}

/// Outlines of all primitives that can be seen in a window.
///
/// They stand in a segment tree over its bands (Bentley 1977): each at the few nodes whose bands together are those that it
/// reaches. Memory grows with the number of outlines and not with how many bands they cross: all of a hall around the eye
/// may cross every one.
pub(crate) struct Outlines {
    outlines: Vec<Outline>,
    /// Positions in `outlines`, node after node, in their order at each.
    at_nodes: Vec<u32>,
    /// Where each node's part of `at_nodes` starts; one more at the end. Node 1 is the root, 2·n and 2·n + 1 are the halves of
    /// n, and the leaf of the first band is node `leaves`.
    starts: Vec<usize>,
    leaves: usize,
}

/// Outlines of one band, by tile.
pub(crate) struct BandOutlines {
    outlines: Vec<Outline>,
    starts: Vec<usize>,
}

impl Outlines {
    /// Projects all primitives.
    pub(crate) fn new(scene: &PreparedScene, camera: &PreparedCamera, grid: &SampleGrid) -> Self {
        let outlines: Vec<Outline> = (0_u32..)
            .zip(&scene.primitives)
            .filter_map(|(id, primitive)| outline_of(id, primitive, camera, grid))
            .collect();
        let leaves = (grid.bands() as usize).next_power_of_two();
        let nodes = |o: &Outline| nodes_of(o.y.map(|y| leaves + (y / SampleGrid::TILE) as usize));
        let (at_nodes, starts) = sort_into(2 * leaves, outlines.iter().map(nodes));
        Self { outlines, at_nodes, starts, leaves }
    }

    /// The outlines that a band's tiles may show, by tile and in the order of primitives.
    pub(crate) fn band(&self, grid: &SampleGrid, band: u32) -> BandOutlines {
        let leaf = self.leaves + band as usize;
        let way_up = std::iter::successors(Some(leaf), |node| Some(node / 2).filter(|node| *node > 0));
        let mut mine: Vec<u32> = way_up
            .flat_map(|node| &self.at_nodes[self.starts[node]..self.starts[node + 1]])
            .copied()
            .collect();
        mine.sort_unstable();
        let outline = |i: &u32| &self.outlines[*i as usize];
        let tiles = |i: &u32| {
            let [first, last] = outline(i).x.map(|x| (x / SampleGrid::TILE) as usize);
            first..=last
        };
        let (order, starts) = sort_into(grid.tiles_wide() as usize, mine.iter().map(tiles));
        let outlines = order.iter().map(|&k| *outline(&mine[k as usize])).collect();
        BandOutlines { outlines, starts }
    }
}

impl BandOutlines {
    pub(crate) fn tile(&self, column: u32) -> &[Outline] {
        &self.outlines[self.starts[column as usize]..self.starts[column as usize + 1]]
    }
}

/// The fewest nodes of a segment tree under which the leaves from the first to the last stand, and no others.
fn nodes_of([mut first, mut last]: [usize; 2]) -> impl Iterator<Item = usize> + Clone {
    let mut nodes = [0; 2 * usize::BITS as usize];
    let mut count = 0;
    let mut add = |node: usize| {
        nodes[count] = node;
        count += 1;
    };
    while first <= last {
        // A right half at the left end, and a left half at the right end, stand for themselves; parents for the others.
        if first % 2 == 1 {
            add(first);
            first += 1;
        }
        if last.is_multiple_of(2) {
            add(last);
            last -= 1;
        }
        (first, last) = (first / 2, last / 2);
    }
    nodes.into_iter().take(count)
}

/// Distributes items over bins, each into some of them; keeps their order in every bin.
fn sort_into<B>(bins: usize, items: impl Iterator<Item = B> + Clone) -> (Vec<u32>, Vec<usize>)
where
    B: IntoIterator<Item = usize>,
{
    let mut starts = vec![0; bins + 1];
    items.clone().flatten().for_each(|bin| starts[bin + 1] += 1);
    (0..bins).for_each(|bin| starts[bin + 1] += starts[bin]);
    let mut next = starts.clone();
    let mut order = vec![0; starts[bins]];
    for (index, of_item) in items.enumerate() {
        for bin in of_item {
            order[next[bin]] = index as u32;
            next[bin] += 1;
        }
    }
    (order, starts)
}

/// The outline of a primitive, `None` where it cannot be seen.
fn outline_of(id: u32, primitive: &Primitive, camera: &PreparedCamera, grid: &SampleGrid) -> Option<Outline> {
    let last = [grid.samples_wide() - 1, grid.samples_high() - 1];
    let anywhere = Outline { primitive: id, x: [0, last[0]], y: [0, last[1]], nearest: 0.0 };
    let hull = primitive.hull();
    if hull.is_empty() {
        return Some(anywhere);
    }
    // Hits of what reaches far away round by a share of that, also where it is near.
    let reach = hull.iter().map(|&p| size(p - camera.eye) + size(p)).fold(size(camera.eye), f64::max);
    let seen: Vec<Seen> = hull.iter().map(|&p| Seen::new(p, reach, camera)).collect();
    if !seen.iter().all(Seen::is_known) {
        return Some(anywhere);
    }
    let depth = |s: &Seen| s.depth - s.margin;
    let nearest = seen.iter().map(depth).fold(f64::INFINITY, f64::min);
    if seen.iter().all(|s| s.depth + s.margin <= 0.0) {
        return None;
    }
    if camera.is_perspective && nearest <= 0.0 {
        return Some(anywhere);
    }
    let span = |axis: usize| {
        let positions = seen.iter().map(|s| s.sample_range(axis, camera));
        let [lo, hi] =
            positions.fold([f64::INFINITY, f64::NEG_INFINITY], |[lo, hi], [a, b]| [lo.min(a), hi.max(b)]);
        let (lo, hi) = (lo.ceil().max(0.0), hi.floor().min(f64::from(last[axis])));
        if lo > hi { None } else { Some([lo as u32, hi as u32]) }
    };
    Some(Outline { x: span(0)?, y: span(1)?, nearest: nearest.max(0.0), ..anywhere })
}

fn size(v: Vec3) -> f64 {
    v.x.abs() + v.y.abs() + v.z.abs()
}

/// A point in the camera's coordinates.
struct Seen {
    right: f64,
    down: f64,
    depth: f64,
    /// Uncertainty of all three.
    margin: f64,
}

impl Seen {
    /// Are the coordinates numbers? The least of numbers says nothing of what is none.
    fn is_known(&self) -> bool {
        [self.right, self.down, self.depth, self.margin].iter().all(|x| x.abs() < f64::INFINITY)
    }

    /// `reach` is the greatest coordinate, by whatever it is counted, that where the primitive is met depends on.
    fn new(point: Vec3, reach: f64, camera: &PreparedCamera) -> Self {
        let p = point - camera.eye;
        Self {
            right: p.dot(camera.right),
            down: -p.dot(camera.up),
            depth: p.dot(camera.forward),
            margin: PROJECTION_MARGIN * size(p) + COORDINATE_ROUNDING * reach,
        }
    }

    /// Between which sample columns (axis 0) or rows (axis 1) it lies.
    fn sample_range(&self, axis: usize, camera: &PreparedCamera) -> [f64; 2] {
        let offset = if axis == 0 { self.right } else { self.down };
        let (lo, hi) = (offset - self.margin, offset + self.margin);
        let [lo, hi] = if camera.is_perspective {
            // The depth is above its margin here.
            let (near, far) = (self.depth - self.margin, self.depth + self.margin);
            [lo / if lo < 0.0 { near } else { far }, hi / if hi < 0.0 { far } else { near }]
        } else {
            [lo, hi]
        };
        let sample = |position: f64| 0.5 * (position / camera.half_sample - camera.first[axis]);
        // A sample may lie that far beside its column or row.
        let margin = PROJECTION_MARGIN + camera.pattern.reach();
        [sample(lo) - margin, sample(hi) + margin]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn items_keep_their_order_in_every_bin() {
        let ranges = [0..=2, 1..=1, 2..=2, 0..=0];
        let (order, starts) = sort_into(3, ranges.into_iter());
        assert_eq!(starts, [0, 2, 4, 6]);
        assert_eq!(order, [0, 3, 0, 1, 0, 2]);
    }

    #[test]
    fn every_leaf_of_a_range_stands_under_one_of_its_nodes_and_no_other_does() {
        const LEAVES: usize = 16;
        for first in 0..LEAVES {
            for last in first..LEAVES {
                let nodes: Vec<usize> = nodes_of([LEAVES + first, LEAVES + last]).collect();
                assert!(nodes.len() <= 2 * 4, "{first} to {last}: {nodes:?}");
                for leaf in 0..LEAVES {
                    let mut above = std::iter::successors(Some(LEAVES + leaf), |n| Some(n / 2));
                    let count = above.by_ref().take(5).filter(|n| nodes.contains(n)).count();
                    assert_eq!(
                        count,
                        usize::from((first..=last).contains(&leaf)),
                        "{leaf} of {first} to {last}"
                    );
                }
            }
        }
    }
}
