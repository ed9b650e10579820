//! Pictures with alpha: PNG has straight colours, EXR premultiplied ones, and both are read back.

use std::io::Cursor;

use super::round_trip_tests::{Memory, encoded, test_picture};
use super::*;
use crate::{Image, Picture, PictureSize, PixelRows, Transfer, straight};

fn encodings() -> Vec<Encoding> {
    let mut all = vec![Encoding { format: PictureFormat::Exr, ..Encoding::default() }];
    for depth in [BitDepth::Eight, BitDepth::Sixteen] {
        for transfer in [Transfer::Srgb, Transfer::Linear] {
            for compression in [Compression::Fast, Compression::Balanced, Compression::Small] {
                all.push(Encoding { depth, transfer, compression, ..Encoding::default() });
            }
        }
    }
    all.into_iter().map(|encoding| Encoding { channels: Channels::Rgba, ..encoding }).collect()
}

/// Premultiplied colours, and alphas of 0, 1 and between.
fn covered_picture(size: PictureSize) -> (Image, Vec<f32>) {
    let mut image = test_picture(size);
    let alphas: Vec<f32> = (0..size.pixels()).map(|i| ((i % 12) as f32 / 10.0).min(1.0)).collect();
    for (color, alpha) in image.pixels_mut().iter_mut().zip(&alphas) {
        *color = color.map(|c| c * alpha);
    }
    (image, alphas)
}

fn encoded_with_alpha(image: &Image, alpha: &[f32], encoding: Encoding, rows: u32) -> Vec<u8> {
    let memory = Memory::default();
    let mut writer = encoder(Box::new(memory.clone()), image.size(), encoding).unwrap();
    let step = (image.size().width * rows) as usize;
    for (colors, alpha) in image.pixels().chunks(step).zip(alpha.chunks(step)) {
        writer.write_pixels(PixelRows { colors, alpha: Some(alpha) }).unwrap();
    }
    writer.finish().unwrap();
    memory.bytes()
}

fn read_back(bytes: &[u8]) -> Picture {
    decode_picture(bytes, PictureLimits::default()).unwrap()
}

/// The code that the definition gives.
fn code(stored: f64, encoding: Encoding) -> u16 {
    let most = if encoding.depth == BitDepth::Eight { 255.0 } else { 65535.0 };
    (stored * most + 0.5).floor() as u16
}

#[test]
fn png_has_straight_colours_by_the_transfer_function_and_linear_alpha() {
    let (image, alphas) = covered_picture(PictureSize::new(37, 41));
    for encoding in encodings().into_iter().filter(|e| e.format == PictureFormat::Png) {
        let bytes = encoded_with_alpha(&image, &alphas, encoding, 7);
        let mut reader = png::Decoder::new(Cursor::new(&bytes)).read_info().unwrap();
        assert_eq!(reader.info().color_type, png::ColorType::Rgba);
        let mut codes = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut codes).unwrap();
        let codes: Vec<u16> = match encoding.depth {
            BitDepth::Eight => codes.into_iter().map(u16::from).collect(),
            BitDepth::Sixteen => codes.chunks_exact(2).map(|p| u16::from_be_bytes([p[0], p[1]])).collect(),
        };
        for (i, pixel) in codes.chunks_exact(4).enumerate() {
            let color = straight(image.pixels()[i], alphas[i]);
            let [r, g, b] = color.map(|c| code(encoding.transfer.encode(c.into()), encoding));
            let expected = [r, g, b, code(alphas[i].into(), encoding)];
            assert_eq!(pixel, expected, "pixel {i}, {encoding:?}");
        }
    }
}

