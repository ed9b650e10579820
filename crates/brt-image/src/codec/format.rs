//! Which formats are written, and the encoder for each.

use std::path::Path;

use super::error::EncodeError;
use super::exr_write::{ExrEncoder, ExrLayers};
use super::png_write::PngEncoder;
use super::pnm_write::PpmEncoder;
use super::sink::Sink;
use crate::{PictureSize, PixelRows, Transfer};

/// A picture file format that can be written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum PictureFormat {
    /// Portable Network Graphics, RGB or RGBA.
    #[default]
    Png,
    /// Portable pixmap, binary (P6); has no alpha.
    Ppm,
    /// `OpenEXR`, 32-bit float RGB or RGBA, and further layers.
    Exr,
}

impl PictureFormat {
    /// The format meant by a path's extension, in any case; `None` if there is none or it is
    /// unknown.
    pub fn from_path(path: &Path) -> Option<Self> {
        match path.extension()?.to_str()?.to_ascii_lowercase().as_str() {
            "png" => Some(Self::Png),
            "ppm" | "pnm" => Some(Self::Ppm),
            "exr" => Some(Self::Exr),
            _ => None,
        }
    }

    /// The usual extension, without a dot.
    pub const fn extension(self) -> &'static str {
        match self {
            Self::Png => "png",
            Self::Ppm => "ppm",
            Self::Exr => "exr",
        }
    }

    /// Can it hold an alpha?
    pub const fn has_alpha(self) -> bool {
        !matches!(self, Self::Ppm)
    }
}

/// What a pixel is made of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Channels {
    /// Red, green and blue.
    #[default]
    Rgb,
    /// And alpha. It is linear; PNG has straight colours beside it, EXR premultiplied ones, as is usual for each.
    Rgba,
}

/// Bits of a channel in an integer format.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum BitDepth {
    /// Codes 0 to 255.
    #[default]
    Eight,
    /// Codes 0 to 65535.
    Sixteen,
}

/// How much time is given to make files small. The picture is the same.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Compression {
    /// Least time.
    #[default]
    Fast,
    /// Up to a sixth smaller than `Fast` with 8 bits, two fifths with 16, for up to twice the time.
    Balanced,
    /// A fifth to three fifths smaller than `Fast`, for three to six times the time.
    Small,
}

/// How a picture is stored.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Encoding {
    /// The file format.
    pub format: PictureFormat,
    /// Bits of a channel; EXR always has 32-bit floats.
    pub depth: BitDepth,
    /// The transfer function; EXR is always linear and not clamped.
    pub transfer: Transfer,
    /// Of PNG; EXR has one of its own, PPM none.
    pub compression: Compression,
    /// With alpha or without; PPM has none.
    pub channels: Channels,
}

impl Encoding {
    /// The transfer function the file will really have: the identity for EXR.
    pub fn effective_transfer(self) -> Transfer {
        match self.format {
            PictureFormat::Exr => Transfer::Linear,
            PictureFormat::Png | PictureFormat::Ppm => self.transfer,
        }
    }
}

/// An encoder that takes a picture in bands of whole rows, from the top.
///
/// Dropped without [`BandWriter::finish`], or after an error, it leaves no file behind.
pub trait BandWriter: Send {
    /// Encodes the next rows, any number of whole ones, with alpha or without as it was asked for.
    ///
    /// # Errors
    /// If the rows do not fit the picture or the sink fails.
    fn write_pixels(&mut self, rows: PixelRows<'_>) -> Result<(), EncodeError>;

    /// Encodes the next rows of a picture without alpha: linear RGB.
    ///
    /// # Errors
    /// If the rows do not fit the picture or the sink fails.
    fn write(&mut self, rows: &[[f32; 3]]) -> Result<(), EncodeError> {
        self.write_pixels(PixelRows::opaque(rows))
    }

    /// Completes the file and puts it in place.
    ///
    /// # Errors
    /// If rows are missing or the sink fails.
    fn finish(self: Box<Self>) -> Result<(), EncodeError>;

    /// Time spent on compressing and writing so far, summed over threads.
    fn seconds(&self) -> f64;
}

/// The encoder for an encoding.
///
/// Large bands are worked on in parallel, by the rayon pool of the calling thread.
///
/// # Errors
/// If the format cannot hold the size or alpha, or the sink fails.
pub fn encoder(
    sink: Box<dyn Sink>,
    size: PictureSize,
    encoding: Encoding,
) -> Result<Box<dyn BandWriter>, EncodeError> {
    Ok(match (encoding.format, encoding.channels) {
        (PictureFormat::Png, Channels::Rgb) => Box::new(PngEncoder::<3>::new(sink, size, encoding)?),
        (PictureFormat::Png, Channels::Rgba) => Box::new(PngEncoder::<4>::new(sink, size, encoding)?),
        (PictureFormat::Ppm, Channels::Rgb) => Box::new(PpmEncoder::new(sink, size, encoding)?),
        (PictureFormat::Ppm, Channels::Rgba) => return Err(EncodeError::NoAlpha { format: "PPM" }),
        (PictureFormat::Exr, channels) => {
            Box::new(ExrEncoder::new(sink, size, &ExrLayers::beside::<String>(channels, []))?)
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formats_are_known_by_extension() {
        let of = |path: &str| PictureFormat::from_path(Path::new(path));
        assert_eq!(of("a/b.PNG"), Some(PictureFormat::Png));
        assert_eq!(of("b.exr"), Some(PictureFormat::Exr));
        assert_eq!(of("b.ppm"), Some(PictureFormat::Ppm));
        assert_eq!(of("b.jpg"), None);
        assert_eq!(of("png"), None);
    }
}
