//! The box filter: a pixel is the mean of its own samples.

use brt_geometry::SimdLevel;

use crate::products::{SampleGrid, Tile};

/// Means of the samples of a tile's pixels, row by row: `keep` is given the row's number and its pixels.
pub(super) fn means<const N: usize>(
    simd: SimdLevel,
    grid: &SampleGrid,
    tile: &Tile,
    samples: &[[f32; N]],
    mut keep: impl FnMut(usize, &[[f32; N]]),
) {
    let (n, width) = (grid.per_side as usize, tile.width as usize);
    let mut sums = vec![[0.0; N]; width];
    let mut pixels = vec![[0.0; N]; width / n];
    for (i, rows) in samples.chunks_exact(n * width).enumerate() {
        simd.run(
            #[inline(always)]
            || add_up(rows, &mut sums, &mut pixels, n),
        );
        keep(i, &pixels);
    }
}

/// The pixels of `n` rows of samples. `sums` is working memory for a row.
#[inline(always)]
fn add_up<const N: usize>(rows: &[[f32; N]], sums: &mut [[f64; N]], pixels: &mut [[f32; N]], n: usize) {
    sums.fill([0.0; N]);
    for row in rows.chunks_exact(sums.len()) {
        for (sum, sample) in sums.as_flattened_mut().iter_mut().zip(row.as_flattened()) {
            *sum += f64::from(*sample);
        }
    }
    let share = 1.0 / (n * n) as f64;
    for (pixel, sums) in pixels.iter_mut().zip(sums.chunks_exact(n)) {
        let mut sum = [0.0; N];
        for sums in sums {
            for i in 0..N {
                sum[i] += sums[i];
            }
        }
        for i in 0..N {
            pixel[i] = (sum[i] * share) as f32;
        }
    }
}
