//! Reads `OpenEXR`: the first layer with R, G and B, of scan lines or tiles, not deep.

use std::io::{BufRead, Seek};
use std::panic::{AssertUnwindSafe, catch_unwind};

use exr::error::Error;
use exr::math::Vec2;
use exr::meta::MetaData;
use exr::prelude::{ReadChannels, ReadLayers, read as read_exr};

use super::error::DecodeProblem;
use super::read::PictureLimits;
use crate::PictureSize;
use crate::picture::{Picture, Samples};

/// The pixels while they come.
struct Pixels {
    width: usize,
    values: Vec<[f32; 3]>,
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
        .rgb_channels(
            |size, _| Pixels { width: size.width(), values: vec![[0.0; 3]; size.area()] },
            |pixels, at, (r, g, b)| pixels.values[at.y() * pixels.width + at.x()] = [r, g, b],
        )
        .first_valid_layer()
        .all_attributes()
        .non_parallel()
        .from_buffered(&mut *source)
        .map_err(problem)?;
    let size = picture_size(image.layer_data.size)?;
    Ok(Picture::new(size, Samples::Float(image.layer_data.channel_data.pixels.values)))
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
