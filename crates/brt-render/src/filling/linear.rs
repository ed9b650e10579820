//! Filling with a colour model: whole rows in vector instructions.

use std::array::from_fn;

use brt_geometry::{SimdLevel, Taylor};
use brt_image::Rgb;

use crate::products::{Area, SampleGrid};

const CHANNELS: usize = 3;

/// As many numbers are written at a time: whole samples, and whole vectors.
const AT_A_TIME: usize = 16 * CHANNELS;

/// A colour that is linear over an area.
pub(crate) struct LinearFill {
    area: Area,
    color: [Taylor; CHANNELS],
    per_column: [f64; CHANNELS],
    per_row: [f64; CHANNELS],
    /// How much brighter each sample of a row is than its first, channel by channel.
    along: [f32; SampleGrid::TILE as usize * CHANNELS],
    /// No colour is darker: where the line is, it is off by at least as much as this.
    darkest: f32,
}

impl LinearFill {
    pub(crate) fn new(area: Area, color: &Rgb<Taylor>, darkest: f32) -> Self {
        let step =
            |change: f64, count: u32| if count > 1 { 2.0 * change / f64::from(count - 1) } else { 0.0 };
        let color = [color.r, color.g, color.b];
        let per_column = color.map(|c| step(c.u, area.x1 - area.x0));
        let per_row = color.map(|c| step(c.v, area.y1 - area.y0));
        let mut along = [0.0; SampleGrid::TILE as usize * CHANNELS];
        let steps = per_column.map(|step| step as f32);
        let columns = (area.x1 - area.x0) as usize;
        for (column, sample) in along.as_chunks_mut::<CHANNELS>().0.iter_mut().enumerate().take(columns) {
            *sample = steps.map(|step| step * column as f32);
        }
        Self { area, color, per_column, per_row, along, darkest }
    }

    /// Fills samples of row `y` from column `x` on.
    pub(crate) fn fill(&self, [x, y]: [u32; 2], samples: &mut [[f32; CHANNELS]]) {
        let start = self.start([x, y]);
        let (numbers, darkest) = (samples.as_flattened_mut(), self.darkest);
        let along = &self.along[..numbers.len()];
        SimdLevel::default().run(
            #[inline(always)]
            || {
                let starts: [f32; AT_A_TIME] = from_fn(
                    #[inline(always)]
                    |i| start[i % CHANNELS],
                );
                let (chunks, rest) = numbers.as_chunks_mut::<AT_A_TIME>();
                let (along_chunks, along_rest) = along.as_chunks::<AT_A_TIME>();
                for (chunk, along) in chunks.iter_mut().zip(along_chunks) {
                    for i in 0..AT_A_TIME {
                        chunk[i] = (starts[i] + along[i]).max(darkest);
                    }
                }
                for ((number, along), start) in rest.iter_mut().zip(along_rest).zip(starts) {
                    *number = (start + along).max(darkest);
                }
            },
        );
    }

    /// The colour of the `column`th sample from one on whose colour is `start`.
    pub(crate) fn color(&self, start: [f32; CHANNELS], column: usize) -> [f32; CHANNELS] {
        from_fn(|i| (start[i] + self.along[column * CHANNELS + i]).max(self.darkest))
    }

    /// The colour of a sample.
    pub(crate) fn at(&self, sample: [u32; 2]) -> [f32; CHANNELS] {
        self.start(sample).map(|channel| channel.max(self.darkest))
    }

    /// The colour at a sample, however dark.
    pub(crate) fn start(&self, [x, y]: [u32; 2]) -> [f32; CHANNELS] {
        let (right, down) = (f64::from(x - self.area.x0), f64::from(y - self.area.y0));
        from_fn(|i| {
            let Taylor { c, u, v, .. } = self.color[i];
            (c - u - v + self.per_column[i] * right + self.per_row[i] * down) as f32
        })
    }
}
