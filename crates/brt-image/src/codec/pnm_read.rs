//! Reads binary PPM (P6) and PGM (P5), with comments in the header and any largest value.

use std::io::BufRead;

use super::error::DecodeProblem;
use super::read::{PictureLimits, read_bytes};
use crate::PictureSize;
use crate::picture::{Picture, Samples};

/// Reads a picture.
pub(crate) fn read(mut source: impl BufRead, limits: PictureLimits) -> Result<Picture, DecodeProblem> {
    byte(&mut source)?;
    let channels = if byte(&mut source)? == b'6' { 3 } else { 1 };
    let size = PictureSize::new(number(&mut source)?, number(&mut source)?);
    let max = number(&mut source)?;
    let pixels = limits.check(size, "PNM")?;
    if !(1..=65535).contains(&max) {
        return Err(DecodeProblem::malformed("PNM", format!("largest value {max}")));
    }
    let value_bytes = if max < 256 { 1 } else { 2 };
    let bytes = pixels.checked_mul(channels * value_bytes);
    let bytes = bytes.ok_or(DecodeProblem::LimitExceeded { size, limit: limits.pixels })?;
    let bytes = read_bytes(&mut source, bytes)?;
    Ok(Picture::new(size, samples(&bytes, channels, max)))
}

fn samples(bytes: &[u8], channels: usize, max: u32) -> Samples {
    let rgb_8 = |p: &[u8]| [p[0], p[channels / 2], p[channels - 1]];
    let value = |p: &[u8], i: usize| u16::from_be_bytes([p[2 * i], p[2 * i + 1]]);
    let rgb_16 = |p: &[u8]| [0, channels / 2, channels - 1].map(|i| value(p, i));
    // Values above the largest are damage, but harmless: they count as the largest.
    let part = |v: u32| v.min(max) as f32 / max as f32;
    match max {
        255 => Samples::Eight(bytes.chunks_exact(channels).map(rgb_8).collect()),
        65535 => Samples::Sixteen(bytes.chunks_exact(2 * channels).map(rgb_16).collect()),
        0..=254 => {
            let pixel = |p: &[u8]| rgb_8(p).map(|v| part(v.into()));
            Samples::Float(bytes.chunks_exact(channels).map(pixel).collect())
        }
        _ => {
            let pixel = |p: &[u8]| rgb_16(p).map(|v| part(v.into()));
            Samples::Float(bytes.chunks_exact(2 * channels).map(pixel).collect())
        }
    }
}

/// The next number of the header, and the one white space after it.
fn number(source: &mut impl BufRead) -> Result<u32, DecodeProblem> {
    let mut next = byte(source)?;
    while next.is_ascii_whitespace() || next == b'#' {
        if next == b'#' {
            while !matches!(next, b'\n' | b'\r') {
                next = byte(source)?;
            }
        }
        next = byte(source)?;
    }
    let mut number: u32 = 0;
    while next.is_ascii_digit() {
        let longer = number.checked_mul(10).and_then(|n| n.checked_add(u32::from(next - b'0')));
        number = longer.ok_or_else(|| DecodeProblem::malformed("PNM", "a number is too large"))?;
        next = byte(source)?;
    }
    if next.is_ascii_whitespace() {
        Ok(number)
    } else {
        Err(DecodeProblem::malformed("PNM", "the header is not three numbers"))
    }
}

fn byte(source: &mut impl BufRead) -> Result<u8, DecodeProblem> {
    let mut byte = [0];
    source.read_exact(&mut byte)?;
    Ok(byte[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read_all(bytes: &[u8]) -> Result<Picture, DecodeProblem> {
        read(bytes, PictureLimits { pixels: 100 })
    }

    #[test]
    fn comments_between_the_numbers_are_skipped() {
        let picture = read_all(b"P6\n# Created by a ray tracer\n2 1\n# more\n255\n#ab\x01\x02\x03").unwrap();
        assert_eq!(picture.size(), PictureSize::new(2, 1));
        // The bytes after the largest value are pixels, even if they look like a comment.
        assert_eq!(picture.levels(0), [35.0, 97.0, 98.0]);
        assert_eq!(picture.levels(1), [1.0, 2.0, 3.0]);
    }

    #[test]
    fn grey_and_unusual_largest_values_are_scaled_to_levels() {
        // 255 * 5 / 15 = 85, but for the rounding of a 32-bit float.
        let third = read_all(b"P5 1 1 15 \x05").unwrap().levels(0)[1];
        assert!((third - 85.0).abs() < 85.0 * f64::from(f32::EPSILON));
        assert_eq!(read_all(b"P5 1 1 65535 \xff\xff").unwrap().levels(0), [255.0; 3]);
        assert_eq!(read_all(b"P5 1 1 1000 \x03\xe8").unwrap().levels(0), [255.0; 3]);
    }

    #[test]
    fn damage_and_size_are_refused() {
        assert!(matches!(read_all(b"P6 2 1 255 abc"), Err(DecodeProblem::Io(_))));
        assert!(matches!(read_all(b"P6 99 99 255 abc"), Err(DecodeProblem::LimitExceeded { .. })));
        assert!(matches!(read_all(b"P6 0 99 255 abc"), Err(DecodeProblem::Malformed { .. })));
        assert!(matches!(read_all(b"P6 99999999999 1 255 a"), Err(DecodeProblem::Malformed { .. })));
        assert!(matches!(read_all(b"P6 1 1 x a"), Err(DecodeProblem::Malformed { .. })));
        assert!(matches!(read_all(b"P6 1 1 0 a"), Err(DecodeProblem::Malformed { .. })));
    }
}
