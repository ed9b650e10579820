//! Damaged files: an answer or an error, never a panic, never more memory than allowed.

use png::{BitDepth as PngDepth, ColorType, Encoder};

use super::round_trip_tests::{encoded, test_picture};
use super::*;
use crate::PictureSize;

/// SplitMix64: the same damage on every machine.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, n: usize) -> usize {
        (self.next() % n.max(1) as u64) as usize
    }
}

/// A PNG of another colour type than we write.
fn foreign_png(color: ColorType, depth: PngDepth) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut png = Encoder::new(&mut bytes, 9, 5);
    png.set_color(color);
    png.set_depth(depth);
    png.set_palette(vec![1, 2, 3, 40, 50, 60, 255, 0, 128, 7, 7, 7]);
    let mut writer = png.write_header().unwrap();
    let row_bits = 9 * color.samples() * depth as usize;
    // Each two bits hold 0 to 3, so that every index is in the palette at depth 2.
    let data: Vec<u8> = (0..row_bits.div_ceil(8) * 5).map(|i| (i * 27) as u8).collect();
    writer.write_image_data(&data).unwrap();
    writer.finish().unwrap();
    bytes
}

fn small_files() -> Vec<Vec<u8>> {
    let image = test_picture(PictureSize::new(9, 35));
    let mut files = Vec::new();
    for format in [PictureFormat::Png, PictureFormat::Ppm, PictureFormat::Exr] {
        for depth in [BitDepth::Eight, BitDepth::Sixteen] {
            files.push(encoded(&image, Encoding { format, depth, ..Encoding::default() }, 9));
        }
    }
    files.push(zipped_exr());
    files.push(foreign_png(ColorType::Indexed, PngDepth::Two));
    files.push(foreign_png(ColorType::GrayscaleAlpha, PngDepth::Sixteen));
    files.push(b"P5 # grey\n3 2 # comment\n15\nabcdef".to_vec());
    files
}

fn zipped_exr() -> Vec<u8> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.exr");
    let image = test_picture(PictureSize::new(9, 35));
    let layers = ExrLayers::new(["depth.Z"]);
    let sink = Target::File(path.clone()).open().unwrap();
    let mut writer = ExrEncoder::new(sink, image.size(), &layers).unwrap();
    writer.write_with_layers(image.pixels(), &[&[1.5; 9 * 35]]).unwrap();
    Box::new(writer).finish().unwrap();
    std::fs::read(path).unwrap()
}

/// Changes a few bytes, mostly near the start where headers are, and sometimes cuts the end.
fn damage(bytes: &mut Vec<u8>, random: &mut Random) {
    for _ in 0..=random.below(4) {
        let span = if random.below(3) == 0 { bytes.len() } else { bytes.len().min(420) };
        let at = random.below(span);
        bytes[at] = match random.below(4) {
            0 => 0,
            1 => 0xff,
            2 => bytes[at] ^ (1 << random.below(8)),
            _ => random.next() as u8,
        };
    }
    if random.below(8) == 0 {
        let end = 1 + random.below(bytes.len());
        bytes.truncate(end);
    }
}

#[test]
fn damaged_files_never_panic() {
    let mut random = Random(1987);
    let limits = PictureLimits { pixels: 100_000 };
    for file in small_files() {
        decode_picture(&file, limits).unwrap();
        for _ in 0..1500 {
            let mut bytes = file.clone();
            damage(&mut bytes, &mut random);
            if let Ok(picture) = decode_picture(&bytes, limits) {
                assert!(picture.size().pixels() <= limits.pixels);
            }
        }
    }
}

#[test]
fn palette_and_grey_are_expanded() {
    let limits = PictureLimits::default();
    let palette = decode_picture(&foreign_png(ColorType::Indexed, PngDepth::Two), limits).unwrap();
    // The first row starts with bytes 0 and 27 = 0b00_01_10_11.
    assert_eq!(palette.levels(0), [1.0, 2.0, 3.0]);
    assert_eq!(palette.levels(5), [40.0, 50.0, 60.0]);
    assert_eq!(palette.levels(6), [255.0, 0.0, 128.0]);
    let grey = decode_picture(&foreign_png(ColorType::GrayscaleAlpha, PngDepth::Sixteen), limits).unwrap();
    // The second pixel is bytes 4 * 27 and 5 * 27; what follows is its alpha.
    assert_eq!(grey.levels(1), [f64::from(108 * 256 + 135) / 257.0; 3]);
    let bits = decode_picture(&foreign_png(ColorType::Grayscale, PngDepth::One), limits).unwrap();
    assert_eq!(bits.levels(0), [0.0; 3]);
}
