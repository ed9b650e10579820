//! From a scene to picture files.

use std::time::Instant;

use brt_image::{Channels, EncodeError, Encoding, FileSet, PictureSize};
use brt_render::{CheckedPixels, RenderError, Run, Settings, Stats, Window, render};
use brt_scene::CheckedScene;
use thiserror::Error;

use crate::layer_paint::PicturePainter;
use crate::measure::{ErrorMeasure, Verification};
use crate::output::Output;
use crate::picture_files::PictureFiles;

/// What came of rendering to files.
#[derive(Clone, Debug, PartialEq)]
pub struct Rendered {
    /// Counts and times.
    pub stats: Stats,
    /// Time for encoding and writing, and for measuring the error, summed over threads: most of it while others rendered.
    pub encode_seconds: f64,
    /// Error against full ray tracing, if [`Settings::checked`] asked for it or a layer needed it.
    pub verification: Option<Verification>,
}

/// Why there are no files.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum RenderFilesError {
    /// The rendering failed or was cancelled.
    #[error(transparent)]
    Render(RenderError),
    /// A file could not be written.
    #[error(transparent)]
    Encode(#[from] EncodeError),
}

impl From<RenderError> for RenderFilesError {
    /// A sink that fails is one of our files.
    fn from(error: RenderError) -> Self {
        match error {
            RenderError::Sink(error) => match error.downcast() {
                Ok(error) => Self::Encode(*error),
                Err(error) => Self::Render(RenderError::Sink(error)),
            },
            error => Self::Render(error),
        }
    }
}

/// Renders a scene to a picture and its layers.
///
/// `settings.layers` need not be given: they follow from the output's. So do the output's channels from the backdrop.
/// Files appear when all are complete; if anything fails, those that existed before are as they were.
///
/// # Errors
/// If a file cannot be written, or see [`render`].
pub fn render_to_files(
    scene: &CheckedScene,
    settings: &Settings,
    run: &Run,
    output: &Output,
) -> Result<Rendered, RenderFilesError> {
    let set = FileSet::new();
    let rendered = render_into(&set, scene, settings, run, output)?;
    set.commit().map_err(EncodeError::Io)?;
    Ok(rendered)
}

/// The same for files that appear with those that the set holds already, and with those it gets later: when it is
/// [committed](FileSet::commit).
///
/// # Errors
/// See [`render_to_files`].
pub fn render_into(
    set: &FileSet,
    scene: &CheckedScene,
    settings: &Settings,
    run: &Run,
    output: &Output,
) -> Result<Rendered, RenderFilesError> {
    let settings = with_layers_of(output, settings);
    let output = &with_channels_for(&settings, output);
    let encoding = output.encoding;
    let Window { width, height, .. } = settings.whole().map_err(RenderFilesError::Render)?;
    let size = PictureSize::new(width, height);
    let painter = PicturePainter::new(scene, encoding);
    let measure = (settings.checked != CheckedPixels::None).then(|| ErrorMeasure::new(encoding, &settings));
    let mut files = PictureFiles::open(output, set, size, painter, measure)?;
    let stats = render(scene, &settings, run, &mut files)?;
    let beside = files.seconds();
    let begin = Instant::now();
    let verification = files.finish()?;
    let encode_seconds = beside + begin.elapsed().as_secs_f64();
    Ok(Rendered { stats, encode_seconds, verification })
}

/// The picture has an alpha if the backdrop is transparent.
fn with_channels_for(settings: &Settings, output: &Output) -> Output {
    let channels = if settings.backdrop.has_alpha() { Channels::Rgba } else { Channels::Rgb };
    Output { encoding: Encoding { channels, ..output.encoding }, ..output.clone() }
}

fn with_layers_of(output: &Output, settings: &Settings) -> Settings {
    let mut settings = settings.clone();
    for layer in &output.layers {
        match layer.source() {
            Some(source) if !settings.layers.contains(&source) => settings.layers.push(source),
            Some(_) => {}
            None => settings.checked = CheckedPixels::All,
        }
    }
    settings
}
