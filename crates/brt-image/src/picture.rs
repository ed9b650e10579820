//! A picture as it is stored: encoded values, for comparison.

use crate::PictureSize;

/// The stored values, in the file's own encoding.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Samples {
    /// Codes 0 to 255.
    Eight(Vec<[u8; 3]>),
    /// Codes 0 to 65535.
    Sixteen(Vec<[u16; 3]>),
    /// 1 is white; not clamped.
    Float(Vec<[f32; 3]>),
}

/// A picture read from a file, measured in levels of 255 of the file's own encoding: an 8-bit
/// code is its level, a 16-bit code c is level c/257, a float v is level 255 v.
///
/// It is kept as stored, and levels are made when asked for: differences of integer codes are
/// exact that way.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    size: PictureSize,
    samples: Samples,
    /// In steps; `None` if the file has none.
    alpha: Option<Vec<f32>>,
}

/// Steps in a level: differences are taken between codes of 16 bits, whose step this is.
pub(crate) const STEPS_PER_LEVEL: f64 = 257.0;

impl Picture {
    /// The samples must be as many as the pixels.
    pub(crate) fn new(size: PictureSize, samples: Samples) -> Self {
        let picture = Self { size, samples, alpha: None };
        debug_assert_eq!(picture.sample_count() as u64, size.pixels());
        picture
    }

    /// With an alpha for each pixel, in steps.
    pub(crate) fn with_alpha(self, alpha: Option<Vec<f32>>) -> Self {
        debug_assert!(alpha.as_ref().is_none_or(|alpha| alpha.len() == self.sample_count()));
        Self { alpha, ..self }
    }

    fn sample_count(&self) -> usize {
        match &self.samples {
            Samples::Eight(pixels) => pixels.len(),
            Samples::Sixteen(pixels) => pixels.len(),
            Samples::Float(pixels) => pixels.len(),
        }
    }

    /// Width and height.
    pub fn size(&self) -> PictureSize {
        self.size
    }

    /// Levels of red, green and blue of a pixel, counted row after row.
    ///
    /// # Panics
    /// If the picture has no such pixel.
    pub fn levels(&self, pixel_index: usize) -> [f64; 3] {
        self.steps(pixel_index).map(|s| s / STEPS_PER_LEVEL)
    }

    /// The same in steps, which are integers for 8 and 16 bits.
    pub(crate) fn steps(&self, pixel_index: usize) -> [f64; 3] {
        match &self.samples {
            Samples::Eight(pixels) => pixels[pixel_index].map(|v| f64::from(v) * STEPS_PER_LEVEL),
            Samples::Sixteen(pixels) => pixels[pixel_index].map(f64::from),
            Samples::Float(pixels) => pixels[pixel_index].map(|v| f64::from(v) * 65535.0),
        }
    }

    /// Has the file an alpha?
    pub fn has_alpha(&self) -> bool {
        self.alpha.is_some()
    }

    /// Level of the alpha of a pixel; 255, wholly covered, where the file has none.
    ///
    /// # Panics
    /// If the picture has no such pixel.
    pub fn alpha_level(&self, pixel_index: usize) -> f64 {
        self.alpha_steps(pixel_index) / STEPS_PER_LEVEL
    }

    pub(crate) fn alpha_steps(&self, pixel_index: usize) -> f64 {
        self.alpha.as_ref().map_or(65535.0, |alpha| f64::from(alpha[pixel_index]))
    }
}
