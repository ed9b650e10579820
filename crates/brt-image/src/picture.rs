//! A picture as it is stored: encoded values, for comparison.

use crate::PictureSize;

/// The stored values, channels of a pixel side by side.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Samples {
    /// Codes 0 to 255.
    Eight(Vec<u8>),
    /// Codes 0 to 65535, two bytes each, the most significant one first, as PNG and PNM have them.
    Sixteen(Vec<u8>),
    /// 1 is white; not clamped.
    Float(Vec<f32>),
}

/// What a pixel is made of in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PixelKind {
    Grey,
    GreyAlpha,
    Rgb,
    Rgba,
}

impl PixelKind {
    /// The kind with so many channels.
    pub(crate) fn of_channels(channels: usize) -> Option<Self> {
        [Self::Grey, Self::GreyAlpha, Self::Rgb, Self::Rgba]
            .into_iter()
            .find(|kind| kind.channels() == channels)
    }

    pub(crate) fn channels(self) -> usize {
        match self {
            Self::Grey => 1,
            Self::GreyAlpha => 2,
            Self::Rgb => 3,
            Self::Rgba => 4,
        }
    }

    fn has_alpha(self) -> bool {
        matches!(self, Self::GreyAlpha | Self::Rgba)
    }

    /// Which of its channels are red, green and blue.
    fn colors(self) -> [usize; 3] {
        match self {
            Self::Grey | Self::GreyAlpha => [0; 3],
            Self::Rgb | Self::Rgba => [0, 1, 2],
        }
    }
}

/// A picture read from a file, measured in levels of 255 of the file's own encoding: an 8-bit
/// code is its level, a 16-bit code c is level c/257, a float v is level 255 v.
///
/// It is kept as stored, and levels are made when asked for: that takes least memory, and differences of integer codes
/// are exact.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    size: PictureSize,
    kind: PixelKind,
    samples: Samples,
}

/// Steps in a level: differences are taken between codes of 16 bits, whose step this is.
pub(crate) const STEPS_PER_LEVEL: f64 = 257.0;

impl Picture {
    /// The samples must be as many as the channels of all pixels.
    pub(crate) fn new(size: PictureSize, kind: PixelKind, samples: Samples) -> Self {
        let count = match &samples {
            Samples::Eight(codes) => codes.len(),
            Samples::Sixteen(bytes) => bytes.len() / 2,
            Samples::Float(values) => values.len(),
        };
        debug_assert_eq!(count as u64, size.pixels() * kind.channels() as u64);
        Self { size, kind, samples }
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
        self.kind.colors().map(|channel| self.channel_steps(pixel_index, channel))
    }

    fn channel_steps(&self, pixel_index: usize, channel: usize) -> f64 {
        let index = pixel_index * self.kind.channels() + channel;
        match &self.samples {
            Samples::Eight(codes) => f64::from(codes[index]) * STEPS_PER_LEVEL,
            Samples::Sixteen(bytes) => {
                f64::from(u16::from_be_bytes([bytes[2 * index], bytes[2 * index + 1]]))
            }
            Samples::Float(values) => f64::from(values[index]) * 65535.0,
        }
    }

    /// Has the file an alpha?
    pub fn has_alpha(&self) -> bool {
        self.kind.has_alpha()
    }

    /// Level of the alpha of a pixel; 255, wholly covered, where the file has none.
    ///
    /// # Panics
    /// If the picture has no such pixel.
    pub fn alpha_level(&self, pixel_index: usize) -> f64 {
        self.alpha_steps(pixel_index) / STEPS_PER_LEVEL
    }

    pub(crate) fn alpha_steps(&self, pixel_index: usize) -> f64 {
        if !self.has_alpha() {
            return 65535.0;
        }
        self.channel_steps(pixel_index, self.kind.channels() - 1)
    }
}
