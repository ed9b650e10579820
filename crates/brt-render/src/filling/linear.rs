//! Filling with a colour model: whole rows in vector instructions.

use std::array::from_fn;

use brt_geometry::{SimdLevel, Taylor};
use brt_image::Rgb;

use crate::products::{Area, SampleGrid, SamplePattern};

const CHANNELS: usize = 3;

/// As many numbers are written at a time: whole samples, and whole vectors.
const AT_A_TIME: usize = 16 * CHANNELS;

/// A colour that is linear over an area.
pub(crate) struct LinearFill {
    simd: SimdLevel,
    area: Area,
    pattern: SamplePattern,
    /// In the middle of the area.
    color: [f64; CHANNELS],
    per_column: [f64; CHANNELS],
    per_row: [f64; CHANNELS],
    /// How much brighter each sample of a row is than its first would be if that lay in the middle of its row, channel
    /// by channel.
    along: [f32; SampleGrid::TILE as usize * CHANNELS],
    /// No colour is darker: where the line is, it is off by at least as much as this.
    darkest: f32,
}

impl LinearFill {
    pub(crate) fn new(
        simd: SimdLevel,
        area: Area,
        pattern: &SamplePattern,
        color: &Rgb<Taylor>,
        darkest: f32,
    ) -> Self {
        let step = |change: f64, half: f64| if half > 0.0 { change / half } else { 0.0 };
        let [half_x, half_y] = area.half_sides(pattern);
        let color = [color.r, color.g, color.b];
        let per_column = color.map(|c| step(c.u, half_x));
        let per_row = color.map(|c| step(c.v, half_y));
        let mut along = [0.0; SampleGrid::TILE as usize * CHANNELS];
        let (right, down) = (per_column.map(|step| step as f32), per_row.map(|step| step as f32));
        for (x, sample) in (area.x0..area.x1).zip(along.as_chunks_mut::<CHANNELS>().0) {
            let (column, shift) = ((x - area.x0) as f32, pattern.shift(x) as f32);
            *sample = from_fn(|i| right[i] * column - down[i] * shift);
        }
        Self { simd, area, pattern: *pattern, color: color.map(|c| c.c), per_column, per_row, along, darkest }
    }

    /// Fills samples of row `y` from column `x` on.
    pub(crate) fn fill(&self, [x, y]: [u32; 2], samples: &mut [[f32; CHANNELS]]) {
        let start = self.start(y);
        let (numbers, darkest) = (samples.as_flattened_mut(), self.darkest);
        let along = &self.along[(x - self.area.x0) as usize * CHANNELS..][..numbers.len()];
        self.simd.run(
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
                        chunk[i] = brighter(starts[i] + along[i], darkest);
                    }
                }
                for ((number, along), start) in rest.iter_mut().zip(along_rest).zip(starts) {
                    *number = brighter(start + along, darkest);
                }
            },
        );
    }

    /// The colour of the sample in column `x` of the row that starts with `start`.
    pub(crate) fn color(&self, start: [f32; CHANNELS], x: u32) -> [f32; CHANNELS] {
        let along = &self.along[(x - self.area.x0) as usize * CHANNELS..];
        from_fn(|i| brighter(start[i] + along[i], self.darkest))
    }

    /// What the first sample of row `y` would have, however dark, if it lay in the middle of the row.
    pub(crate) fn start(&self, y: u32) -> [f32; CHANNELS] {
        let [x, middle] = self.area.middle();
        let (right, down) = (f64::from(self.area.x0) + self.pattern.shift(y) - x, f64::from(y) - middle);
        from_fn(|i| (self.color[i] + self.per_column[i] * right + self.per_row[i] * down) as f32)
    }
}

/// Not `f32::max`: of 0 and −0 that may give either, as instructions have it.
#[inline(always)]
fn brighter(color: f32, darkest: f32) -> f32 {
    if color > darkest { color } else { darkest }
}
