//! Error of a picture against full ray tracing, measured before quantisation.

use std::ops::Range;

use brt_image::{Comparison, DifferenceMeter, Encoding, PictureFormat, PixelRows, WorkClock, straight};
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
    pub(crate) fn add(&mut self, rows: &Rows, full: PixelRows, clock: &WorkClock) {
        let (width, picture) = (rows.width as usize, rows.pixels());
        // Row by row, so that sums do not depend on the number of threads.
        let parts: Vec<Found> = (0..rows.count() as usize)
            .into_par_iter()
            .map(|row| (rows.first + row as u32, row * width..(row + 1) * width))
            .filter(|(row, _)| self.checked.includes_row(*row))
            .map(|(row, run)| clock.time(|| self.measured(row, part(picture, &run), part(full, &run))))
            .collect();
        for part in &parts {
            self.found.merge(part);
        }
    }

    fn measured(&self, row: u32, picture: PixelRows, full: PixelRows) -> Found {
        let mut found = Found { worst: [0, row], ..Found::default() };
        for (column, index) in (0..).zip(0..picture.colors.len()) {
            let error = found.add(levels_of_both(self.encoding, picture, full, index));
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
    /// Takes a pixel; says how far it is off.
    fn add(&mut self, levels: LevelsOfBoth) -> f64 {
        match levels {
            LevelsOfBoth::Opaque([a, b]) => self.meter.add_levels(a, b),
            LevelsOfBoth::WithAlpha([a, b]) => self.meter.add_levels(a, b),
        }
        levels.greatest_difference()
    }

    fn merge(&mut self, other: &Self) {
        self.meter.merge(&other.meter);
        self.above += other.above;
        if other.worst_error > self.worst_error {
            (self.worst, self.worst_error) = (other.worst, other.worst_error);
        }
    }
}

/// A pixel of the picture and the same by full ray tracing.
#[derive(Clone, Copy)]
enum LevelsOfBoth {
    Opaque([[f64; 3]; 2]),
    WithAlpha([[f64; 4]; 2]),
}

impl LevelsOfBoth {
    fn greatest_difference(&self) -> f64 {
        match self {
            Self::Opaque([a, b]) => greatest_difference(a, b),
            Self::WithAlpha([a, b]) => greatest_difference(a, b),
        }
    }
}

/// The greatest difference of any channel; infinite where only one is a number, itself none where none is.
fn greatest_difference(a: &[f64], b: &[f64]) -> f64 {
    let difference = |(a, b): (&f64, &f64)| match (a - b).abs() {
        d if d.is_nan() && a != b && !(a.is_nan() && b.is_nan()) => f64::INFINITY,
        d => d,
    };
    a.iter().zip(b).map(difference).fold(f64::NAN, f64::max)
}

/// The greatest difference of any channel of each pixel, alpha included, in levels.
pub(crate) fn error_levels<'a>(
    encoding: Encoding,
    picture: PixelRows<'a>,
    full: PixelRows<'a>,
) -> impl Iterator<Item = f64> + 'a {
    let of = move |i| levels_of_both(encoding, picture, full, i).greatest_difference();
    (0..picture.colors.len()).map(of)
}

/// Most pixels are equal: they need no power.
fn levels_of_both(encoding: Encoding, picture: PixelRows, full: PixelRows, i: usize) -> LevelsOfBoth {
    let (a, b) = (picture.colors[i], full.colors[i]);
    match (picture.alpha, full.alpha) {
        (Some(alpha), Some(full)) if (a, alpha[i]) == (b, full[i]) => LevelsOfBoth::WithAlpha([[0.0; 4]; 2]),
        (Some(alpha), Some(full)) => LevelsOfBoth::WithAlpha([
            levels_with_alpha(encoding, a, alpha[i]),
            levels_with_alpha(encoding, b, full[i]),
        ]),
        _ if a == b => LevelsOfBoth::Opaque([[0.0; 3]; 2]),
        _ => LevelsOfBoth::Opaque([levels(encoding, a), levels(encoding, b)]),
    }
}

