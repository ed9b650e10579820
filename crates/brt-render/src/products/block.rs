//! Blocks: rectangles of samples judged together.

/// A rectangle of samples in a tile, all four sides included. Neighbours share their common side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Block {
    pub(crate) x0: u32,
    pub(crate) y0: u32,
    pub(crate) x1: u32,
    pub(crate) y1: u32,
}

impl Block {
    /// Blocks of side `side` that cover a tile. They are anchored at its corner, and so at the picture's.
    ///
    /// Blocks share sides inside a tile but not between tiles, which are independent of each other.
    pub(crate) fn cover(width: u32, height: u32, side: u32) -> Vec<Self> {
        let (columns, rows) = (spans(width, side), spans(height, side));
        let row_of = |&[y0, y1]: &[u32; 2]| {
            columns.iter().map(move |&[x0, x1]| Self { x0, y0, x1, y1 }).collect::<Vec<_>>()
        };
        rows.iter().flat_map(row_of).collect()
    }

    /// Its corners; fewer than four different ones where it is a line or a point.
    pub(crate) fn corners(&self) -> [[u32; 2]; 4] {
        [[self.x0, self.y0], [self.x1, self.y0], [self.x0, self.y1], [self.x1, self.y1]]
    }

    /// Distance between its corners along the longer side.
    pub(crate) fn side(&self) -> u32 {
        (self.x1 - self.x0).max(self.y1 - self.y0)
    }

    /// Has it no samples but its corners?
    pub(crate) fn is_smallest(&self) -> bool {
        self.x1 - self.x0 <= 1 && self.y1 - self.y0 <= 1
    }

    /// Its halves in both directions, as far as they can be halved. Must not be the smallest.
    pub(crate) fn divide(&self) -> impl Iterator<Item = Self> + use<> {
        let block = *self;
        let (xs, ys) = (halves(block.x0, block.x1), halves(block.y0, block.y1));
        ys.into_iter()
            .flatten()
            .flat_map(move |[y0, y1]| xs.into_iter().flatten().map(move |[x0, x1]| Self { x0, y0, x1, y1 }))
    }
}

fn spans(length: u32, side: u32) -> Vec<[u32; 2]> {
    let last = length - 1;
    if last == 0 {
        return vec![[0, 0]];
    }
    (0..last).step_by(side as usize).map(|a| [a, (a + side).min(last)]).collect()
}

fn halves(a: u32, b: u32) -> [Option<[u32; 2]>; 2] {
    if b - a <= 1 {
        return [Some([a, b]), None];
    }
    let middle = a + (b - a) / 2;
    [Some([a, middle]), Some([middle, b])]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_cover_a_tile_and_share_sides() {
        let blocks = Block::cover(33, 20, 16);
        // columns 0-16, 16-32; rows 0-16, 16-19
        assert_eq!(blocks.len(), 4);
        assert_eq!(blocks[3], Block { x0: 16, y0: 16, x1: 32, y1: 19 });
    }

    #[test]
    fn a_line_is_halved_along_itself() {
        let line = Block { x0: 0, y0: 3, x1: 4, y1: 3 };
        let parts: Vec<Block> = line.divide().collect();
        assert_eq!(parts, [Block { x1: 2, ..line }, Block { x0: 2, ..line }]);
    }

    #[test]
    fn one_sample_is_one_block() {
        assert_eq!(Block::cover(1, 1, 16), [Block { x0: 0, y0: 0, x1: 0, y1: 0 }]);
    }
}
