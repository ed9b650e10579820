//! Reads PNG: grey, colour and palette, with alpha or without, 1 to 16 bits, interlaced or not.

use std::io::{BufRead, Seek};

use png::{BitDepth, ColorType, Decoder, DecodingError, Limits, Transformations};

use super::error::DecodeProblem;
use super::read::PictureLimits;
use crate::PictureSize;
use crate::picture::{Picture, PixelKind, Samples};

/// Memory the library may take beside the pixels: rows, tables and text.
const SPARE_BYTES: usize = 1 << 26;

/// Reads a picture.
pub(crate) fn read<R: BufRead + Seek>(source: R, limits: PictureLimits) -> Result<Picture, DecodeProblem> {
    let mut decoder = Decoder::new_with_limits(source, Limits { bytes: SPARE_BYTES });
    decoder.set_transformations(Transformations::EXPAND);
    let mut reader = decoder.read_info().map_err(problem)?;
    let (width, height) = reader.info().size();
    let size = PictureSize::new(width, height);
    limits.check(size, "PNG")?;
    let Some(bytes) = reader.output_buffer_size() else {
        return Err(DecodeProblem::LimitExceeded { size, limit: limits.pixels });
    };
    let mut pixels = vec![0; bytes];
    let frame = reader.next_frame(&mut pixels).map_err(problem)?;
    if (frame.width, frame.height) != (width, height) {
        return Err(DecodeProblem::malformed("PNG", "the first frame is not the whole picture"));
    }
    pixels.truncate(frame.buffer_size());
    let kind = PixelKind::of_channels(frame.color_type.samples());
    let Some(kind) = kind.filter(|_| frame.color_type != ColorType::Indexed) else {
        return Err(DecodeProblem::malformed("PNG", "the palette was not expanded"));
    };
    let samples = match frame.bit_depth {
        BitDepth::Eight => Samples::Eight(pixels),
        BitDepth::Sixteen => Samples::Sixteen(pixels),
        depth => return Err(DecodeProblem::malformed("PNG", format!("depth {depth:?} was not expanded"))),
    };
    Ok(Picture::new(size, kind, samples))
}

fn problem(error: DecodingError) -> DecodeProblem {
    match error {
        DecodingError::IoError(error) => error.into(),
        other => DecodeProblem::malformed("PNG", other.to_string()),
    }
}
