//! Scene files and standard input, with the limits that the command line sets.

use std::io::{self, Read};
use std::path::{Path, PathBuf};

use brt::formats::{LimitExceeded, LimitKind, ParseError};
use brt::image::Place;
use brt::{Format, Given, Imported, Limits, LoadError, Loaded, Report, Scene, import, library, load_as};
use clap::Args;

use crate::exit::{Failure, wrong_use};
use crate::{diagnostics, output, values};

/// Options for how a scene file is read.
#[derive(Clone, Copy, Debug, Args)]
pub(crate) struct InputOptions {
    /// Format of the scene file [default: by content and name; TOML on standard input that looks like nothing else]
    #[arg(long, value_name = "FORMAT", value_parser = values::input_format())]
    input_format: Option<Format>,
    /// Refuse scenes in which anything was not understood
    #[arg(long)]
    strict: bool,
    /// Options that bound the scene
    #[command(flatten)]
    limits: LimitOptions,
}

/// Options that bound what a scene file may ask for.
#[derive(Clone, Copy, Debug, Args)]
#[command(next_help_heading = "Limits")]
pub(crate) struct LimitOptions {
    /// Refuse scenes of more primitives
    #[arg(long, value_name = "N", default_value_t = Limits::DEFAULT_OBJECTS)]
    max_objects: u64,
    /// Refuse larger scene files [default: 1073741824]
    #[arg(long, value_name = "N")]
    max_bytes: Option<u64>,
    /// Read files that the scene names from outside of its folder, too
    #[arg(long)]
    allow_outside: bool,
}

impl LimitOptions {
    /// The limits, with those that have no option of their own raised along: a file has fewer words than bytes, and a
    /// triangle has three points.
    pub(crate) fn limits(self, max_pixels: u64) -> Limits {
        let Self { max_objects, max_bytes, allow_outside } = self;
        let defaults = Limits::default();
        Limits {
            bytes: max_bytes.unwrap_or(defaults.bytes),
            words: max_bytes.map_or(defaults.words, |bytes| bytes.max(defaults.words)),
            objects: max_objects,
            points: defaults.points.max(max_objects.saturating_mul(3)),
            max_picture_pixels: max_pixels,
            texture_pixels: defaults.texture_pixels,
            files_outside: allow_outside,
        }
    }
}

/// A scene, and what its importer had to say.
pub(crate) struct SceneInput {
    pub(crate) scene: Scene,
    pub(crate) report: Report,
    pub(crate) given: Given,
    /// The other files that were read for it.
    pub(crate) files: Vec<PathBuf>,
    text: String,
    name: String,
}

impl SceneInput {
    /// Draws warnings.
    pub(crate) fn show_warnings(&self) {
        if !self.report.diagnostics.is_empty() {
            output::drawn(&diagnostics::draw(&self.report, &self.name, &self.text));
        }
    }
}

/// Is it standard input or output?
pub(crate) fn is_dash(path: &Path) -> bool {
    path.as_os_str() == "-"
}

/// Reads a scene from a file or from standard input. Errors in it are drawn; with `--strict`, warnings are errors.
pub(crate) fn read(path: &Path, options: &InputOptions, max_pixels: u64) -> Result<SceneInput, Failure> {
    let limits = options.limits.limits(max_pixels);
    let format = options.input_format;
    let input = if is_dash(path) { read_stdin(format, &limits) } else { read_file(path, format, &limits) }?;
    if options.strict && !input.report.diagnostics.is_empty() {
        input.show_warnings();
        let count = input.report.diagnostics.len();
        return Err(
            anyhow::anyhow!("{}: {count} warnings, which `--strict` does not let pass", input.name).into()
        );
    }
    Ok(input)
}

