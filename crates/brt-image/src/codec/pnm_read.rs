//! Reads binary PPM (P6) and PGM (P5), with comments in the header and any largest value.

use std::io::BufRead;

use super::error::DecodeProblem;
use super::read::{PictureLimits, read_bytes};
use crate::PictureSize;
use crate::picture::{Picture, PixelKind, Samples};

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
    let kind = if channels == 3 { PixelKind::Rgb } else { PixelKind::Grey };
    Ok(Picture::new(size, kind, samples(bytes, max)))
}

fn samples(bytes: Vec<u8>, max: u32) -> Samples {
    // Values above the largest are damage, but harmless: they count as the largest.
    let part = |v: u32| v.min(max) as f32 / max as f32;
    match max {
        255 => Samples::Eight(bytes),
        65535 => Samples::Sixteen(bytes),
        0..=254 => Samples::Float(bytes.iter().map(|&v| part(v.into())).collect()),
        _ => {
            let value = |p: &[u8; 2]| part(u16::from_be_bytes(*p).into());
            Samples::Float(bytes.as_chunks().0.iter().map(value).collect())
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
