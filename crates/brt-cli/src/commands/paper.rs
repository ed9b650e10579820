//! `brt paper`: every table and figure of the paper, measured here, as one page.

use std::path::{Path, PathBuf};

use brt_lab::paper::{self, PaperError, Watch};
use clap::Args;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::context::Context;
use crate::exit::{Failure, Outcome};
use crate::output;
use crate::scene_input::{self, InputOptions};

/// Sizes beyond this cost hours.
const GREATEST_SIZE: u32 = 16_384;

/// Options of `brt paper`.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Folder for the page and its tables, made if need be
    #[arg(short, long, value_name = "DIR", default_value = "paper-out")]
    output: PathBuf,
    /// Widths and heights of the pictures that are timed [default: 128,256,512,1024,2048; 128,256,512 with --quick]
    #[arg(long, value_name = "LIST", allow_hyphen_values = true, value_delimiter = ',',
          value_parser = clap::value_parser!(u32).range(16..=i64::from(GREATEST_SIZE)))]
    sizes: Option<Vec<u32>>,
    /// Repetitions of each time, of which the median counts [default: 3; 1 with --quick]
    #[arg(long, value_name = "N", allow_negative_numbers = true,
          value_parser = clap::value_parser!(u32).range(1..=100))]
    repeat: Option<u32>,
    /// The same experiments on your own scene instead of the paper's
    #[arg(long, value_name = "FILE")]
    scene: Option<PathBuf>,
    /// A quick look: smaller pictures, no repetitions
    #[arg(long)]
    quick: bool,
    #[command(flatten)]
    reading: InputOptions,
}

/// Measures, and writes the page.
pub(crate) fn run(options: &Options, context: &Context) -> Result<Outcome, Failure> {
    let scene = options.scene.as_deref().map(|path| own_scene(options, path, context)).transpose()?;
    let sizes: &[u32] = if options.quick { &paper::Options::QUICK_SIZES } else { &paper::Options::SIZES };
    let repeat = if options.quick { 1 } else { paper::Options::REPEAT };
    let experiments = paper::Options {
        sizes: options.sizes.clone().unwrap_or_else(|| sizes.to_vec()),
        repeat: options.repeat.unwrap_or(repeat),
        quick: options.quick,
        scene,
    };
    let spinner = output::errors_are_seen().then(spinner);
    let doing = |what: &str| {
        if let Some(spinner) = &spinner {
            spinner.set_message(what.to_owned());
        }
    };
    let watch = Watch { doing: &doing, cancel: Some(context.interrupt.flag()) };
    let summary = paper::run(&experiments, &options.output, &context.files, watch).map_err(failure)?;
    if let Some(spinner) = &spinner {
        spinner.finish_and_clear();
    }
    for (claim, verdict) in &summary.verdicts {
        output::line(&format!("{claim:<4} {verdict}"))?;
    }
    output::line(&format!("{}", summary.page.display()))?;
    Ok(Outcome::Done)
}

fn own_scene(options: &Options, path: &Path, context: &Context) -> Result<(String, brt::Scene), Failure> {
    let input = scene_input::read(path, &options.reading, &context.interrupt)?;
    input.show_warnings();
    let name =
        path.file_stem().map_or_else(|| "scene".to_owned(), |stem| stem.to_string_lossy().into_owned());
    Ok((name, input.scene.into_inner()))
}

fn spinner() -> ProgressBar {
    let spinner = ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr_with_hz(10));
    if let Ok(style) = ProgressStyle::with_template("{spinner} {elapsed} · {msg}") {
        spinner.set_style(style);
    }
    spinner.enable_steady_tick(std::time::Duration::from_millis(200));
    spinner
}

fn failure(error: PaperError) -> Failure {
    match error {
        PaperError::Render(brt::RenderError::Cancelled) => Failure::Interrupted,
        error => error.into(),
    }
}