/// Of the colour as the file has it, and of alpha.
fn levels_with_alpha(encoding: Encoding, color: [f32; 3], alpha: f32) -> [f64; 4] {
    let stored = match encoding.format {
        PictureFormat::Exr => color,
        PictureFormat::Png | PictureFormat::Ppm => straight(color, alpha),
    };
    let [r, g, b] = levels(encoding, stored);
    [r, g, b, 255.0 * f64::from(alpha)]
}

fn levels(encoding: Encoding, color: [f32; 3]) -> [f64; 3] {
    color.map(|c| match encoding.format {
        PictureFormat::Exr => 255.0 * f64::from(c),
        PictureFormat::Png | PictureFormat::Ppm => 255.0 * encoding.transfer.encode(f64::from(c)),
    })
}

/// Some of the pixels.
fn part<'a>(rows: PixelRows<'a>, run: &Range<usize>) -> PixelRows<'a> {
    PixelRows { colors: &rows.colors[run.clone()], alpha: rows.alpha.map(|alpha| &alpha[run.clone()]) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use brt_image::Transfer;

    fn exr() -> Encoding {
        Encoding { format: PictureFormat::Exr, ..Encoding::default() }
    }

    type Pixel = ([f32; 3], Option<f32>);

    /// The error of a pixel.
    fn error(encoding: Encoding, a: Pixel, b: Pixel) -> f64 {
        let [a_alpha, b_alpha] = [a, b].map(|pixel| pixel.1.map(|alpha| [alpha]));
        let a = PixelRows { colors: &[a.0], alpha: a_alpha.as_ref().map(|alpha| &alpha[..]) };
        let b = PixelRows { colors: &[b.0], alpha: b_alpha.as_ref().map(|alpha| &alpha[..]) };
        error_levels(encoding, a, b).fold(0.0, f64::max)
    }

    #[test]
    fn error_is_measured_after_clamping_and_transfer() {
        let linear = Encoding { transfer: Transfer::Linear, ..Encoding::default() };
        assert_eq!(error(linear, ([0.0, 0.5, 9.0], None), ([0.0, 0.25, 1.0], None)), 63.75);
        // 0.001 lies on the straight part of sRGB: 255 * 12.92 * 0.001.
        let small = error(Encoding::default(), ([0.001; 3], None), ([0.0; 3], None));
        assert!((small - 3.2946).abs() < 1e-6);
        assert_eq!(error(exr(), ([2.0, 0.0, 0.0], None), ([1.0, 0.0, 0.0], None)), 255.0);
    }

    #[test]
    fn with_alpha_the_error_is_that_of_what_the_file_has() {
        let linear = Encoding { transfer: Transfer::Linear, ..Encoding::default() };
        // Straight: 0.25 / 0.25 and 0.125 / 0.25, so half of white apart.
        let (a, b) = (([0.25, 0.0, 0.0], Some(0.25)), ([0.125, 0.0, 0.0], Some(0.25)));
        assert_eq!(error(linear, a, b), 127.5);
        // Premultiplied as they are.
        assert_eq!(error(exr(), a, b), 0.125 * 255.0);
        // One colour, two alphas.
        assert_eq!(error(linear, ([0.5; 3], Some(1.0)), ([0.25; 3], Some(0.5))), 127.5);
        assert_eq!(error(linear, a, a), 0.0);
    }

    #[test]
    fn pixels_above_the_limit_are_counted_in_checked_rows_only() {
        let linear = Encoding { transfer: Transfer::Linear, ..Encoding::default() };
        let settings = Settings { checked: CheckedPixels::Rows, ..Settings::new([2, 17]) };
        let mut measure = ErrorMeasure::new(linear, &settings);
        let mut colors = vec![[0.0; 3]; 34];
        // Row 1 is not checked; full ray tracing promises 0, so each difference in rows 0 and 16 is above.
        (colors[1], colors[2], colors[32]) = ([1.0; 3], [1.0; 3], [0.5; 3]);
        let rows = Rows {
            first: 0,
            width: 2,
            colors,
            alpha: None,
            full: None,
            full_alpha: None,
            layers: Vec::new(),
        };
        measure.add(&rows, PixelRows::opaque(&[[0.0; 3]; 34]), &WorkClock::default());
        let found = measure.verification();
        assert_eq!((found.comparison.pixels, found.above, found.worst), (4, 2, [1, 0]));
        assert_eq!((found.comparison.max_error, found.limit), (255.0, 0.0));
    }
}
