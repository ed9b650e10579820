//! Pictures in memory: a whole one, and a band of whole rows that streams to an encoder.

use thiserror::Error;

/// Width and height of a picture in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct PictureSize {
    /// Pixels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
}

impl PictureSize {
    /// The size `width` × `height`.
    pub const fn new(width: u32, height: u32) -> Self {
        Self { width, height }
    }

    /// The number of pixels.
    pub const fn pixels(self) -> u64 {
        self.width as u64 * self.height as u64
    }
}

impl std::fmt::Display for PictureSize {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}×{}", self.width, self.height)
    }
}

/// The pixels given do not fill the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("a picture of {size} needs {} pixels, not {given}", size.pixels())]
pub struct PixelCountError {
    /// The size asked for.
    pub size: PictureSize,
    /// The number of pixels given.
    pub given: usize,
}

/// A whole picture in linear RGB, rows from the top, pixels from the left, not clamped.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    size: PictureSize,
    pixels: Vec<[f32; 3]>,
}

impl Image {
    /// A black picture.
    ///
    /// # Panics
    /// If its pixels do not fit the address space.
    pub fn black(size: PictureSize) -> Self {
        let count = usize::try_from(size.pixels()).expect("the picture fits the address space");
        Self { size, pixels: vec![[0.0; 3]; count] }
    }

    /// A picture of the given pixels.
    ///
    /// # Errors
    /// If their number is not `width * height`.
    pub fn try_new(size: PictureSize, pixels: Vec<[f32; 3]>) -> Result<Self, PixelCountError> {
        if pixels.len() as u64 == size.pixels() {
            Ok(Self { size, pixels })
        } else {
            Err(PixelCountError { size, given: pixels.len() })
        }
    }

    /// Width and height.
    pub fn size(&self) -> PictureSize {
        self.size
    }

    /// All pixels, row after row.
    pub fn pixels(&self) -> &[[f32; 3]] {
        &self.pixels
    }

    /// All pixels, row after row.
    pub fn pixels_mut(&mut self) -> &mut [[f32; 3]] {
        &mut self.pixels
    }

    /// All pixels, row after row.
    pub fn into_pixels(self) -> Vec<[f32; 3]> {
        self.pixels
    }

    /// The whole rows from `first_row` on, at most `rows` of them; empty below the picture.
    pub fn band(&self, first_row: u32, rows: u32) -> Band<'_> {
        let width = self.size.width as usize;
        let first = first_row.min(self.size.height);
        let end = first.saturating_add(rows).min(self.size.height);
        let pixels = &self.pixels[first as usize * width..end as usize * width];
        Band { first_row: first, width: self.size.width, pixels }
    }
}

/// Some whole rows of a picture, in linear RGB.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Band<'a> {
    /// The row of the picture that the band starts with.
    pub first_row: u32,
    /// Pixels in a row.
    pub width: u32,
    /// Row after row; a multiple of `width`.
    pub pixels: &'a [[f32; 3]],
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bands_tile_the_picture() {
        let size = PictureSize::new(3, 5);
        let pixels: Vec<_> = (0..15).map(|i| [i as f32; 3]).collect();
        let image = Image::try_new(size, pixels.clone()).unwrap();
        let bands: Vec<_> = (0..4).flat_map(|i| image.band(2 * i, 2).pixels.iter().copied()).collect();
        assert_eq!(bands, pixels);
        assert!(image.band(9, 2).pixels.is_empty());
    }

    #[test]
    fn a_wrong_number_of_pixels_is_refused() {
        let error = Image::try_new(PictureSize::new(2, 2), vec![]).unwrap_err();
        assert_eq!(error.to_string(), "a picture of 2×2 needs 4 pixels, not 0");
    }
}
