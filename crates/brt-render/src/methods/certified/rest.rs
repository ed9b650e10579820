//! Samples that show so little of a primitive that nothing is proven of them: traced together with their neighbours.
//!
//! Of these is the picture of a fine mesh made, whose triangles are smaller than a few pixels.

use super::Certified;
use crate::products::{Certificate, SampleState};
use crate::tracing::MOST_RAYS;

/// Samples are gathered within squares of this side, so that rays that go together stay close.
const SQUARE: u32 = 32;

/// Within them by strips of this height, so that as many as go together form a square where all are traced.
const STRIP: u32 = 8;

impl Certified<'_, '_> {
    /// Traces all samples that are still pending.
    pub(super) fn trace_rest(&mut self) {
        let (width, height) = (self.tile.width, self.tile.height);
        for top in (0..height).step_by(SQUARE as usize) {
            for left in (0..width).step_by(SQUARE as usize) {
                self.trace_rest_of([left, (left + SQUARE).min(width)], [top, (top + SQUARE).min(height)]);
            }
        }
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
