//! Reconstruction filters: how samples become pixels.

use std::ops::Range;

use brt_geometry::SimdLevel;

use super::mean::means;
use crate::products::{SampleGrid, Tile};
use crate::settings::Filter;

impl Filter {
    /// Weight at a distance in pixels along one axis.
    fn weight(self, distance: f64) -> f64 {
        match self {
            Self::Box => f64::from(distance.abs() <= 0.5),
            Self::Gaussian if distance.abs() <= 1.0 => libm::exp(-2.0 * distance * distance),
            Self::Gaussian => 0.0,
        }
    }
}

/// Shares of a tile's samples in pixels: its own and, with wide filters, those around it. Colours have three channels,
/// alpha has one.
pub(crate) struct TileShares<const N: usize> {
    /// First pixel column and row; may be −1.
    pub(crate) x: i64,
    pub(crate) y: i64,
    pub(crate) width: u32,
    pub(crate) values: Vec<[f32; N]>,
}

/// Applies the box filter to a tile, whose part of the picture's rows is given.
pub(crate) fn reduce_into(
    simd: SimdLevel,
    grid: &SampleGrid,
    tile: &Tile,
    samples: &[[f32; 3]],
    rows: &mut [&mut [[f32; 3]]],
) {
    if grid.per_side > 1 {
        return means(simd, grid, tile, samples, |row, pixels| rows[row].copy_from_slice(pixels));
    }
    for (row, samples) in rows.iter_mut().zip(samples.chunks_exact(tile.width as usize)) {
        row.copy_from_slice(samples);
    }
}

/// Applies the filter to a tile.
pub(crate) fn reduce<const N: usize>(
    simd: SimdLevel,
    filter: Filter,
    grid: &SampleGrid,
    tile: &Tile,
    samples: &[[f32; N]],
) -> TileShares<N> {
    let n = grid.per_side;
    let margin = filter.margin();
    let (width, height) = (tile.width / n + 2 * margin, tile.height / n + 2 * margin);
    let (x, y) = (i64::from(tile.x / n) - i64::from(margin), i64::from(tile.y / n) - i64::from(margin));
    if filter == Filter::Box {
        let mut values = Vec::with_capacity((width * height) as usize);
        means(simd, grid, tile, samples, |_, pixels| values.extend_from_slice(pixels));
        return TileShares { x, y, width, values };
    }
    // Separable: first along rows of samples, then down the columns.
    let along = Axis::new(filter, n, x, width, tile.width, picture_span(grid, 0));
    let down = Axis::new(filter, n, y, height, tile.height, picture_span(grid, 1));
    let mut rows = vec![[0.0_f64; N]; (width * tile.height) as usize];
    for (row, sums) in samples.chunks_exact(tile.width as usize).zip(rows.chunks_exact_mut(width as usize)) {
        for share in &along.shares {
            add(&mut sums[share.pixel], row[share.sample].map(f64::from), share.weight);
        }
    }
    let mut values = vec![[0.0_f64; N]; (width * height) as usize];
    for share in &down.shares {
        for column in 0..width as usize {
            let source = rows[share.sample * width as usize + column];
            add(&mut values[share.pixel * width as usize + column], source, share.weight);
        }
    }
    let values = values.into_iter().map(|c| c.map(|v| v as f32)).collect();
    TileShares { x, y, width, values }
}

/// The same for alpha.
pub(crate) fn reduce_alpha(
    simd: SimdLevel,
    filter: Filter,
    grid: &SampleGrid,
    tile: &Tile,
    samples: &[f32],
) -> TileShares<1> {
    reduce(simd, filter, grid, tile, samples.as_chunks::<1>().0)
}

#[inline(always)]
fn add<const N: usize>(sum: &mut [f64; N], value: [f64; N], weight: f64) {
    for (s, v) in sum.iter_mut().zip(value) {
        *s += v * weight;
    }
}

/// The whole picture's pixels along an axis, counted from the grid's first.
fn picture_span(grid: &SampleGrid, axis: usize) -> Range<i64> {
    let first = -(grid.first[axis] as i64);
    first..first + grid.picture[axis] as i64
}

/// Weights of samples in pixels along one axis of a tile.
struct Axis {
    shares: Vec<Share>,
}

struct Share {
    sample: usize,
    pixel: usize,
    weight: f64,
}

impl Axis {
    /// `first` is the first pixel of `pixels`; the tile has `samples`; the whole picture has these pixels.
    fn new(filter: Filter, n: u32, first: i64, pixels: u32, samples: u32, picture: Range<i64>) -> Self {
        let margin = i64::from(filter.margin());
        let n = i64::from(n);
        // Distance from a pixel's middle to the sample `s` of the pixel `offset` further on.
        let distance = |offset: i64, s: i64| offset as f64 + (s as f64 + 0.5) / n as f64 - 0.5;
        let mut shares = Vec::new();
        for pixel in 0..i64::from(pixels) {
            let place = first + pixel;
            if !picture.contains(&place) {
                continue;
            }
            let weights = |offset: i64| (0..n).map(move |s| filter.weight(distance(offset, s)));
            // Samples outside the picture do not exist; the others share their weight.
            let inside = |offset: &i64| picture.contains(&(place + offset));
            let total: f64 = (-margin..=margin).filter(inside).flat_map(weights).sum();
            for offset in (-margin..=margin).filter(inside) {
                for (s, weight) in (0..n).zip(weights(offset)) {
                    let sample = (pixel - margin + offset) * n + s;
                    if (0..i64::from(samples)).contains(&sample) && weight > 0.0 {
                        let (sample, pixel) = (sample as usize, pixel as usize);
                        shares.push(Share { sample, pixel, weight: weight / total });
                    }
                }
            }
        }
        Self { shares }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::settings::Samples;

    /// Shares of all tiles summed up per pixel, for samples of colour 1.
    fn sums(filter: Filter, size: [u32; 2], samples: Samples) -> Vec<f64> {
        let grid = SampleGrid::new(size, samples);
        let mut sums = vec![0.0; (size[0] * size[1]) as usize];
        for band in 0..grid.bands() {
            for column in 0..grid.tiles_wide() {
                let tile = Tile::at(&grid, column, band);
                let part =
                    reduce(SimdLevel::Widest, filter, &grid, &tile, &vec![[1.0; 3]; tile.sample_count()]);
                for (i, c) in part.values.iter().enumerate() {
                    let (x, y) = (
                        part.x + i64::from(i as u32 % part.width),
                        part.y + i64::from(i as u32 / part.width),
                    );
                    if (0..i64::from(size[0])).contains(&x) && (0..i64::from(size[1])).contains(&y) {
                        sums[(y * i64::from(size[0]) + x) as usize] += f64::from(c[0]);
                    }
                }
            }
        }
        sums
    }

    #[test]
    fn weights_of_every_pixel_sum_up_to_one_also_at_borders_and_between_tiles() {
        for filter in [Filter::Box, Filter::Gaussian] {
            for samples in Samples::ALL {
                let sums = sums(filter, [70, 35], samples);
                assert!(sums.iter().all(|s| (s - 1.0).abs() < 1e-6), "{filter:?} {samples:?}");
            }
        }
    }

    #[test]
    fn box_filter_is_the_mean() {
        let grid = SampleGrid::new([1, 1], Samples::Four);
        let tile = Tile::at(&grid, 0, 0);
        let samples = [[0.0; 3], [1.0; 3], [2.0; 3], [5.0; 3]];
        // (0 + 1 + 2 + 5) / 4
        assert_eq!(reduce(SimdLevel::Widest, Filter::Box, &grid, &tile, &samples).values, [[2.0; 3]]);
    }
}
