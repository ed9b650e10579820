//! Reads `OpenEXR`: the first layer with R, G, B and perhaps A, of scan lines or tiles, not deep.

use std::io::{BufRead, Seek};
use std::panic::{AssertUnwindSafe, catch_unwind};

use exr::error::Error;
use exr::math::Vec2;
use exr::meta::MetaData;
use exr::prelude::{ReadChannels, ReadLayers, read as read_exr};

use super::error::DecodeProblem;
use super::read::PictureLimits;
use crate::PictureSize;
use crate::picture::{Picture, PixelKind, Samples};

/// The pixels while they come.
struct Pixels {
    width: usize,
    kind: PixelKind,
    values: Vec<f32>,
}

impl Pixels {
    fn set(&mut self, at: Vec2<usize>, (r, g, b, a): (f32, f32, f32, f32)) {
        let channels = self.kind.channels();
        let first = (at.y() * self.width + at.x()) * channels;
        self.values[first..first + channels].copy_from_slice(&[r, g, b, a][..channels]);
    }
}

/// Reads a picture.
pub(crate) fn read<R: BufRead + Seek>(
    mut source: R,
    limits: PictureLimits,
) -> Result<Picture, DecodeProblem> {
    // The library is not proof against every damaged file; a panic of its is damage to us. The
    // source is dropped after one, so nothing half-changed is seen again.
    catch_unwind(AssertUnwindSafe(|| read_unguarded(&mut source, limits)))
        .unwrap_or_else(|_| Err(DecodeProblem::malformed("EXR", "the decoder gave up")))
}

fn read_unguarded<R: BufRead + Seek>(
    source: &mut R,
    limits: PictureLimits,
) -> Result<Picture, DecodeProblem> {
    // The header first: the library would take memory for the pixels without asking.
    let meta = MetaData::read_from_buffered(&mut *source, false).map_err(problem)?;
    for header in &meta.headers {
        limits.check(picture_size(header.layer_size)?, "EXR")?;
    }
    source.rewind()?;
    let image = read_exr()
        .no_deep_data()
        .largest_resolution_level()
        .rgba_channels(
            |size, (_, _, _, alpha)| {
                let kind = if alpha.is_some() { PixelKind::Rgba } else { PixelKind::Rgb };
                Pixels { width: size.width(), kind, values: vec![0.0; size.area() * kind.channels()] }
            },
            Pixels::set,
        )
        .first_valid_layer()
        .all_attributes()
        .non_parallel()
        .from_buffered(&mut *source)
        .map_err(problem)?;
    let size = picture_size(image.layer_data.size)?;
    let Pixels { kind, values, .. } = image.layer_data.channel_data.pixels;
    Ok(Picture::new(size, kind, Samples::Float(values)))
}

fn picture_size(size: Vec2<usize>) -> Result<PictureSize, DecodeProblem> {
    match (u32::try_from(size.width()), u32::try_from(size.height())) {
        (Ok(width), Ok(height)) => Ok(PictureSize::new(width, height)),
        _ => Err(DecodeProblem::malformed("EXR", "the size is no 32-bit number")),
    }
}

fn problem(error: Error) -> DecodeProblem {
    match error {
        Error::Io(error) => error.into(),
        Error::NotSupported(what) => DecodeProblem::Unsupported(what.into_owned()),
        other => DecodeProblem::malformed("EXR", other.to_string()),
    }
}
