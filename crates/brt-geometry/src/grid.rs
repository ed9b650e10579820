//! A uniform grid of cells, walked by a three-dimensional digital differential analyser (Fujimoto, Tanaka, Iwata:
//! *ARTS: accelerated ray-tracing system*, IEEE CG&A 6 (4), 1986). Paper: P1.

use crate::margins::{BOX_MARGIN, GRID_ROOM, WALK_MARGIN};
use crate::{Aabb, Ray, Traversal, Vec3};

/// Cells per item that are aimed at: more cells mean fewer tests and longer walks.
const CELLS_PER_ITEM: f64 = 4.0;

/// Most cells along an axis.
const MOST_CELLS: f64 = 128.0;

/// Entries in cells that are always allowed, and for each item besides: what bounds the grid's memory.
const MOST_ENTRIES: u64 = 1 << 21;
const ENTRIES_PER_ITEM: u64 = 32;

/// A uniform grid over boxes with items.
#[derive(Clone, Debug)]
pub struct Grid {
    /// Rays that start farther from the middle (as a sum over the axes) do not walk.
    farthest_start: f64,
    lo: Vec3,
    cell: Vec3,
    count: [usize; 3],
    /// Where each cell's part of `items` starts; one more at the end.
    starts: Vec<u32>,
    items: Vec<u32>,
}

impl Grid {
    /// The grid over these boxes.
    pub fn build(boxes: &[(u32, Aabb)]) -> Self {
        let whole = boxes.iter().map(|b| b.1).reduce(Aabb::union);
        let whole = whole.unwrap_or(Aabb::around(Vec3::ZERO, Vec3::splat(1.0)));
        let longest = whole.longest_side();
        let room = Vec3::splat(GRID_ROOM * BOX_MARGIN * longest);
        // The grid is larger than its items' room: the walk rounds, too.
        let (lo, size) = (whole.lo - room * 2.0, whole.hi - whole.lo + room * 4.0);
        // From there to anything in the grid it is one size more at most; and one is left for the walk's rounding.
        let farthest_start = (GRID_ROOM - 2.0) * longest;
        let mut count = cell_counts(size, boxes.len());
        loop {
            let cell: [f64; 3] = std::array::from_fn(|axis| size[axis] / count[axis] as f64);
            let (starts, items) = (Vec::new(), Vec::new());
            let mut grid = Self { farthest_start, lo, cell: cell.into(), count, starts, items };
            let ranges: Vec<_> = boxes.iter().map(|(_, b)| grid.cells_of(b, room)).collect();
            let entries: u64 = ranges.iter().map(cells_in).sum();
            if entries <= MOST_ENTRIES + ENTRIES_PER_ITEM * boxes.len() as u64 || count == [1; 3] {
                grid.distribute(boxes, &ranges);
                return grid;
            }
            // Large items fill many cells: fewer cells are needed.
            count = count.map(|n| n.div_ceil(2));
        }
    }

    /// First and last cell that a box, grown by a margin for the walk's rounding, reaches.
    fn cells_of(&self, bounds: &Aabb, margin: Vec3) -> CellRange {
        [self.cell_at(bounds.lo - margin), self.cell_at(bounds.hi + margin)]
    }

    /// Puts every item into its cells.
    fn distribute(&mut self, boxes: &[(u32, Aabb)], ranges: &[CellRange]) {
        let total = self.count.iter().product::<usize>();
        let mut starts = vec![0_u32; total + 1];
        for range in ranges {
            self.for_cells(range, |cell| starts[cell + 1] += 1);
        }
        (0..total).for_each(|i| starts[i + 1] += starts[i]);
        let mut next = starts.clone();
        let mut items = vec![0; starts[total] as usize];
        for (range, (item, _)) in ranges.iter().zip(boxes) {
            self.for_cells(range, |cell| {
                items[next[cell] as usize] = *item;
                next[cell] += 1;
            });
        }
        (self.starts, self.items) = (starts, items);
    }

    fn for_cells(&self, [lo, hi]: &CellRange, mut visit: impl FnMut(usize)) {
        for z in lo[2]..=hi[2] {
            for y in lo[1]..=hi[1] {
                (lo[0]..=hi[0]).for_each(|x| visit(self.index([x, y, z])));
            }
        }
    }

    fn index(&self, [x, y, z]: [usize; 3]) -> usize {
        (z * self.count[1] + y) * self.count[0] + x
    }

    /// The cell that a point lies in or next to.
    fn cell_at(&self, point: Vec3) -> [usize; 3] {
        std::array::from_fn(|axis| {
            let position = (point[axis] - self.lo[axis]) / self.cell[axis];
            // A cast of a float saturates: points before the grid lie in its first cell.
            (position as usize).min(self.count[axis] - 1)
        })
    }

    /// Visits the items of the cells that the ray passes before `t_max`; `visit` returns the new `t_max`.
    pub fn closest(&self, ray: &Ray, t_max: f64, walk: &mut Traversal, mut visit: impl FnMut(u32) -> f64) {
        let mut limit = t_max;
        self.walk(ray, walk, |items, enter| {
            if enter > limit {
                return true;
            }
            items.iter().for_each(|&item| limit = visit(item));
            false
        });
    }

