//! Regions: the parts of a block that show one surface. Paper: P4, P6, reading 1.

use crate::products::{Block, PerspectiveImage, SampleState, Tile};

/// The samples of a block that show one surface, and the four chosen among them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Region {
    pub(super) surface: u32,
    /// The samples farthest out towards the block's four corners; for a whole block these are the corners.
    pub(super) points: [[u32; 2]; 4],
    /// Has it samples without colour?
    pub(super) is_pending: bool,
    /// Is it the whole block?
    pub(super) is_whole: bool,
}

/// What a block of the perspective image holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Contents {
    One(Region),
    Two([Region; 2]),
    /// Three surfaces or more.
    Many,
}

/// Finds the regions of a block.
pub(super) fn regions_of(
    block: &Block,
    tile: &Tile,
    perspective: &PerspectiveImage,
    states: &[SampleState],
) -> Contents {
    if let Some(surface) = only_surface(block, tile, perspective) {
        let is_pending = rows(block, tile).any(|row| states[row].contains(&SampleState::Pending));
        return Contents::One(Region { surface, points: block.corners(), is_pending, is_whole: true });
    }
    let mut found: [Option<Extremes>; 2] = [None, None];
    for (y, row) in (block.y0..).zip(rows(block, tile)) {
        let start = row.start;
        for index in row {
            let (surface, x) = (perspective.surface[index], block.x0 + (index - start) as u32);
            let is_pending = states[index] == SampleState::Pending;
            match found.iter_mut().find(|e| e.as_ref().is_none_or(|e| e.surface == surface)) {
                None => return Contents::Many,
                Some(Some(extremes)) => extremes.add(x, y, is_pending),
                Some(empty) => *empty = Some(Extremes::new(surface, x, y, is_pending)),
            }
        }
    }
    match found.map(|e| e.map(Extremes::region)) {
        [Some(a), Some(b)] => Contents::Two([a, b]),
        [Some(a), None] => Contents::One(a),
        _ => Contents::Many,
    }
}

/// Positions of a block's rows in the tile's arrays.
pub(super) fn rows(block: &Block, tile: &Tile) -> impl Iterator<Item = std::ops::Range<usize>> + use<> {
    let (tile, block) = (*tile, *block);
    (block.y0..=block.y1).map(move |y| tile.index(block.x0, y)..tile.index(block.x1, y) + 1)
}

fn only_surface(block: &Block, tile: &Tile, perspective: &PerspectiveImage) -> Option<u32> {
    let surface = perspective.surface[tile.index(block.x0, block.y0)];
    // Whole rows are compared without a way out in between, which the compiler turns into vector instructions.
    let is_even = |row: &[u32]| row.iter().fold(true, |even, &s| even & (s == surface));
    rows(block, tile).all(|row| is_even(&perspective.surface[row])).then_some(surface)
}

/// Samples of a surface that lie farthest out in the four diagonal directions.
struct Extremes {
    surface: u32,
    points: [[u32; 2]; 4],
    is_pending: bool,
}

impl Extremes {
    fn new(surface: u32, x: u32, y: u32, is_pending: bool) -> Self {
        Self { surface, points: [[x, y]; 4], is_pending }
    }

    fn add(&mut self, x: u32, y: u32, is_pending: bool) {
        self.is_pending |= is_pending;
        let corner_directions = [[-1, -1], [1, -1], [-1, 1], [1, 1]];
        for (point, [u, v]) in self.points.iter_mut().zip(corner_directions) {
            let reach = |[x, y]: [u32; 2]| u * i64::from(x) + v * i64::from(y);
            if reach([x, y]) > reach(*point) {
                *point = [x, y];
            }
        }
    }

    fn region(self) -> Region {
        Region { surface: self.surface, points: self.points, is_pending: self.is_pending, is_whole: false }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slanted_edge_makes_two_regions_with_points_inside() {
        // 4×4 samples, surface 7 below the diagonal, 3 above and on it
        let tile = Tile { x: 0, y: 0, width: 4, height: 4 };
        let surface: Vec<u32> = (0..16).map(|i| if i % 4 >= i / 4 { 3 } else { 7 }).collect();
        let image = PerspectiveImage { primitive: surface.clone(), surface, ..PerspectiveImage::default() };
        let block = Block { x0: 0, y0: 0, x1: 3, y1: 3 };
        let Contents::Two([a, b]) = regions_of(&block, &tile, &image, &[SampleState::Pending; 16]) else {
            panic!("two surfaces")
        };
        assert_eq!((a.surface, a.points), (3, [[0, 0], [3, 0], [0, 0], [3, 3]]));
        assert_eq!((b.surface, b.points), (7, [[0, 1], [0, 1], [0, 3], [2, 3]]));
    }
}
