//! Samples that are left when single primitives are settled: those that show little of one, and smooth meshes.
//!
//! Smooth meshes are filled first, across their triangles, where they can be ([`super::sheet`]). What is still pending is
//! traced together with its neighbours: of that is the picture of a fine mesh made, whose triangles are smaller than a few
//! pixels.

use super::Certified;
use crate::products::{Area, Certificate, SampleState, Tile};
use crate::tracing::MOST_RAYS;

/// Samples are gathered within squares of this side, so that rays that go together stay close.
const SQUARE: u32 = 32;

/// Within them by strips of this height, so that as many as go together form a square where all are traced.
const STRIP: u32 = 8;

/// Squares of a tile that hold samples which are still pending, one bit each: most of a large picture has none.
#[derive(Clone, Copy, Default)]
pub(super) struct Rest(u64);

impl Rest {
    /// Squares in a row; a tile has at most as many rows of them.
    const PER_ROW: u32 = 8;

    /// Some samples of this area are left.
    pub(super) fn add(&mut self, tile: &Tile, area: &Area) {
        for y in (area.y0 - tile.y) / SQUARE..=(area.y1 - 1 - tile.y) / SQUARE {
            for x in (area.x0 - tile.x) / SQUARE..=(area.x1 - 1 - tile.x) / SQUARE {
                debug_assert!(x < Self::PER_ROW && y < Self::PER_ROW, "a larger tile");
                self.0 |= 1 << (y * Self::PER_ROW + x);
            }
        }
    }

    /// Columns and rows of the squares' upper left samples in the tile.
    fn corners(self) -> impl Iterator<Item = [u32; 2]> {
        let squares = (0..u64::BITS).filter(move |i| self.0 >> i & 1 == 1);
        squares.map(|i| [i % Self::PER_ROW * SQUARE, i / Self::PER_ROW * SQUARE])
    }
}

impl Certified<'_, '_> {
    /// Traces all samples that are still pending.
    pub(super) fn trace_rest(&mut self) {
        let (width, height) = (self.tile.width, self.tile.height);
        for [left, top] in self.rest.corners() {
            let (x, y) = (self.tile.x, self.tile.y);
            let (right, bottom) = ((left + SQUARE).min(width), (top + SQUARE).min(height));
            self.fill_sheets(Area { x0: x + left, y0: y + top, x1: x + right, y1: y + bottom });
            self.lap(|seconds| &mut seconds.select);
            self.trace_rest_of([left, right], [top, bottom]);
            self.lap(|seconds| &mut seconds.trace);
        }
    }

    /// Traces the samples on edges, whatever was proven for others around them.
    pub(super) fn trace_doubtful(&mut self) {
        let doubtful = std::mem::take(&mut self.worker.perspective.doubtful);
        doubtful.chunks(MOST_RAYS).for_each(|samples| self.trace_shown(samples));
        self.worker.perspective.doubtful = doubtful;
        self.lap(|seconds| &mut seconds.trace);
    }

    fn trace_rest_of(&mut self, [left, right]: [u32; 2], [top, bottom]: [u32; 2]) {
        let (mut samples, mut count) = ([[0; 2]; MOST_RAYS], 0);
        for strip in (top..bottom).step_by(STRIP as usize) {
            for x in left..right {
                for y in strip..(strip + STRIP).min(bottom) {
                    if self.worker.samples.state[self.tile.index(x, y)] == SampleState::Pending {
                        samples[count] = [x, y];
                        count += 1;
                    }
                    if count == MOST_RAYS {
                        self.trace_shown(&samples);
                        count = 0;
                    }
                }
            }
        }
        if count > 0 {
            self.trace_shown(&samples[..count]);
        }
    }

    /// Traces samples, each from what it shows.
    fn trace_shown(&mut self, samples: &[[u32; 2]]) {
        let (worker, tile) = (&mut *self.worker, self.tile);
        if worker.wants_histories {
            samples.iter().for_each(|&[x, y]| worker.note_history_of(tile, x, y));
        }
        worker.trace_shown_samples(tile, samples);
        if worker.wants_causes {
            samples.iter().for_each(|&[x, y]| {
                worker.samples.cause[tile.index(x, y)] = Some(Certificate::Size);
            });
        }
    }
}