    /// Visits the items of the cells that the ray passes before `t_max` until `visit` says true; returns whether it
    /// did.
    pub fn any(
        &self,
        ray: &Ray,
        t_max: f64,
        walk: &mut Traversal,
        mut visit: impl FnMut(u32) -> bool,
    ) -> bool {
        let mut found = false;
        self.walk(ray, walk, |items, enter| {
            found = enter <= t_max && items.iter().any(|&item| visit(item));
            found || enter > t_max
        });
        found
    }

    /// Hands out the cells along a ray, each with the distance at which it is entered (a little less, for rounding),
    /// until `visit` says that it is enough.
    fn walk(&self, ray: &Ray, walk: &mut Traversal, mut visit: impl FnMut(&[u32], f64) -> bool) {
        if self.is_far(ray.origin) {
            // Items in several cells are handed out several times, as on a walk.
            visit(&self.items, 0.0);
            return;
        }
        let Some(enter) = self.enter(ray) else { return };
        let mut cell = self.cell_at(ray.at(enter));
        let mut entered = enter;
        loop {
            walk.nodes_visited += 1;
            let index = self.index(cell);
            let items = &self.items[self.starts[index] as usize..self.starts[index + 1] as usize];
            if visit(items, entered - WALK_MARGIN * entered.abs()) {
                return;
            }
            let (axis, next) = self.leave(ray, cell);
            entered = next;
            match step(cell[axis], ray.direction[axis] > 0.0, self.count[axis]) {
                Some(position) => cell[axis] = position,
                None => return,
            }
        }
    }

    fn is_far(&self, point: Vec3) -> bool {
        let half = |axis: usize| 0.5 * self.cell[axis] * self.count[axis] as f64;
        let from_middle = |axis: usize| (point[axis] - self.lo[axis] - half(axis)).abs();
        let distance = from_middle(0) + from_middle(1) + from_middle(2);
        distance > self.farthest_start || distance.is_nan()
    }

    /// Distance at which the ray is first inside the grid; `None` if it passes by.
    fn enter(&self, ray: &Ray) -> Option<f64> {
        let (mut enter, mut leave) = (0.0_f64, f64::INFINITY);
        for axis in 0..3 {
            let [near, far] = self.slab(ray, axis, 0, self.count[axis]);
            // Of NaN (the ray lies in the slab's plane) and a number these take the number.
            enter = enter.max(near);
            leave = leave.min(far);
        }
        (enter <= leave).then_some(enter)
    }

    /// Where the ray leaves a cell: through which axis, at which distance.
    fn leave(&self, ray: &Ray, cell: [usize; 3]) -> (usize, f64) {
        let far = |axis: usize| {
            let [_, far] = self.slab(ray, axis, cell[axis], cell[axis] + 1);
            if ray.direction[axis] == 0.0 { f64::INFINITY } else { far }
        };
        (0..3).map(|axis| (axis, far(axis))).min_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((0, f64::INFINITY))
    }

    /// Distances to the planes before cells `from` and `to` of an axis, the smaller one first.
    fn slab(&self, ray: &Ray, axis: usize, from: usize, to: usize) -> [f64; 2] {
        let plane = |cell: usize| self.lo[axis] + cell as f64 * self.cell[axis];
        let (a, b) = (plane(from) - ray.origin[axis], plane(to) - ray.origin[axis]);
        let direction = ray.direction[axis];
        // By its sign, for the distances of -0.0 are those of a backward ray.
        if direction.is_sign_negative() {
            [b / direction, a / direction]
        } else {
            [a / direction, b / direction]
        }
    }
}

/// First and last cell.
type CellRange = [[usize; 3]; 2];

fn cells_in([lo, hi]: &CellRange) -> u64 {
    (0..3).map(|axis| (hi[axis] - lo[axis] + 1) as u64).product()
}

/// The neighbouring cell, `None` beyond the grid.
fn step(position: usize, forward: bool, count: usize) -> Option<usize> {
    if forward { Some(position + 1).filter(|&p| p < count) } else { position.checked_sub(1) }
}

/// Cells along each axis such that they are about cubes.
fn cell_counts(size: Vec3, items: usize) -> [usize; 3] {
    let volume = size.x * size.y * size.z;
    let side = libm::cbrt(volume / (CELLS_PER_ITEM * items.max(1) as f64));
    std::array::from_fn(|axis| (size[axis] / side).clamp(1.0, MOST_CELLS) as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_items_as_large_as_the_room_take_bounded_memory() {
        let room = Aabb::around(Vec3::ZERO, Vec3::splat(1.0));
        let boxes: Vec<(u32, Aabb)> = (0..200_000).map(|i| (i, room)).collect();
        let grid = Grid::build(&boxes);
        assert!(grid.items.len() as u64 <= MOST_ENTRIES + ENTRIES_PER_ITEM * 200_000, "{}", grid.items.len());
    }
}
