//! Tiles of the picture and the samples in them.

use std::ops::Range;

use super::{Area, Certificate, RayHistory, SampleGrid};
use crate::settings::Window;

/// How a sample got its colour. Every sample is exactly one of these in the end.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
#[repr(u8)]
pub enum SampleState {
    /// It has none yet.
    #[default]
    Pending,
    /// By a colour function over its block.
    Filled,
    /// By shading a known history without any search.
    Shaded,
    /// By searching rays.
    Traced,
}

/// A rectangle of the picture that is rendered at a time: at most [`SampleGrid::TILE`] samples wide and high.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Tile {
    /// First sample column and row of the grid.
    pub(crate) x: u32,
    pub(crate) y: u32,
    /// Samples per row, rows.
    pub(crate) width: u32,
    pub(crate) height: u32,
}

impl Tile {
    /// The tile in this column and band.
    pub(crate) fn at(grid: &SampleGrid, column: u32, band: u32) -> Self {
        let (x, y) = (column * SampleGrid::TILE, band * SampleGrid::TILE);
        Self {
            x,
            y,
            width: SampleGrid::TILE.min(grid.samples_wide() - x),
            height: SampleGrid::TILE.min(grid.samples_high() - y),
        }
    }

    /// Its pixels.
    pub(crate) fn pixels(&self, grid: &SampleGrid) -> Window {
        let pixels = |samples: u32| samples / grid.per_side;
        Window {
            x: grid.first[0] + u64::from(pixels(self.x)),
            y: grid.first[1] + u64::from(pixels(self.y)),
            width: pixels(self.width),
            height: pixels(self.height),
        }
    }

    /// All of it.
    pub(crate) fn area(&self) -> Area {
        Area { x0: self.x, y0: self.y, x1: self.x + self.width, y1: self.y + self.height }
    }

    pub(crate) fn sample_count(&self) -> usize {
        (self.width * self.height) as usize
    }

    /// Position of a sample of the tile in its arrays.
    #[inline(always)]
    pub(crate) fn index(&self, x: u32, y: u32) -> usize {
        (y * self.width + x) as usize
    }
}

/// Colours, states and histories of a tile's samples, row by row. Reused from tile to tile.
#[derive(Clone, Debug, Default)]
pub(crate) struct TileSamples {
    /// Linear RGB.
    pub(crate) color: Vec<[f32; 3]>,
    pub(crate) state: Vec<SampleState>,
    /// Which certificate failed, if one did. Empty unless that is shown as a layer.
    pub(crate) cause: Vec<Option<Certificate>>,
    /// Means something where a sample is traced; where it is filled only if histories are shown as a layer.
    pub(crate) history: Vec<RayHistory>,
    /// How much of each sample is covered; `None` where the background is part of the picture.
    pub(crate) alpha: Option<Vec<f32>>,
}

impl TileSamples {
    /// Makes all samples of a tile pending, and wholly covered.
    pub(crate) fn reset(&mut self, tile: &Tile) {
        let count = tile.sample_count();
        self.color.resize(count, [0.0; 3]);
        self.history.resize(count, RayHistory::default());
        self.state.clear();
        self.state.resize(count, SampleState::Pending);
        if let Some(alpha) = &mut self.alpha {
            alpha.clear();
            alpha.resize(count, 1.0);
        }
    }

    /// Gives the samples of a run that are still pending the alpha of another one, if there is alpha.
    pub(crate) fn spread_alpha(&mut self, from: usize, run: Range<usize>) {
        let Some(alpha) = &mut self.alpha else { return };
        let value = alpha[from];
        for (alpha, state) in alpha[run.clone()].iter_mut().zip(&self.state[run]) {
            if *state == SampleState::Pending {
                *alpha = value;
            }
        }
    }
}
