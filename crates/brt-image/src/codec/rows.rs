//! Counts the rows an encoder has been given.

use super::error::EncodeError;
use super::format::Channels;
use crate::{PictureSize, PixelRows};

/// How much of a picture has come.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RowCount {
    size: PictureSize,
    given: u64,
}

impl RowCount {
    /// Nothing has come yet.
    ///
    /// # Errors
    /// If the picture is empty or larger than `format` can hold: sides are signed 32-bit
    /// numbers in PNG and EXR.
    pub(crate) fn new(size: PictureSize, format: &'static str) -> Result<Self, EncodeError> {
        let fits = |side| (1..=i32::MAX as u32).contains(&side);
        if fits(size.width) && fits(size.height) {
            Ok(Self { size, given: 0 })
        } else {
            Err(EncodeError::Size { size, format })
        }
    }

    /// Pixels in a row.
    pub(crate) fn width(&self) -> usize {
        self.size.width as usize
    }

    /// The count after a band. The caller keeps it once the band is written: a picture with a
    /// failed band never counts as complete.
    ///
    /// # Errors
    /// If the band is no number of whole rows, or too many.
    pub(crate) fn after(&self, pixels: usize) -> Result<Self, EncodeError> {
        let Self { size, given } = *self;
        if !pixels.is_multiple_of(size.width as usize) {
            return Err(EncodeError::PartialRow { pixels, width: size.width });
        }
        let given = given + (pixels / size.width as usize) as u64;
        if given > u64::from(size.height) {
            return Err(EncodeError::RowCount { expected: size.height, given });
        }
        Ok(Self { size, given })
    }

    /// The same for pixels whose alpha comes beside them, or not.
    ///
    /// # Errors
    /// If the band is no number of whole rows, or too many, or alpha is missing or too much.
    pub(crate) fn after_pixels(&self, rows: &PixelRows<'_>, channels: Channels) -> Result<Self, EncodeError> {
        let given = rows.alpha.map_or(0, <[f32]>::len);
        let expected = if channels == Channels::Rgba { rows.colors.len() } else { 0 };
        if given != expected {
            return Err(EncodeError::AlphaCount { expected, given });
        }
        self.after(rows.colors.len())
    }

    /// Has the whole picture come?
    ///
    /// # Errors
    /// If rows are missing.
    pub(crate) fn check_complete(&self) -> Result<(), EncodeError> {
        let Self { size, given } = *self;
        if given == u64::from(size.height) {
            Ok(())
        } else {
            Err(EncodeError::RowCount { expected: size.height, given })
        }
    }
}
