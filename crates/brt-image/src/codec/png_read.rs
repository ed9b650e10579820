//! Reads PNG: grey, colour and palette, with alpha or without, 1 to 16 bits, interlaced or not.

use std::io::{BufRead, Seek};

use png::{BitDepth, ColorType, Decoder, DecodingError, Limits, OutputInfo, Transformations};

use super::error::DecodeProblem;
use super::read::PictureLimits;
use crate::PictureSize;
use crate::picture::{Picture, Samples};

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
    let channels = frame.color_type.samples();
    let bytes = &pixels[..frame.buffer_size()];
    let samples = samples(bytes, &frame, channels)?;
    Ok(Picture::new(size, samples).with_alpha(alpha(bytes, &frame, channels)))
}

/// The last of two or four channels, in steps.
fn alpha(bytes: &[u8], frame: &OutputInfo, channels: usize) -> Option<Vec<f32>> {
    if !channels.is_multiple_of(2) {
        return None;
    }
    if frame.bit_depth == BitDepth::Sixteen {
        let last = |p: &[u8]| f32::from(u16::from_be_bytes([p[2 * channels - 2], p[2 * channels - 1]]));
        return Some(bytes.chunks_exact(2 * channels).map(last).collect());
    }
    let last = |p: &[u8]| f32::from(u16::from(p[channels - 1]) * 257);
    Some(bytes.chunks_exact(channels).map(last).collect())
}

fn samples(bytes: &[u8], frame: &OutputInfo, channels: usize) -> Result<Samples, DecodeProblem> {
    if frame.color_type == ColorType::Indexed {
        return Err(DecodeProblem::malformed("PNG", "the palette was not expanded"));
    }
    match frame.bit_depth {
        BitDepth::Eight => {
            let pixel = |p: &[u8]| if channels < 3 { [p[0]; 3] } else { [p[0], p[1], p[2]] };
            Ok(Samples::Eight(bytes.chunks_exact(channels).map(pixel).collect()))
        }
        BitDepth::Sixteen => {
            let value = |p: &[u8], i: usize| u16::from_be_bytes([p[2 * i], p[2 * i + 1]]);
            let pixel = |p: &[u8]| {
                if channels < 3 { [value(p, 0); 3] } else { [value(p, 0), value(p, 1), value(p, 2)] }
            };
            Ok(Samples::Sixteen(bytes.chunks_exact(2 * channels).map(pixel).collect()))
        }
        depth => Err(DecodeProblem::malformed("PNG", format!("depth {depth:?} was not expanded"))),
    }
}

fn problem(error: DecodingError) -> DecodeProblem {
    match error {
        DecodingError::IoError(error) => error.into(),
        other => DecodeProblem::malformed("PNG", other.to_string()),
    }
}
