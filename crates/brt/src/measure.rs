//! Error of a picture against full ray tracing, measured before quantisation.

use brt_image::{Comparison, DifferenceMeter, Encoding, PictureFormat, WorkClock};
use brt_render::{CheckedPixels, Rows, Settings};
use rayon::prelude::*;

/// How far checked pixels are from full ray tracing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Verification {
    /// Measures over the checked pixels.
    pub comparison: Comparison,
    /// What the errors are held against, in levels of 255: what the method promises, else 1.
    pub limit: f64,
    /// Checked pixels of which some channel differs by more.
    pub above: u64,
    /// Column and row of the pixel that differs most, the first of them.
    pub worst: [u32; 2],
}

/// Measures in levels of 255 of what is stored: after the transfer function, clamped; for EXR neither.
pub(crate) struct ErrorMeasure {
    encoding: Encoding,
    checked: CheckedPixels,
    limit: f64,
    found: Found,
}

/// What is measured of some rows.
#[derive(Clone, Copy, Default)]
struct Found {
    meter: DifferenceMeter,
    above: u64,
    worst: [u32; 2],
    worst_error: f64,
}

impl ErrorMeasure {
    pub(crate) fn new(encoding: Encoding, settings: &Settings) -> Self {
        let limit = settings.method.promised_error().unwrap_or(1.0);
        Self { encoding, checked: settings.checked, limit, found: Found::default() }
    }

    /// Takes rows of the picture and the same by full ray tracing, both linear.
    pub(crate) fn add(&mut self, rows: &Rows, full: &[[f32; 3]], clock: &WorkClock) {
        let width = rows.width as usize;
        // Row by row, so that sums do not depend on the number of threads.
        let parts: Vec<Found> = rows
            .colors
            .par_chunks(width)
            .zip(full.par_chunks(width))
            .zip(rows.first..rows.first + rows.count())
            .filter(|(_, row)| self.checked.includes_row(*row))
            .map(|((colors, full), row)| clock.time(|| self.measured(row, colors, full)))
            .collect();
        for part in &parts {
            self.found.merge(part);
        }
    }

    fn measured(&self, row: u32, colors: &[[f32; 3]], full: &[[f32; 3]]) -> Found {
        let mut found = Found { worst: [0, row], ..Found::default() };
        for (column, (&a, &b)) in (0..).zip(colors.iter().zip(full)) {
            let (a, b) = levels_of_both(self.encoding, a, b);
            found.meter.add_levels(a, b);
            let error = greatest_difference(a, b);
            found.above += u64::from(error > self.limit);
            if error > found.worst_error {
                (found.worst, found.worst_error) = ([column, row], error);
            }
        }
        found
    }

    pub(crate) fn verification(&self) -> Verification {
        let Found { meter, above, worst, .. } = self.found;
        Verification { comparison: meter.comparison(), limit: self.limit, above, worst }
    }
}

impl Found {
    fn merge(&mut self, other: &Self) {
        self.meter.merge(&other.meter);
        self.above += other.above;
        if other.worst_error > self.worst_error {
            (self.worst, self.worst_error) = (other.worst, other.worst_error);
        }
    }
}

/// The greatest difference of any channel; infinite where only one is a number.
fn greatest_difference(a: [f64; 3], b: [f64; 3]) -> f64 {
    let difference = |i: usize| match (a[i] - b[i]).abs() {
        d if d.is_nan() && a[i] != b[i] && !(a[i].is_nan() && b[i].is_nan()) => f64::INFINITY,
        d => d,
    };
    difference(0).max(difference(1)).max(difference(2))
}

/// The greatest difference of any channel of a pixel, in levels.
pub(crate) fn error_levels(encoding: Encoding, a: [f32; 3], b: [f32; 3]) -> f64 {
    let (a, b) = levels_of_both(encoding, a, b);
    greatest_difference(a, b)
}

/// Most pixels are equal: they need no power.
fn levels_of_both(encoding: Encoding, a: [f32; 3], b: [f32; 3]) -> ([f64; 3], [f64; 3]) {
    if a == b { ([0.0; 3], [0.0; 3]) } else { (levels(encoding, a), levels(encoding, b)) }
}

fn levels(encoding: Encoding, color: [f32; 3]) -> [f64; 3] {
    color.map(|c| match encoding.format {
        PictureFormat::Exr => 255.0 * f64::from(c),
        PictureFormat::Png | PictureFormat::Ppm => 255.0 * encoding.transfer.encode(f64::from(c)),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use brt_image::Transfer;

    #[test]
    fn error_is_measured_after_clamping_and_transfer() {
        let linear = Encoding { transfer: Transfer::Linear, ..Encoding::default() };
        assert_eq!(error_levels(linear, [0.0, 0.5, 9.0], [0.0, 0.25, 1.0]), 63.75);
        // 0.001 lies on the straight part of sRGB: 255 * 12.92 * 0.001.
        let error = error_levels(Encoding::default(), [0.001; 3], [0.0; 3]);
        assert!((error - 3.2946).abs() < 1e-6);
        let exr = Encoding { format: PictureFormat::Exr, ..Encoding::default() };
        assert_eq!(error_levels(exr, [2.0, 0.0, 0.0], [1.0, 0.0, 0.0]), 255.0);
    }

    #[test]
    fn pixels_above_the_limit_are_counted_in_checked_rows_only() {
        let linear = Encoding { transfer: Transfer::Linear, ..Encoding::default() };
        let settings = Settings { checked: CheckedPixels::Rows, ..Settings::new([2, 17]) };
        let mut measure = ErrorMeasure::new(linear, &settings);
        let mut colors = vec![[0.0; 3]; 34];
        // Row 1 is not checked; full ray tracing promises 0, so each difference in rows 0 and 16 is above.
        (colors[1], colors[2], colors[32]) = ([1.0; 3], [1.0; 3], [0.5; 3]);
        let rows = Rows { first: 0, width: 2, colors, full: None, layers: Vec::new() };
        measure.add(&rows, &[[0.0; 3]; 34], &WorkClock::default());
        let found = measure.verification();
        assert_eq!((found.comparison.pixels, found.above, found.worst), (4, 2, [1, 0]));
        assert_eq!((found.comparison.max_error, found.limit), (255.0, 0.0));
    }
}
