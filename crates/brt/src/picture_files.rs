//! The files of a picture as one sink: each row goes to the picture's encoder and to those of its layers.

use brt_image::{
    BandWriter, Channels, EncodeError, Encoding, ExrEncoder, ExrLayers, FileSet, PictureFormat, PictureSize,
    Target, Transfer, WorkClock, encoder,
};
use brt_render::{Rows, Sink, SinkError};

use crate::layer_paint::PicturePainter;
use crate::layers::PictureLayer;
use crate::measure::{ErrorMeasure, Verification};
use crate::output::{Output, layer_path};

/// Takes rows: measures them against full ray tracing if that was rendered, and writes them if there is an output.
///
/// All of it happens on the threads that render, while others render on.
pub(crate) struct PictureFiles {
    files: Option<OpenFiles>,
    /// That of the stored picture.
    transfer: Transfer,
    painter: PicturePainter,
    measure: Option<ErrorMeasure>,
    /// Of measuring and painting.
    clock: WorkClock,
}

impl PictureFiles {
    /// Opens every file, so that what cannot be written is known before the rendering.
    pub(crate) fn open(
        output: &Output,
        set: &FileSet,
        size: PictureSize,
        painter: PicturePainter,
        measure: Option<ErrorMeasure>,
    ) -> Result<Self, EncodeError> {
        let files =
            output.target.as_ref().map(|target| OpenFiles::open(output, target, set, size)).transpose()?;
        let transfer = output.encoding.effective_transfer();
        Ok(Self { files, transfer, painter, measure, clock: WorkClock::default() })
    }

    /// Completes all files, for their set to put in place. Returns the measured error.
    pub(crate) fn finish(self) -> Result<Option<Verification>, EncodeError> {
        if let Some(files) = self.files {
            files.finish()?;
        }
        Ok(self.measure.map(|m| m.verification()))
    }

    /// Time spent on encoding and measuring so far, summed over threads.
    pub(crate) fn seconds(&self) -> f64 {
        self.clock.seconds() + self.files.as_ref().map_or(0.0, OpenFiles::seconds)
    }
}

impl Sink for PictureFiles {
    fn transfer(&self) -> Transfer {
        self.transfer
    }

    fn take(&mut self, rows: &Rows) -> Result<(), SinkError> {
        let Self { files, painter, measure, clock, .. } = self;
        if let (Some(measure), Some(full)) = (measure, rows.full_pixels()) {
            measure.add(rows, full, clock);
        }
        if let Some(files) = files {
            files.write(rows, painter, clock)?;
        }
        Ok(())
    }
}

/// A picture and its layers while they are written.
enum OpenFiles {
    /// All layers in one file.
    Exr { encoder: Box<ExrEncoder>, layers: Vec<PictureLayer> },
    /// A file for each layer.
    Separate { picture: Box<dyn BandWriter>, layers: Vec<(PictureLayer, Box<dyn BandWriter>)> },
}

impl OpenFiles {
    fn open(output: &Output, target: &Target, set: &FileSet, size: PictureSize) -> Result<Self, EncodeError> {
        let Output { encoding, layers, .. } = output;
        if encoding.format == PictureFormat::Exr {
            let names = layers.iter().flat_map(|layer| layer.channels()).copied();
            let names = ExrLayers::beside(encoding.channels, names);
            let encoder = ExrEncoder::new(set.open(target)?, size, &names)?;
            return Ok(Self::Exr { encoder: Box::new(encoder), layers: layers.clone() });
        }
        let picture = encoder(set.open(target)?, size, *encoding)?;
        let open = |&layer: &PictureLayer| {
            let encoding = Encoding { transfer: layer.transfer(), channels: Channels::Rgb, ..*encoding };
            Ok((layer, encoder(set.open(&layer_target(target, layer))?, size, encoding)?))
        };
        let layers = layers.iter().map(open).collect::<Result<_, EncodeError>>()?;
        Ok(Self::Separate { picture, layers })
    }

    /// The time for painting goes to `clock`.
    fn write(&mut self, rows: &Rows, painter: &PicturePainter, clock: &WorkClock) -> Result<(), EncodeError> {
        match self {
            Self::Exr { encoder, layers } => {
                let values: Vec<Vec<f32>> =
                    clock.time(|| layers.iter().flat_map(|&layer| painter.values(layer, rows)).collect());
                let values: Vec<&[f32]> =
                    rows.alpha.as_deref().into_iter().chain(values.iter().map(Vec::as_slice)).collect();
                encoder.write_with_layers(&rows.colors, &values)
            }
            Self::Separate { picture, layers } => {
                picture.write_pixels(rows.pixels())?;
                layers.iter_mut().try_for_each(|(layer, file)| {
                    let colors = painter.colors(*layer, rows);
                    file.write(&colors)
                })
            }
        }
    }

    /// Time spent on encoding so far, summed over threads.
    fn seconds(&self) -> f64 {
        match self {
            Self::Exr { encoder, .. } => encoder.seconds(),
            Self::Separate { picture, layers } => {
                picture.seconds() + layers.iter().map(|(_, file)| file.seconds()).sum::<f64>()
            }
        }
    }

    /// The picture comes last: where only some can be put in place, it is not among them.
    fn finish(self) -> Result<(), EncodeError> {
        match self {
            Self::Exr { encoder, .. } => encoder.finish(),
            Self::Separate { picture, layers } => {
                layers.into_iter().try_for_each(|(_, file)| file.finish())?;
                picture.finish()
            }
        }
    }
}

fn layer_target(picture: &Target, layer: PictureLayer) -> Target {
    match picture {
        Target::File(path) => Target::File(layer_path(path, layer)),
        Target::Stdout => Target::Stdout,
    }
}
