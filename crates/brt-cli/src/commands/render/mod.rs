//! `brt render`: from a scene to a picture.

mod method;
mod options;
mod paper;
mod pixel;
mod sheet;
mod stats_file;
mod summary;
mod targets;

use std::time::Instant;

use brt::image::EncodeError;
use brt::{CheckedScene, RenderError, RenderFilesError, Rendered, Run, Scene, Settings, render_into};

use crate::commands::text_file;
use crate::context::Context;
use crate::exit::{Failure, Outcome, wrong_use};
use crate::progress::{Bar, NoBar};
use crate::{output, scene_input};

pub(crate) use options::Options;
use stats_file::Seconds;
use targets::Targets;

/// Renders a scene.
pub(crate) fn run(options: &Options, context: &Context) -> Result<Outcome, Failure> {
    let begin = Instant::now();
    let targets = Targets::new(options)?;
    let method = method::chosen(options)?;

    let input = scene_input::read(&options.scene, &options.reading, &context.interrupt)?;
    scene_input::check_spares(&input.files, &targets.files())?;
    if !options.quiet {
        input.show_warnings();
    }
    // Its text may be large.
    let mut scene = input.scene.into_inner();
    let size = options.size.or(scene.size).unwrap_or([1024, 1024]);
    targets::check_size(size, options.max_pixels)?;
    let settings = settings(options, method, size);
    if options.view.sheet {
        if size.contains(&1) {
            return Err(wrong_use("a sheet needs at least 2×2 pixels"));
        }
        sheet::render(options, &targets, context, scene, &input.given, &settings)?;
        return Ok(Outcome::Done);
    }
    options.view.apply(&mut scene, &input.given, size)?;
    let scene = fit(scene)?;
    let load = begin.elapsed().as_secs_f64();
    if let Some(pixel) = options.pixel {
        return pixel::show(options, context, scene, settings, pixel.map(u64::from));
    }

    let stats_file =
        targets.stats.as_deref().map(|path| text_file::open(path, &context.files)).transpose()?;
    let rendered = render(options, context, &targets, &scene, &settings)?;
    let total = begin.elapsed().as_secs_f64();
    let seconds = Seconds::new(load, total, &rendered);
    if let Some(file) = stats_file {
        stats_file::write(file, &settings, options.thread_count(), &rendered, &seconds)?;
    }
    context.files.commit()?;
    summary::show(options, &targets, &settings, &rendered, total)?;
    Ok(outcome(options, &rendered))
}

/// The scene as options have changed it.
fn fit(scene: Scene) -> Result<CheckedScene, Failure> {
    scene.checked().map_err(|problems| {
        anyhow::anyhow!("with these options the scene has a fault: {}", problems[0]).into()
    })
}

fn settings(options: &Options, method: brt::Method, size: [u32; 2]) -> Settings {
    Settings {
        size: size.map(u64::from),
        samples: options.samples,
        filter: options.filter.into(),
        method,
        accelerator: options.paper.accelerator.into(),
        history: options.paper.history.unwrap_or_default().into(),
        max_depth: options.max_depth,
        layers: Vec::new(),
        checked: options.checked(),
        backdrop: options.view.backdrop(),
    }
}

fn render(
    options: &Options,
    context: &Context,
    targets: &Targets,
    scene: &CheckedScene,
    settings: &Settings,
) -> Result<Rendered, Failure> {
    let bar = (output::errors_are_seen() && !options.quiet).then(|| Bar::new(settings.size[1] as u32));
    let progress: &dyn brt::Progress = bar.as_ref().map_or(&NoBar, |bar| bar);
    let run = Run { progress: Some(progress), ..options.run(context) };
    render_into(&context.files, scene, settings, &run, &targets.picture).map_err(failure)
}

fn failure(error: RenderFilesError) -> Failure {
    match error {
        RenderFilesError::Render(RenderError::Cancelled) => Failure::Interrupted,
        RenderFilesError::Encode(EncodeError::Io(error)) => Failure::of_writing(error),
        error => error.into(),
    }
}

fn outcome(options: &Options, rendered: &Rendered) -> Outcome {
    let error = rendered.verification.map_or(0.0, |found| found.comparison.max_error);
    if options.is_over_limit(error) { Outcome::OverLimit } else { Outcome::Done }
}
