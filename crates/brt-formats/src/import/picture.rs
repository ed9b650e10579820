//! Pictures on surfaces: PNG and JPEG as texels.
//!
//! What a picture claims to be is held against the budget before memory is spent on it.

use std::borrow::Cow;
use std::collections::HashMap;
use std::sync::Arc;

use brt_scene::Texels;

use super::picture_decoder::PictureDecoder;
use crate::common::Budget;

/// A picture, or why there is none, fit to follow its name.
pub(crate) type Picture = Result<Arc<Texels>, String>;

/// The pictures of a scene: one that is named again is not decoded again.
pub(crate) struct Pictures<'b> {
    known: HashMap<String, Picture>,
    budget: &'b Budget<'b>,
}

impl<'b> Pictures<'b> {
    pub(crate) fn new(budget: &'b Budget<'b>) -> Self {
        Self { known: HashMap::new(), budget }
    }

    /// The picture of a name, whose bytes are read where it is not known yet.
    pub(crate) fn get<'f>(
        &mut self,
        name: &str,
        read: impl FnOnce() -> Result<Cow<'f, [u8]>, String>,
    ) -> Picture {
        if let Some(picture) = self.known.get(name) {
            return picture.clone();
        }
        let picture = read().and_then(|bytes| self.decode(name, &bytes)).map(Arc::new);
        self.known.insert(name.to_owned(), picture.clone());
        picture
    }

    /// Another picture of this name comes.
    pub(crate) fn forget(&mut self, name: &str) {
        self.known.remove(name);
    }

    fn decode(&mut self, name: &str, bytes: &[u8]) -> Result<Texels, String> {
        let decoder = PictureDecoder::new(bytes)?;
        let [width, height] = decoder.size();
        let pixels = u64::from(width) * u64::from(height);
        if pixels == 0 {
            return Err("it has no pixels".to_owned());
        }
        let passing = decoder.passing_bytes(pixels);
        let what = || format!("a picture of {width} × {height} pixels");
        let texels = pixels.saturating_mul(4);
        self.budget.take(texels.saturating_add(passing), what).map_err(|halt| halt.text())?;
        let mut rgba = self.budget.list(pixels as usize, what).map_err(|halt| halt.text())?;
        let decoded = decoder.decode(&mut rgba);
        self.budget.give_back(passing);
        decoded?;
        Ok(Texels { name: name.to_owned(), width, height, rgba })
    }
}

#[cfg(test)]
mod tests {
    use png::{BitDepth, ColorType, Encoder};

    use super::*;
    use crate::common::Limits;

    fn decoded(bytes: &[u8]) -> Result<Texels, String> {
        Pictures::new(&Budget::new(&Limits::default())).decode("x", bytes)
    }

    fn png(pixels: &[u8], width: u32, height: u32, kind: ColorType, depth: BitDepth) -> Vec<u8> {
        let mut bytes = Vec::new();
        let mut encoder = Encoder::new(&mut bytes, width, height);
        encoder.set_color(kind);
        encoder.set_depth(depth);
        encoder.write_header().unwrap().write_image_data(pixels).unwrap();
        bytes
    }

    #[test]
    fn all_kinds_of_png_become_the_same() {
        let grey = [[80, 80, 80, 255], [200, 200, 200, 255]];
        let [a, b] = [80_u16 * 257, 200 * 257].map(u16::to_be_bytes);
        let (eight, sixteen) = (BitDepth::Eight, BitDepth::Sixteen);
        for (pixels, kind, depth) in [
            (vec![80, 200], ColorType::Grayscale, eight),
            (vec![80, 255, 200, 255], ColorType::GrayscaleAlpha, eight),
            (vec![80, 80, 80, 200, 200, 200], ColorType::Rgb, eight),
            ([a, b].concat(), ColorType::Grayscale, sixteen),
            ([a, a, a, b, b, b].concat(), ColorType::Rgb, sixteen),
        ] {
            let texels = decoded(&png(&pixels, 2, 1, kind, depth)).unwrap();
            assert_eq!((texels.width, texels.height), (2, 1));
            assert_eq!(texels.rgba, grey, "{kind:?} {depth:?}");
        }
        let alpha = decoded(&png(&[1, 2, 3, 4], 1, 1, ColorType::Rgba, eight)).unwrap();
        assert_eq!(alpha.rgba, [[1, 2, 3, 4]]);
    }

