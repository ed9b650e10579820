//! Filling: colours of samples that are not traced, from those of the four chosen ones.

mod linear;

pub(crate) use linear::LinearFill;

use crate::products::{Block, SampleState, Tile, TileSamples};

/// Fills all samples of a block that have no colour yet, bilinearly from its corners.
pub(crate) fn fill_bilinear(tile: &Tile, samples: &mut TileSamples, block: &Block) {
    if samples.alpha.is_some() {
        fill_alpha(tile, samples, block);
    }
    let corner = block.corners().map(|[x, y]| samples.color[tile.index(x, y)]);
    let share = |i: u32, a: u32, b: u32| if b > a { (i - a) as f32 / (b - a) as f32 } else { 0.0 };
    for y in block.y0..=block.y1 {
        let down = share(y, block.y0, block.y1);
        let left = mix(corner[0], corner[2], down);
        let right = mix(corner[1], corner[3], down);
        let row = tile.index(block.x0, y);
        let width = (block.x1 - block.x0) as usize;
        let step = 1.0 / width.max(1) as f32;
        for i in 0..=width {
            if samples.state[row + i] == SampleState::Pending {
                samples.color[row + i] = mix(left, right, i as f32 * step);
                samples.state[row + i] = SampleState::Filled;
            }
        }
    }
}

/// The corners have one ray history, and so one alpha.
fn fill_alpha(tile: &Tile, samples: &mut TileSamples, block: &Block) {
    let corner = tile.index(block.x0, block.y0);
    for y in block.y0..=block.y1 {
        samples.spread_alpha(corner, tile.index(block.x0, y)..tile.index(block.x1, y) + 1);
    }
}

#[inline(always)]
fn mix(a: [f32; 3], b: [f32; 3], share: f32) -> [f32; 3] {
    std::array::from_fn(|i| a[i] + (b[i] - a[i]) * share)
}

/// A colour that changes linearly over the tile: the plane nearest to four samples, kept between their extremes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LinearColor {
    origin: [f32; 2],
    value: [f32; 3],
    per_x: [f32; 3],
    per_y: [f32; 3],
    least: [f32; 3],
    greatest: [f32; 3],
}

impl LinearColor {
    /// Least squares through the colours of four samples (which need not be four different ones).
    pub(crate) fn through(tile: &Tile, samples: &TileSamples, points: &[[u32; 2]; 4]) -> Self {
        let colors = points.map(|[x, y]| samples.color[tile.index(x, y)]);
        let mean = |of: [f32; 4]| 0.25 * (of[0] + of[1] + of[2] + of[3]);
        let origin = [mean(points.map(|p| p[0] as f32)), mean(points.map(|p| p[1] as f32))];
        let (dx, dy) = (points.map(|p| p[0] as f32 - origin[0]), points.map(|p| p[1] as f32 - origin[1]));
        let dot = |a: [f32; 4], b: [f32; 4]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
        let (xx, xy, yy) = (dot(dx, dx), dot(dx, dy), dot(dy, dy));
        let determinant = xx * yy - xy * xy;
        let channel = |i: usize| colors.map(|c| c[i]);
        let slopes = |i: usize| {
            let offsets = channel(i).map(|v| v - mean(channel(i)));
            let (xc, yc) = (dot(dx, offsets), dot(dy, offsets));
            if determinant >= 1.0 {
                [(yy * xc - xy * yc) / determinant, (xx * yc - xy * xc) / determinant]
            } else {
                // All on one line: the colour changes along it only.
                let spread = xx + yy;
                let along = if spread > 0.0 { 1.0 / spread } else { 0.0 };
                [xc * along, yc * along]
            }
        };
        let slope: [[f32; 2]; 3] = std::array::from_fn(slopes);
        Self {
            origin,
            value: std::array::from_fn(|i| mean(channel(i))),
            per_x: std::array::from_fn(|i| slope[i][0]),
            per_y: std::array::from_fn(|i| slope[i][1]),
            least: std::array::from_fn(|i| channel(i).into_iter().fold(f32::INFINITY, f32::min)),
            greatest: std::array::from_fn(|i| channel(i).into_iter().fold(f32::NEG_INFINITY, f32::max)),
        }
    }

    /// The colour of a sample.
    pub(crate) fn at(&self, x: u32, y: u32) -> [f32; 3] {
        let (dx, dy) = (x as f32 - self.origin[0], y as f32 - self.origin[1]);
        std::array::from_fn(|i| {
            let linear = self.value[i] + self.per_x[i] * dx + self.per_y[i] * dy;
            linear.max(self.least[i]).min(self.greatest[i])
        })
    }
}
