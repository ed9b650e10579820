//! Error of a picture against full ray tracing, measured before quantisation.

use brt_image::{Comparison, DifferenceMeter, Encoding, PictureFormat};
use rayon::prelude::*;

/// Pixels measured by one task. Fixed, so that sums do not depend on the number of threads.
const TASK_PIXELS: usize = 1 << 12;

/// Measures in levels of 255 of what is stored: after the transfer function, clamped; for EXR neither.
pub(crate) struct ErrorMeasure {
    encoding: Encoding,
    meter: DifferenceMeter,
}

impl ErrorMeasure {
    pub(crate) fn new(encoding: Encoding) -> Self {
        Self { encoding, meter: DifferenceMeter::default() }
    }

    /// Takes pixels of the picture and the same by full ray tracing, both linear.
    pub(crate) fn add(&mut self, colors: &[[f32; 3]], full: &[[f32; 3]]) {
        let encoding = self.encoding;
        let parts: Vec<DifferenceMeter> = colors
            .par_chunks(TASK_PIXELS)
            .zip(full.par_chunks(TASK_PIXELS))
            .map(|(colors, full)| {
                let mut meter = DifferenceMeter::default();
                for (&a, &b) in colors.iter().zip(full) {
                    let (a, b) = levels_of_both(encoding, a, b);
                    meter.add_levels(a, b);
                }
                meter
            })
            .collect();
        for part in &parts {
            self.meter.merge(part);
        }
    }

    pub(crate) fn comparison(&self) -> Comparison {
        self.meter.comparison()
    }
}

/// The greatest difference of any channel of a pixel, in levels.
pub(crate) fn error_levels(encoding: Encoding, a: [f32; 3], b: [f32; 3]) -> f64 {
    let (a, b) = levels_of_both(encoding, a, b);
    (0..3).map(|i| (a[i] - b[i]).abs()).fold(0.0, f64::max)
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
    fn pixels_over_the_levels_are_counted() {
        let linear = Encoding { transfer: Transfer::Linear, ..Encoding::default() };
        let mut measure = ErrorMeasure::new(linear);
        measure.add(&[[0.0; 3], [1.0; 3]], &[[0.0; 3], [0.0; 3]]);
        let comparison = measure.comparison();
        assert_eq!((comparison.pixels, comparison.over_10, comparison.max_error), (2, 1, 255.0));
    }
}