fn read_file(path: &Path, format: Option<Format>, limits: &Limits) -> Result<SceneInput, Failure> {
    let name = path.display().to_string();
    match load_as(path, format, limits) {
        Ok(Loaded { scene, report, given, files, text }) => {
            Ok(SceneInput { scene, report, given, files, text, name })
        }
        Err(LoadError::Malformed { report, text, .. }) => Err(malformed(&report, &name, &text)),
        Err(error) => Err(cannot_load(path, error)),
    }
}

fn read_stdin(format: Option<Format>, limits: &Limits) -> Result<SceneInput, Failure> {
    let name = "standard input".to_owned();
    let mut bytes = Vec::new();
    io::stdin().lock().take(limits.bytes.saturating_add(1)).read_to_end(&mut bytes)?;
    let format = format.or_else(|| Format::from_content(&bytes)).unwrap_or(Format::Toml);
    match import(format, &bytes, None, limits) {
        Ok(Imported { scene, report, given, files }) => {
            Ok(SceneInput { scene, report, given, files, text: text_of(bytes), name })
        }
        Err(ParseError::Malformed(report)) => Err(malformed(&report, &name, &text_of(bytes))),
        Err(error) => {
            let hint = match &error {
                ParseError::LimitExceeded(exceeded) => limit_hint(exceeded),
                _ => None,
            };
            Err(Failure::CouldNot { error: anyhow::anyhow!("{name}: {error}"), hint })
        }
    }
}

/// The text that positions are in; binary formats have none.
fn text_of(bytes: Vec<u8>) -> String {
    String::from_utf8(bytes).unwrap_or_default()
}

fn malformed(report: &Report, name: &str, text: &str) -> Failure {
    output::drawn(&diagnostics::draw(report, name, text));
    Failure::Reported
}

/// Knows those who type `brt render seed-a`.
fn cannot_load(path: &Path, error: LoadError) -> Failure {
    let hint = match &error {
        LoadError::Io { source, .. } if source.kind() == io::ErrorKind::NotFound => {
            let name = path.to_str().filter(|name| library::find(name).is_some());
            name.map(|name| format!("`brt scene {name} -o {name}.toml` writes our scene of that name"))
        }
        LoadError::LimitExceeded { exceeded, .. } => limit_hint(exceeded),
        _ => None,
    };
    Failure::CouldNot { error: error.into(), hint }
}

/// Which option raises a limit.
fn limit_hint(exceeded: &LimitExceeded) -> Option<String> {
    let option = match exceeded.what {
        LimitKind::Bytes | LimitKind::Words => "--max-bytes",
        LimitKind::Objects | LimitKind::Points => "--max-objects",
        LimitKind::PicturePixels => "--max-pixels",
        LimitKind::TexturePixels => return None,
    };
    Some(format!("`{option} N` allows more"))
}

/// Refuses to write a file over one that the scene is made of.
pub(crate) fn check_spares(files: &[PathBuf], outputs: &[PathBuf]) -> Result<(), Failure> {
    match outputs.iter().find(|path| files.iter().any(|file| same_file(file, path))) {
        Some(path) => Err(wrong_use(format!(
            "{} would overwrite a file that the scene uses; `-o` names another",
            path.display()
        ))),
        None => Ok(()),
    }
}

/// Refuses to write a file over the scene it is made of, or two files to one place.
pub(crate) fn check_distinct(scene: &Path, outputs: &[PathBuf]) -> Result<(), Failure> {
    for (i, path) in outputs.iter().enumerate() {
        if !is_dash(scene) && same_file(scene, path) {
            return Err(wrong_use(format!("{} would overwrite the scene itself", path.display())));
        }
        if outputs[..i].iter().any(|earlier| same_file(earlier, path)) {
            return Err(wrong_use(format!("{} would be written twice", path.display())));
        }
    }
    Ok(())
}

/// Also of files that are not there yet.
fn same_file(a: &Path, b: &Path) -> bool {
    match (Place::of(a), Place::of(b)) {
        (Ok(a), Ok(b)) => a == b,
        _ => a == b,
    }
}
