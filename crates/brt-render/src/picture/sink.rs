//! Where finished rows go.

use brt_image::{PixelRows, Transfer};

use super::layers::LayerRows;
use crate::error::SinkError;

/// Finished rows of the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Rows {
    /// Number of the first of them, counted from the top.
    pub first: u32,
    /// Pixels per row.
    pub width: u32,
    /// Linear RGB, row by row, not clamped. Without a background this is what the rest adds to a pixel: times alpha.
    pub colors: Vec<[f32; 3]>,
    /// How much of each pixel is covered, if the [backdrop](crate::Backdrop) is transparent.
    pub alpha: Option<Vec<f32>>,
    /// The same rows by full ray tracing; means something in those that [`Settings::checked`](crate::Settings) asks
    /// for. `None` if that is none.
    pub full: Option<Vec<[f32; 3]>>,
    /// Alpha by full ray tracing, if there are both.
    pub full_alpha: Option<Vec<f32>>,
    /// The layers that were asked for, in that order.
    pub layers: Vec<LayerRows>,
}

impl Rows {
    /// Number of rows.
    pub fn count(&self) -> u32 {
        self.colors.len() as u32 / self.width
    }

    /// The picture's pixels.
    pub fn pixels(&self) -> PixelRows<'_> {
        PixelRows { colors: &self.colors, alpha: self.alpha.as_deref() }
    }

    /// Those by full ray tracing.
    pub fn full_pixels(&self) -> Option<PixelRows<'_>> {
        let colors = self.full.as_deref()?;
        Some(PixelRows { colors, alpha: self.full_alpha.as_deref() })
    }
}

/// Takes finished rows, from the top of the picture to its bottom, each once.
///
/// Called on a thread of the rendering's pool while other threads render on: what it does in parallel by `rayon` is done
/// by the same threads.
pub trait Sink: Send {
    /// How the picture will be stored: what a method promises of stored values, it promises after this function.
    ///
    /// Asked once, before the rendering.
    fn transfer(&self) -> Transfer;

    /// Takes rows.
    ///
    /// # Errors
    /// Whatever keeps it from taking them; the rendering ends then.
    fn take(&mut self, rows: &Rows) -> Result<(), SinkError>;
}

/// Keeps all rows: a picture in memory, to be shown as sRGB.
impl Sink for Vec<Rows> {
    fn transfer(&self) -> Transfer {
        Transfer::Srgb
    }

    fn take(&mut self, rows: &Rows) -> Result<(), SinkError> {
        self.push(rows.clone());
        Ok(())
    }
}

/// Keeps all rows of a picture that is stored otherwise.
#[derive(Clone, Debug)]
pub struct KeptRows {
    transfer: Transfer,
    /// What was taken, from the top.
    pub rows: Vec<Rows>,
}

impl KeptRows {
    /// Nothing yet, of a picture that will be stored with this function.
    pub fn new(transfer: Transfer) -> Self {
        Self { transfer, rows: Vec::new() }
    }
}

impl Sink for KeptRows {
    fn transfer(&self) -> Transfer {
        self.transfer
    }

    fn take(&mut self, rows: &Rows) -> Result<(), SinkError> {
        self.rows.take(rows)
    }
}
