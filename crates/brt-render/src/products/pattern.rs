//! Where the samples of a pixel lie.

/// A rotated grid: samples stand in columns and rows that lean by one sample over the pixel, so that no two samples of a
/// pixel have the same height or the same distance from its left side ("n rooks": Shirley 1991). An edge that is nearly
/// upright or level passes them one by one, where it would pass a whole column of a grid that stands straight.
///
/// Positions are in columns and rows of samples; a shift is never more than half of one, and those of a pixel sum up to 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct SamplePattern {
    /// Samples along a pixel's side, less one: for the remainder of a division by a power of two.
    mask: u32,
    step: f64,
    first: f64,
}

impl SamplePattern {
    /// The pattern of pixels with `per_side` × `per_side` samples, a power of two.
    pub(crate) fn new(per_side: u32) -> Self {
        let step = 1.0 / f64::from(per_side);
        Self { mask: per_side - 1, step, first: -0.5 * (1.0 - step) }
    }

    /// Where a sample lies, given its column and row.
    #[inline(always)]
    pub(crate) fn position(&self, [x, y]: [u32; 2]) -> [f64; 2] {
        [f64::from(x) + self.shift(y), f64::from(y) - self.shift(x)]
    }

    /// How far samples of this row lie right of their column; those of this column above their row. Exact.
    #[inline(always)]
    pub(crate) fn shift(&self, row: u32) -> f64 {
        self.first + self.step * f64::from(row & self.mask)
    }

    /// The greatest shift.
    pub(crate) fn reach(&self) -> f64 {
        -self.first
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_samples_of_a_pixel_share_a_column_or_a_row() {
        for n in [1, 2, 4, 8, 16] {
            let pattern = SamplePattern::new(n);
            // The fifth pixel of a row, in units of the finest columns: n² of them to a pixel.
            let finest = |place: f64| (place + 0.5) * f64::from(n) - 0.5;
            let mut taken = [vec![0; (n * n) as usize], vec![0; (n * n) as usize]];
            for (x, y) in (0..n * n).map(|i| (i % n, i / n)) {
                let [right, down] = pattern.position([4 * n + x, y]);
                taken[0][finest(right - f64::from(4 * n)) as usize] += 1;
                taken[1][finest(down) as usize] += 1;
            }
            assert!(taken.iter().flatten().all(|&count| count == 1), "{n}: {taken:?}");
        }
    }

    #[test]
    fn one_sample_is_in_the_middle() {
        assert_eq!(SamplePattern::new(1).position([3, 7]), [3.0, 7.0]);
    }
}
