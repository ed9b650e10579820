//! Rows of pixels that may have an alpha.

use crate::Rgb;

/// Rows on their way to an encoder or a measure, pixel by pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PixelRows<'a> {
    /// Linear RGB, not clamped; where there is alpha, times alpha (premultiplied).
    pub colors: &'a [[f32; 3]],
    /// How much of each pixel is covered, 0 to 1; `None` if all of all is.
    pub alpha: Option<&'a [f32]>,
}

impl<'a> PixelRows<'a> {
    /// Rows without alpha.
    pub const fn opaque(colors: &'a [[f32; 3]]) -> Self {
        Self { colors, alpha: None }
    }
}

/// The colour of what covers a pixel, from its premultiplied one; black where nothing does.
pub fn straight(color: [f32; 3], alpha: f32) -> [f32; 3] {
    if alpha > 0.0 { color.map(|c| c / alpha) } else { Rgb::BLACK.to_f32() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn straight_colours_are_premultiplied_ones_over_alpha() {
        assert_eq!(straight([0.25, 0.5, 0.0], 0.5), [0.5, 1.0, 0.0]);
        assert_eq!(straight([0.3, 0.2, 7.0], 1.0), [0.3, 0.2, 7.0]);
        assert_eq!(straight([0.0; 3], 0.0), [0.0; 3]);
    }
}
