//! Giving the samples of a block their colours.

use brt_geometry::Taylor;
use brt_image::Rgb;

use super::known_history::KnownHistory;
use super::regions::Region;
use super::{Certified, Parts};
use crate::filling::LinearFill;
use crate::products::{Area, Certificate, SampleState};
use crate::tracing::{MOST_RAYS, Sight};

/// The state of samples that are not filled, and why they are not.
type Reason = (SampleState, Certificate);

/// Columns are gone through in strips of this many, so that as many samples as are traced together form a square.
const STRIP: usize = 8;

impl Certified<'_, '_> {
    /// Traces samples, guided by what is proven, as something could not be.
    pub(super) fn trace(&mut self, area: Area, parts: Parts, history: &KnownHistory, failed: Certificate) {
        self.trace_as(area, parts, history, (SampleState::Traced, failed));
    }

    /// Shades samples whose history is proven.
    pub(super) fn shade(&mut self, area: Area, parts: Parts, history: &KnownHistory, failed: Certificate) {
        self.trace_as(area, parts, history, (SampleState::Shaded, failed));
    }

    fn trace_as(&mut self, area: Area, parts: Parts, history: &KnownHistory, reason: Reason) {
        self.lap(|seconds| &mut seconds.select);
        let mut batch = Batch::default();
        self.for_each_sample(area, parts, history.first(), |this, x, y| {
            batch.add(x, y);
            if batch.count == MOST_RAYS {
                this.trace_batch(&batch, history, reason);
                batch.count = 0;
            }
        });
        if batch.count > 0 {
            self.trace_batch(&batch, history, reason);
        }
        self.lap(|seconds| &mut seconds.trace);
    }

    /// Traces samples together.
    fn trace_batch(&mut self, batch: &Batch, history: &KnownHistory, (state, failed): Reason) {
        let guide = history.guide(&self.follower.candidates.lists, &self.follower.lightings);
        let worker = &mut *self.worker;
        let (first, tile) = (history.first(), self.tile);
        if worker.wants_histories {
            batch.samples[..batch.count].iter().for_each(|&[x, y]| worker.note_history_of(tile, x, y));
        }
        let samples = &batch.samples[..batch.count];
        worker.trace_samples(tile, samples, Sight::Met(first), guide, state);
        if worker.wants_causes {
            samples.iter().for_each(|&[x, y]| worker.samples.cause[tile.index(x, y)] = Some(failed));
        }
    }

    /// Calls for every sample of the parts, by column and row of the tile, so that neighbours stay together.
    fn for_each_sample(
        &mut self,
        area: Area,
        parts: Parts,
        primitive: u32,
        mut act: impl FnMut(&mut Self, u32, u32),
    ) {
        let tile = *self.tile;
        self.for_each_area(area, parts, |this, area, is_whole| {
            let (first, last) = (area.x0 - tile.x, area.x1 - tile.x);
            for start in (first..last).step_by(STRIP) {
                for y in area.y0 - tile.y..area.y1 - tile.y {
                    for x in start..last.min(start + STRIP as u32) {
                        if is_whole || this.worker.perspective.primitive[tile.index(x, y)] == primitive {
                            act(this, x, y);
                        }
                    }
                }
            }
        });
    }

    fn for_each_area(&mut self, area: Area, parts: Parts, mut act: impl FnMut(&mut Self, Area, bool)) {
        match parts {
            Parts::All => act(self, area, true),
            Parts::Regions(regions) => {
                regions.iter().for_each(|region: &Region| act(self, region.area, region.is_whole()));
            }
        }
    }

    /// Finds the history of samples that are filled, if that is wanted: one is traced for all.
    fn note_histories(&mut self, area: Area, parts: Parts, primitive: u32) {
        if !self.worker.wants_histories {
            return;
        }
        let mut known = None;
        self.for_each_sample(area, parts, primitive, |this, x, y| {
            let index = this.tile.index(x, y);
            match known {
                Some(history) => this.worker.samples.history[index] = history,
                None => {
                    this.worker.note_history_of(this.tile, x, y);
                    known = Some(this.worker.samples.history[index]);
                }
            }
        });
    }

    /// Fills samples with a colour that is linear over the area.
    pub(super) fn fill(&mut self, area: Area, parts: Parts, primitive: u32, color: &Rgb<Taylor>) {
        self.lap(|seconds| &mut seconds.select);
        self.note_histories(area, parts, primitive);
        let (simd, pattern) = (self.worker.simd, &self.worker.camera.pattern);
        let fill = LinearFill::new(simd, area, pattern, color, self.follower.scene.darkest);
        self.for_each_area(area, parts, |this, part, is_whole| {
            let (x, y) = (part.x0 - this.tile.x, part.y0 - this.tile.y);
            let starts = (0..part.y1 - part.y0).map(|row| this.tile.index(x, y + row));
            let runs = starts.map(|start| start..start + (part.x1 - part.x0) as usize);
            for (row, run) in (part.y0..).zip(runs) {
                let samples = &mut this.worker.samples;
                let (color, state) = (&mut samples.color[run.clone()], &mut samples.state[run.clone()]);
                if is_whole {
                    fill.fill([part.x0, row], color);
                    state.fill(SampleState::Filled);
                    continue;
                }
                let start = fill.start(row);
                let shown = &this.worker.perspective.primitive[run];
                for (((x, shown), color), state) in (part.x0..).zip(shown).zip(color).zip(state) {
                    if *shown == primitive {
                        (*color, *state) = (fill.color(start, x), SampleState::Filled);
                    }
                }
            }
        });
        self.lap(|seconds| &mut seconds.fill);
    }
}

/// Samples to be traced together, by column and row of the tile.
struct Batch {
    samples: [[u32; 2]; MOST_RAYS],
    count: usize,
}

impl Default for Batch {
    fn default() -> Self {
        Self { samples: [[0; 2]; MOST_RAYS], count: 0 }
    }
}

impl Batch {
    fn add(&mut self, x: u32, y: u32) {
        self.samples[self.count] = [x, y];
        self.count += 1;
    }
}
