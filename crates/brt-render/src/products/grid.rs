//! The grid of samples over a window of a picture.

use super::SamplePattern;
use crate::settings::{Samples, Settings, Window};

/// Samples of the tiles that a window needs: `per_side` × `per_side` of them in each pixel. Tiles are anchored at the corner
/// of the whole picture, so a window cuts it into the same blocks as any other.
///
/// Columns and rows count from the first of these tiles, not from the picture's corner: they fit into 32 bits however large
/// the picture is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SampleGrid {
    /// Pixels per row, and rows of pixels, of the whole picture.
    pub picture: [u64; 2],
    /// The picture's pixel that is the first one here; the corner of a tile.
    pub first: [u64; 2],
    /// Pixels per row.
    pub width: u32,
    /// Rows of pixels.
    pub height: u32,
    /// Samples along each side of a pixel.
    pub per_side: u32,
}

impl SampleGrid {
    /// Greatest side of a tile, in samples: blocks do not reach beyond.
    pub const TILE: u32 = Settings::GREATEST_BLOCK;

    /// The grid of a whole picture.
    pub fn new([width, height]: [u32; 2], samples: Samples) -> Self {
        let picture = [u64::from(width), u64::from(height)];
        Self { picture, first: [0, 0], width, height, per_side: samples.per_side() }
    }

    /// The tiles of a picture that a window needs, whose pixels take from `margin` pixels around them. The window must
    /// [fit](Window::fits) into the picture.
    pub(crate) fn around(window: &Window, picture: [u64; 2], samples: Samples, margin: u32) -> Self {
        let tile = u64::from(Self::TILE / samples.per_side());
        let span = |first: u64, length: u32, side: u64| {
            let begin = first.saturating_sub(u64::from(margin)) / tile * tile;
            let end = (first + u64::from(length) + u64::from(margin)).next_multiple_of(tile).min(side);
            (begin, (end - begin) as u32)
        };
        let (x, width) = span(window.x, window.width, picture[0]);
        let (y, height) = span(window.y, window.height, picture[1]);
        Self { picture, first: [x, y], width, height, per_side: samples.per_side() }
    }

    /// Samples per row.
    pub fn samples_wide(&self) -> u32 {
        self.width * self.per_side
    }

    /// Rows of samples.
    pub fn samples_high(&self) -> u32 {
        self.height * self.per_side
    }

    /// Where samples lie in it.
    pub(crate) fn pattern(&self) -> SamplePattern {
        SamplePattern::new(self.per_side)
    }

    /// Side of a whole tile in pixels.
    pub(crate) fn tile_pixels(&self) -> u32 {
        Self::TILE / self.per_side
    }

    /// Number of tiles side by side.
    pub(crate) fn tiles_wide(&self) -> u32 {
        self.width.div_ceil(self.tile_pixels())
    }

    /// Number of bands of tiles.
    pub(crate) fn bands(&self) -> u32 {
        self.height.div_ceil(self.tile_pixels())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_window_needs_the_tiles_around_it() {
        let window = Window { x: 1000, y: 31, width: 10, height: 2 };
        let grid = SampleGrid::around(&window, [1020, 1 << 40], Samples::Sixteen, 0);
        assert_eq!((grid.first, grid.width, grid.height), ([992, 0], 28, 64));
        // Filters reach over the corner of a tile.
        let grid = SampleGrid::around(&Window { y: 64, ..window }, [1020, 1 << 40], Samples::Sixteen, 1);
        assert_eq!((grid.first, grid.height), ([992, 32], 64));
    }

    #[test]
    fn the_whole_picture_needs_no_more_than_itself() {
        let window = Window::whole([100, 70]).unwrap();
        let whole = SampleGrid::new([100, 70], Samples::Four);
        assert_eq!(SampleGrid::around(&window, [100, 70], Samples::Four, 1), whole);
    }
}