    #[test]
    fn sixteen_bits_are_rounded_to_the_nearest_of_eight() {
        let levels = [0x0000_u16, 0x0080, 0x0081, 0x7F7E, 0x7F80, 0xFF7E, 0xFF7F, 0xFFFF];
        let bytes: Vec<u8> = levels.into_iter().flat_map(u16::to_be_bytes).collect();
        let texels = decoded(&png(&bytes, 8, 1, ColorType::Grayscale, BitDepth::Sixteen)).unwrap();
        let found: Vec<u8> = texels.rgba.iter().map(|texel| texel[0]).collect();
        let nearest = levels.map(|level| (f64::from(level) / 257.0).round() as u8);
        assert_eq!(found, nearest);
    }

    #[test]
    fn palettes_and_transparent_colors_become_texels() {
        let texels = decoded(include_bytes!("pictures_for_tests/palette.png")).unwrap();
        assert_eq!(texels.rgba, [[10, 20, 30, 255], [40, 50, 60, 0], [70, 80, 90, 255]]);
        let one_bit = decoded(&png(&[0b0100_0000], 2, 1, ColorType::Grayscale, BitDepth::One)).unwrap();
        assert_eq!(one_bit.rgba, [[0, 0, 0, 255], [255; 4]]);
    }

    #[test]
    fn all_kinds_of_jpeg_become_texels() {
        for (bytes, color) in [
            (&include_bytes!("pictures_for_tests/color.jpg")[..], [200, 120, 40]),
            (include_bytes!("pictures_for_tests/progressive.jpg"), [200, 120, 40]),
            (include_bytes!("pictures_for_tests/grey.jpg"), [90, 90, 90]),
            (include_bytes!("pictures_for_tests/cmyk.jpg"), [200, 120, 40]),
        ] {
            let texels = decoded(bytes).unwrap();
            assert_eq!((texels.width, texels.height, texels.rgba.len()), (16, 8, 128));
            for [r, g, b, alpha] in &texels.rgba {
                let is_near = [r, g, b].into_iter().zip(color).all(|(a, b)| a.abs_diff(b) <= 2);
                assert!(is_near && *alpha == 255, "{r} {g} {b} {alpha} instead of {color:?}");
            }
        }
    }

    /// A PNG by hand: chunks are not checked by the decoder beyond their sums, which are computed here.
    fn raw_png(width: u32, height: u32, depth: u8, kind: u8, interlace: u8) -> Vec<u8> {
        let mut bytes = b"\x89PNG\r\n\x1a\n".to_vec();
        let mut head = b"IHDR".to_vec();
        head.extend(width.to_be_bytes());
        head.extend(height.to_be_bytes());
        head.extend([depth, kind, 0, 0, interlace]);
        bytes.extend(13_u32.to_be_bytes());
        let sum = crc(&head);
        bytes.extend(head);
        bytes.extend(sum.to_be_bytes());
        bytes
    }

    fn crc(bytes: &[u8]) -> u32 {
        !bytes.iter().fold(u32::MAX, |sum, &byte| {
            (0..8)
                .fold(sum ^ u32::from(byte), |c, _| if c & 1 == 1 { 0xEDB8_8320 ^ (c >> 1) } else { c >> 1 })
        })
    }

    #[test]
    fn bombs_are_refused_by_their_heads() {
        let error =
            decoded(&[raw_png(60_000, 60_000, 8, 6, 0), b"\0\0\0\0IDAT".to_vec()].concat()).unwrap_err();
        assert!(error.contains("60000 × 60000"), "{error}");
        let jpeg = [b"\xff\xd8\xff".to_vec(), b"\xff\xda".repeat(300)].concat();
        assert_eq!(decoded(&jpeg).unwrap_err(), "it has 300 scans");
    }

    #[test]
    fn broken_pictures_are_refused() {
        let whole = png(&[7; 300], 10, 10, ColorType::Rgb, BitDepth::Eight);
        for end in [0, 4, 8, 20, whole.len() / 2] {
            assert!(decoded(&whole[..end]).is_err(), "{end}");
        }
        assert_eq!(decoded(b"GIF89a").unwrap_err(), "it is neither PNG nor JPEG");
        assert!(decoded(&raw_png(0, 0, 8, 6, 0)).is_err());
    }

    #[test]
    fn pictures_are_decoded_once_and_counted_together() {
        let budget = Budget::new(&Limits { memory: 1000, ..Limits::default() });
        let mut pictures = Pictures::new(&budget);
        let bytes = png(&[7; 300], 10, 10, ColorType::Rgb, BitDepth::Eight);
        let first = pictures.get("a", || Ok(bytes.as_slice().into())).unwrap();
        let again = pictures.get("a", || Err("not read again".to_owned())).unwrap();
        assert!(Arc::ptr_eq(&first, &again));
        let error = pictures.get("b", || Ok(bytes.as_slice().into())).unwrap_err();
        assert!(error.contains("a picture of 10 × 10 pixels"), "{error}");
    }
}
