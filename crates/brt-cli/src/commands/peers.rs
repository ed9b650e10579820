//! `brt peers`: the same scenes through other ray tracers, side by side with ours.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::time::Duration;

use brt::{Scene, library};
use brt_lab::peers::{self, PeersError, Recording, Watch};
use clap::Args;

use crate::context::Context;
use crate::exit::{Failure, Outcome, wrong_use};
use crate::output;
use crate::scene_input::{self, InputOptions, check_distinct};

/// Options of `brt peers`.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Scene files, or names of our own scenes
    #[arg(value_name = "SCENES", default_values = ["seed-a", "seed-b", "seed-c"])]
    scenes: Vec<PathBuf>,
    /// Folder for the page, its table and the scenes as the peers read them, made if need be
    #[arg(short, long, value_name = "DIR", default_value = "peers-out")]
    output: PathBuf,
    /// Longer sides of the pictures that are timed; their errors are measured at the first
    #[arg(long, value_name = "LIST", value_delimiter = ',', default_value = "512,1024,2048",
          allow_hyphen_values = true, value_parser = clap::value_parser!(u32).range(32..=32_768))]
    sizes: Vec<u32>,
    /// Runs of which the median counts
    #[arg(long, value_name = "N", default_value_t = 3, allow_negative_numbers = true,
          value_parser = clap::value_parser!(u32).range(1..=100))]
    repeat: u32,
    /// Stop a single run after this time
    #[arg(long, value_name = "SECONDS", default_value_t = 300, allow_negative_numbers = true,
          value_parser = clap::value_parser!(u32).range(1..=86_400))]
    timeout: u32,
    /// Only one sample per pixel, no anti-aliasing
    #[arg(long)]
    plain: bool,
    /// Add the medians to this history, made if need be; the page has charts of it
    #[arg(long, value_name = "CSV")]
    record: Option<PathBuf>,
    /// What the history calls this program: a version, a commit
    #[arg(long, value_name = "TEXT", default_value = env!("CARGO_PKG_VERSION"), requires = "record", value_parser = label)]
    label: String,
    /// Options that bound scenes
    #[command(flatten)]
    reading: InputOptions,
}

/// Measures, and writes the page.
pub(crate) fn run(options: &Options, context: &Context) -> Result<Outcome, Failure> {
    let measured = peers::Options {
        scenes: scenes(options, context)?,
        sizes: options.sizes.clone(),
        repeat: options.repeat,
        timeout: Duration::from_secs(options.timeout.into()),
        plain: options.plain,
        record: options.record.clone().map(|file| Recording { file, label: options.label.clone() }),
        ours: std::env::current_exe()?,
    };
    let seen = output::errors_are_seen();
    let doing = |what: &str| {
        if seen {
            output::note(what);
        }
    };
    let watch = Watch { doing: &doing, cancel: Some(context.interrupt.flag()) };
    let summary = peers::run(&measured, &options.output, &context.files, watch).map_err(failure)?;
    for note in &summary.notes {
        output::note(&format!("note: {note}"));
    }
    output::line(&summary.table)?;
    output::line(&summary.page.display().to_string())?;
    Ok(Outcome::Done)
}

/// Files first: a name of ours may be that of a file, too.
fn scenes(options: &Options, context: &Context) -> Result<Vec<(String, Scene)>, Failure> {
    let mut scenes: Vec<(String, Scene)> = Vec::new();
    for path in &options.scenes {
        let named = path.to_str().and_then(library::find).filter(|_| !path.exists());
        let scene = match named {
            Some(named) => named.build(None)?,
            None => {
                check_spared(options, path)?;
                let input = scene_input::read(path, &options.reading, &context.interrupt)?;
                input.show_warnings();
                input.scene.into_inner()
            }
        };
        let name = path.file_stem().unwrap_or(OsStr::new("scene")).to_string_lossy().into_owned();
        if scenes.iter().any(|(known, _)| *known == name) {
            return Err(wrong_use(format!("two scenes are named `{name}`")));
        }
        scenes.push((name, scene));
    }
    Ok(scenes)
}

/// Refuses scenes that would be replaced by what the peers read.
fn check_spared(options: &Options, scene: &Path) -> Result<(), Failure> {
    let copy = scene.with_extension("toml");
    let outputs: Vec<PathBuf> = copy.file_name().map(|name| options.output.join(name)).into_iter().collect();
    check_distinct(scene, &outputs)
}

/// Text on one line.
fn label(text: &str) -> Result<String, String> {
    if text.is_empty() || text.contains(char::is_control) {
        return Err("expected a few letters on one line".to_owned());
    }
    Ok(text.to_owned())
}

fn failure(error: PeersError) -> Failure {
    match error {
        PeersError::Cancelled => Failure::Interrupted,
        error => error.into(),
    }
}