#[test]
fn exr_has_premultiplied_colours_and_alpha_as_a_channel_of_its_own() {
    use exr::prelude::{ReadChannels, ReadLayers};
    let (image, alphas) = covered_picture(PictureSize::new(9, 40));
    let encoding = Encoding { format: PictureFormat::Exr, channels: Channels::Rgba, ..Encoding::default() };
    let bytes = encoded_with_alpha(&image, &alphas, encoding, 7);
    let file = exr::prelude::read()
        .no_deep_data()
        .largest_resolution_level()
        .all_channels()
        .first_valid_layer()
        .all_attributes()
        .from_buffered(Cursor::new(&bytes))
        .unwrap();
    let list = &file.layer_data.channel_data.list;
    let names: Vec<String> = list.iter().map(|channel| channel.name.to_string()).collect();
    assert_eq!(names, ["A", "B", "G", "R"]);
    let values = |i: usize| list[i].sample_data.values_as_f32().collect::<Vec<f32>>();
    assert_eq!(values(0), alphas);
    for (channel, c) in [(1, 2), (2, 1), (3, 0)] {
        assert_eq!(values(channel), image.pixels().iter().map(|p| p[c]).collect::<Vec<_>>());
    }
}

#[test]
fn alpha_is_read_back_and_bands_change_no_byte() {
    let (image, alphas) = covered_picture(PictureSize::new(23, 67));
    for encoding in encodings() {
        let bytes = encoded_with_alpha(&image, &alphas, encoding, 67);
        for rows in [1, 16, 66] {
            assert!(encoded_with_alpha(&image, &alphas, encoding, rows) == bytes, "{rows} {encoding:?}");
        }
        let picture = read_back(&bytes);
        assert!(picture.has_alpha());
        for (i, &alpha) in alphas.iter().enumerate() {
            let expected = match (encoding.format, encoding.depth) {
                (PictureFormat::Exr, _) => f64::from(alpha) * 65535.0 / 257.0,
                (_, BitDepth::Eight) => f64::from(code(alpha.into(), encoding)),
                (_, BitDepth::Sixteen) => f64::from(code(alpha.into(), encoding)) / 257.0,
            };
            assert_eq!(picture.alpha_level(i), expected, "pixel {i}, {encoding:?}");
        }
    }
}

#[test]
fn alpha_is_compared_as_a_fourth_channel() {
    let (image, alphas) = covered_picture(PictureSize::new(12, 2));
    let encoding = Encoding { channels: Channels::Rgba, ..Encoding::default() };
    let picture = read_back(&encoded_with_alpha(&image, &alphas, encoding, 2));
    assert_eq!(crate::compare(&picture, &picture).unwrap().max_error, 0.0);
    // Halving both leaves straight colours as they are: 255 and 128 remain apart.
    let mut half = image.clone();
    half.pixels_mut().iter_mut().for_each(|color| *color = color.map(|c| c * 0.5));
    let half_alphas: Vec<f32> = alphas.iter().map(|alpha| alpha * 0.5).collect();
    let half = read_back(&encoded_with_alpha(&half, &half_alphas, encoding, 2));
    assert_eq!(crate::compare(&picture, &half).unwrap().max_error, 127.0);
    // Opaque pictures with alpha and without are one.
    let ones = vec![1.0; alphas.len()];
    let with = read_back(&encoded_with_alpha(&image, &ones, encoding, 2));
    let without = read_back(&encoded(&image, Encoding::default(), 2));
    assert!(with.has_alpha() && !without.has_alpha());
    assert_eq!(crate::compare(&with, &without).unwrap().max_error, 0.0);
}

#[test]
fn alpha_that_does_not_fit_is_refused() {
    let size = PictureSize::new(2, 2);
    let colors = &[[0.5; 3]; 4][..];
    for format in [PictureFormat::Png, PictureFormat::Exr] {
        let open = |channels| {
            let encoding = Encoding { format, channels, ..Encoding::default() };
            encoder(Box::new(Memory::default()), size, encoding).unwrap()
        };
        assert!(open(Channels::Rgba).write(colors).is_err());
        assert!(open(Channels::Rgba).write_pixels(PixelRows { colors, alpha: Some(&[1.0; 3]) }).is_err());
        assert!(open(Channels::Rgb).write_pixels(PixelRows { colors, alpha: Some(&[1.0; 4]) }).is_err());
    }
    let encoding = Encoding { format: PictureFormat::Ppm, channels: Channels::Rgba, ..Encoding::default() };
    let Err(error) = encoder(Box::new(Memory::default()), size, encoding) else { panic!("a PPM with alpha") };
    assert_eq!(error.to_string(), "PPM cannot hold transparency; PNG and EXR can");
}
