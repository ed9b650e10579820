//! What is written can be read: every format, depth, transfer and way of cutting into bands.

use std::fs;
use std::io::{self, Write};
use std::path::Path;
use std::sync::{Arc, Mutex};

use super::sink::{PlainSink, Sink};
use super::*;
use crate::{Image, Picture, PictureSize, Transfer};

/// A picture with smooth parts, steps, and values outside the unit interval.
pub(crate) fn test_picture(size: PictureSize) -> Image {
    let mut image = Image::black(size);
    let width = size.width as usize;
    for (i, pixel) in image.pixels_mut().iter_mut().enumerate() {
        let (x, y) = ((i % width) as f32, (i / width) as f32);
        *pixel =
            [x / width as f32, (x * y * 0.37).fract() * 1.2 - 0.1, f32::from(u8::from((x + y) % 7.0 < 3.0))];
    }
    image
}

/// A sink in memory whose bytes can be looked at when it is committed.
#[derive(Clone, Default)]
pub(crate) struct Memory {
    bytes: Arc<Mutex<Vec<u8>>>,
    fails_after: Option<usize>,
}

impl Memory {
    pub(crate) fn bytes(&self) -> Vec<u8> {
        self.bytes.lock().unwrap().clone()
    }
}

impl Write for Memory {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let mut all = self.bytes.lock().unwrap();
        if self.fails_after.is_some_and(|limit| all.len() + bytes.len() > limit) {
            return Err(io::Error::other("disk full"));
        }
        all.extend(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Sink for Memory {
    fn commit(self: Box<Self>) -> io::Result<()> {
        Ok(())
    }
}

fn all_encodings() -> Vec<Encoding> {
    let mut all = Vec::new();
    for format in [PictureFormat::Png, PictureFormat::Ppm, PictureFormat::Exr] {
        for depth in [BitDepth::Eight, BitDepth::Sixteen] {
            for transfer in [Transfer::Srgb, Transfer::Linear] {
                all.push(Encoding { format, depth, transfer, ..Encoding::default() });
            }
            if format == PictureFormat::Png {
                let small = [Compression::Balanced, Compression::Small];
                all.extend(small.map(|compression| Encoding {
                    format,
                    depth,
                    compression,
                    ..Encoding::default()
                }));
            }
        }
    }
    all
}

fn write_in_bands(mut writer: Box<dyn BandWriter>, image: &Image, rows: u32) -> Result<(), EncodeError> {
    for first in (0..image.size().height).step_by(rows as usize) {
        writer.write(image.band(first, rows).pixels)?;
    }
    writer.finish()
}

/// The bytes written to a sink that cannot go back.
pub(crate) fn encoded(image: &Image, encoding: Encoding, rows: u32) -> Vec<u8> {
    let memory = Memory::default();
    let sink = Box::new(memory.clone());
    write_in_bands(encoder(sink, image.size(), encoding).unwrap(), image, rows).unwrap();
    memory.bytes()
}

fn encoded_file(path: &Path, image: &Image, encoding: Encoding, rows: u32) -> Vec<u8> {
    let sink = Target::File(path.to_owned()).open().unwrap();
    write_in_bands(encoder(sink, image.size(), encoding).unwrap(), image, rows).unwrap();
    fs::read(path).unwrap()
}

/// Is every level what the definition says?
fn assert_levels(picture: &Picture, image: &Image, encoding: Encoding) {
    assert_eq!(picture.size(), image.size());
    for (i, pixel) in image.pixels().iter().enumerate() {
        let expected = pixel.map(|c| match (encoding.format, encoding.depth) {
            (PictureFormat::Exr, _) => f64::from(c) * 65535.0 / 257.0,
            (_, BitDepth::Eight) => (encoding.transfer.encode(c.into()) * 255.0 + 0.5).floor(),
            (_, BitDepth::Sixteen) => (encoding.transfer.encode(c.into()) * 65535.0 + 0.5).floor() / 257.0,
        });
        assert_eq!(picture.levels(i), expected, "pixel {i}, {encoding:?}");
    }
}

#[test]
fn every_encoding_is_read_back_exactly() {
    let image = test_picture(PictureSize::new(37, 41));
    let folder = tempfile::tempdir().unwrap();
    for encoding in all_encodings() {
        let limits = PictureLimits::default();
        let streamed = decode_picture(&encoded(&image, encoding, 41), limits).unwrap();
        assert_levels(&streamed, &image, encoding);
        let path = folder.path().join("picture");
        encoded_file(&path, &image, encoding, 41);
        assert_levels(&read_picture(&path, limits).unwrap(), &image, encoding);
    }
}

#[test]
fn bands_of_any_height_give_the_same_file() {
    let image = test_picture(PictureSize::new(23, 67));
    let folder = tempfile::tempdir().unwrap();
    for encoding in all_encodings() {
        let whole = encoded(&image, encoding, 67);
        let path = folder.path().join("picture");
        let whole_file = encoded_file(&path, &image, encoding, 67);
        for rows in [1, 3, 7, 16, 17, 66] {
            assert!(encoded(&image, encoding, rows) == whole, "{rows} {encoding:?}");
            assert!(encoded_file(&path, &image, encoding, rows) == whole_file, "{rows} {encoding:?}");
        }
    }
}

/// Grey, one colour, smooth and rough pictures of many sizes: segments of every height, and a last one of every height.
#[test]
fn pngs_of_many_sizes_are_read_back_and_the_same_on_any_number_of_threads() {
    let pools = [1, 2, 5].map(|n| rayon::ThreadPoolBuilder::new().num_threads(n).build().unwrap());
    let pngs = all_encodings().into_iter().filter(|e| e.format == PictureFormat::Png);
    let pngs: Vec<_> = pngs.collect();
    for (width, height) in [(1, 1), (1, 700), (3, 129), (700, 1), (255, 257), (2000, 90), (100_000, 3)] {
        let mut image = test_picture(PictureSize::new(width, height));
        for (i, pixel) in image.pixels_mut().iter_mut().enumerate() {
            match i / (width as usize) % 40 {
                0..10 => *pixel = [pixel[0]; 3],
                10..20 => *pixel = [0.25, 0.5, 0.75],
                _ => {}
            }
        }
        for &encoding in &pngs {
            let [one, two, five] =
                [0, 1, 2].map(|p| pools[p].install(|| encoded(&image, encoding, [height, 7, 64][p])));
            assert!(one == two && two == five, "{width}×{height} {encoding:?}");
            assert_levels(&decode_picture(&one, PictureLimits::default()).unwrap(), &image, encoding);
        }
    }
}

#[test]
fn more_time_makes_smaller_files() {
    let image = test_picture(PictureSize::new(300, 300));
    let sizes = [Compression::Fast, Compression::Balanced, Compression::Small]
        .map(|compression| encoded(&image, Encoding { compression, ..Encoding::default() }, 300).len());
    assert!(sizes.is_sorted_by(|a, b| a > b), "{sizes:?}");
}

#[test]
fn many_exr_blocks_are_written_in_order() {
    let image = test_picture(PictureSize::new(5, 16 * 35 + 3));
    let encoding = Encoding { format: PictureFormat::Exr, ..Encoding::default() };
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("tall.exr");
    encoded_file(&path, &image, encoding, 50);
    assert_levels(&read_picture(&path, PictureLimits::default()).unwrap(), &image, encoding);
}

#[test]
fn exr_layers_are_kept_by_name() {
    use exr::prelude::*;
    let size = PictureSize::new(6, 40);
    let image = test_picture(size);
    let layers = ExrLayers::new(["depth.Z", "Albedo.R", "surface.id"]);
    let depth: Vec<f32> = (0..240).map(|i| i as f32 * 0.25).collect();
    let albedo = vec![0.5; 240];
    let id: Vec<f32> = (0..240).map(|i| (i % 9) as f32).collect();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("layers.exr");
    let sink = Target::File(path.clone()).open().unwrap();
    let mut writer = ExrEncoder::new(sink, size, &layers).unwrap();
    for at in [0..60, 60..240] {
        let parts: [&[f32]; 3] = [&depth[at.clone()], &albedo[at.clone()], &id[at.clone()]];
        writer.write_with_layers(&image.pixels()[at], &parts).unwrap();
    }
    Box::new(writer).finish().unwrap();

    let file = read_first_flat_layer_from_file(&path).unwrap();
    let channel = |name: &str| -> Vec<f32> {
        let all = &file.layer_data.channel_data.list;
        let found = all.iter().find(|c| c.name.to_string() == name).unwrap();
        found.sample_data.values_as_f32().collect()
    };
    assert_eq!(channel("depth.Z"), depth);
    assert_eq!(channel("Albedo.R"), albedo);
    assert_eq!(channel("surface.id"), id);
    assert_eq!(channel("G"), image.pixels().iter().map(|p| p[1]).collect::<Vec<_>>());
}

#[test]
fn misuse_is_an_error_and_leaves_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let size = PictureSize::new(8, 4);
    for encoding in all_encodings() {
        let open = || {
            let sink = Target::File(folder.path().join("x")).open().unwrap();
            encoder(sink, size, encoding).unwrap()
        };
        let mut writer = open();
        assert!(matches!(writer.write(&[[0.0; 3]; 7]), Err(EncodeError::PartialRow { .. })));
        assert!(matches!(writer.write(&[[0.0; 3]; 40]), Err(EncodeError::RowCount { .. })));
        drop(writer);
        let mut writer = open();
        writer.write(&[[0.0; 3]; 16]).unwrap();
        assert!(matches!(writer.finish(), Err(EncodeError::RowCount { expected: 4, given: 2 })));
        let empty = encoder(Box::new(PlainSink(io::sink())), PictureSize::new(0, 4), encoding);
        assert!(matches!(empty, Err(EncodeError::Size { .. })));
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
}

#[test]
fn wrong_layers_are_refused() {
    let size = PictureSize::new(2, 2);
    let open = |names: &[&str]| {
        ExrEncoder::new(Box::new(Memory::default()), size, &ExrLayers::new(names.iter().copied()))
    };
    for names in [&["Z", "Z"][..], &["G"], &[""], &["12345678901234567890123456789012"]] {
        assert!(matches!(open(names), Err(EncodeError::Layers(_))), "{names:?}");
    }
    let mut writer = open(&["Z"]).unwrap_or_else(|e| panic!("{e}"));
    assert!(matches!(writer.write(&[[0.0; 3]; 2]), Err(EncodeError::Layers(_))));
    let short = writer.write_with_layers(&[[0.0; 3]; 2], &[&[1.0]]);
    assert!(matches!(short, Err(EncodeError::Layers(_))));
}

#[test]
fn a_full_disk_is_an_error_wherever_it_happens() {
    let image = test_picture(PictureSize::new(64, 64));
    for encoding in all_encodings() {
        let length = encoded(&image, encoding, 64).len();
        for limit in [0, 10, 60, length / 2, length - 1] {
            let sink = Box::new(Memory { fails_after: Some(limit), ..Memory::default() });
            let result =
                encoder(sink, image.size(), encoding).and_then(|writer| write_in_bands(writer, &image, 8));
            let Err(error) = result else { panic!("{encoding:?} succeeded with {limit} bytes") };
            assert!(error.to_string().contains("disk full"), "{error}");
        }
    }
}

#[test]
fn a_picture_with_a_failed_band_is_never_complete() {
    let image = test_picture(PictureSize::new(300, 64));
    for encoding in all_encodings() {
        let sink = Box::new(Memory { fails_after: Some(700), ..Memory::default() });
        let Ok(mut writer) = encoder(sink, image.size(), encoding) else { continue };
        // The caller goes on after errors, as it should not.
        let failed = (0..64).filter(|&y| writer.write(image.band(y, 1).pixels).is_err()).count();
        assert!(writer.finish().is_err(), "{encoding:?} after {failed} errors");
    }
}

#[test]
fn limits_are_asked_before_memory_is_taken() {
    let image = test_picture(PictureSize::new(20, 20));
    for encoding in all_encodings() {
        let bytes = encoded(&image, encoding, 20);
        let refused = decode_picture(&bytes, PictureLimits { pixels: 399 });
        assert!(matches!(refused, Err(DecodeProblem::LimitExceeded { limit: 399, .. })));
        decode_picture(&bytes, PictureLimits { pixels: 400 }).unwrap();
    }
    assert!(matches!(decode_picture(b"GIF89a", PictureLimits::default()), Err(DecodeProblem::UnknownFormat)));
}
