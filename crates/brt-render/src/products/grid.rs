//! The grid of samples over a picture.

use super::SamplePattern;
use crate::settings::Samples;

/// Samples of the whole picture: `per_side` × `per_side` of them in each pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SampleGrid {
    /// Pixels per row.
    pub width: u32,
    /// Rows of pixels.
    pub height: u32,
    /// Samples along each side of a pixel.
    pub per_side: u32,
}

impl SampleGrid {
    /// Greatest side of a tile and of a block, in samples.
    pub const TILE: u32 = 128;

    /// The grid of a picture.
    pub fn new([width, height]: [u32; 2], samples: Samples) -> Self {
        Self { width, height, per_side: samples.per_side() }
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
