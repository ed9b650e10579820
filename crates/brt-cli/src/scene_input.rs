//! Scene files and standard input, with the limits that the command line sets.

use std::io::{self, Read};
use std::path::{Path, PathBuf};

use brt::formats::{Foreign, ParseError};
use brt::image::Place;
use brt::{
    CheckedScene, Format, Given, Imported, Limits, LoadError, Loaded, Report, import, library, load_as,
};
use clap::Args;

use crate::exit::{Failure, wrong_use};
use crate::interrupt::Interrupt;
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
    /// Refuse scenes that need more memory for files, pictures and all they show, such as 512MiB, 2GB or a number of bytes
    /// [default: half of the machine's, at most 8GiB]
    #[arg(long, value_name = "SIZE", allow_hyphen_values = true, value_parser = values::bytes)]
    max_memory: Option<u64>,
    /// Accept small files that expand enormously: above 512 MiB to more than 10,000 times what was read, or parts of a zip
    /// file of more than 16 MiB that were packed to less than a hundredth
    #[arg(long)]
    allow_expansion: bool,
    /// Read files that the scene names from outside its folder, too
    #[arg(long)]
    allow_outside: bool,
}

impl LimitOptions {
    /// The limits of the library.
    ///
    /// The scene's picture size is checked where it is used: options may name another.
    pub(crate) fn limits(self, interrupt: &Interrupt) -> Limits<'_> {
        let Self { max_memory, allow_expansion, allow_outside } = self;
        let defaults = Limits::default();
        Limits {
            memory: max_memory.unwrap_or(defaults.memory),
            any_expansion: allow_expansion,
            max_picture_pixels: u64::MAX,
            files_outside: allow_outside,
            cancel: Some(interrupt.flag()),
        }
    }
}

/// A scene, and what its importer had to say.
pub(crate) struct SceneInput {
    pub(crate) scene: CheckedScene,
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
pub(crate) fn read(
    path: &Path,
    options: &InputOptions,
    interrupt: &Interrupt,
) -> Result<SceneInput, Failure> {
    let limits = options.limits.limits(interrupt);
    let format = options.input_format;
    let input = if is_dash(path) { read_stdin(format, &limits) } else { read_file(path, format, &limits) }?;
    if options.strict && !input.report.diagnostics.is_empty() {
        input.show_warnings();
        let count = input.report.diagnostics.len();
        let warnings = if count == 1 { "warning" } else { "warnings" };
        return Err(anyhow::anyhow!("{}: {count} {warnings}; `--strict` allows none", input.name).into());
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

/// Why standard input was read as it was.
const UNKNOWN: &str = "read as TOML, since it looks like nothing else; `--input-format` names another format";

fn read_stdin(format: Option<Format>, limits: &Limits) -> Result<SceneInput, Failure> {
    let name = "standard input".to_owned();
    let mut bytes = Vec::new();
    io::stdin().lock().take(limits.file_bytes().saturating_add(1)).read_to_end(&mut bytes)?;
    if bytes.trim_ascii().is_empty() {
        return Err(anyhow::anyhow!("{name} is empty").into());
    }
    let known = format.or_else(|| Format::from_content(&bytes));
    if let (None, Some(foreign)) = (known, Foreign::of(Path::new(""), &bytes)) {
        return Err(anyhow::anyhow!("{name}: {foreign}").into());
    }
    let hint = known.is_none().then(|| UNKNOWN.to_owned());
    match import(known.unwrap_or(Format::Toml), &bytes, None, limits) {
        Ok(Imported { scene, report, given, files }) => {
            Ok(SceneInput { scene, report, given, files, text: text_of(bytes), name })
        }
        Err(ParseError::Malformed(report)) => {
            let failure = malformed(&report, &name, &text_of(bytes));
            hint.iter().for_each(|hint| output::hint(hint));
            Err(failure)
        }
        Err(ParseError::Cancelled) => Err(Failure::Interrupted),
        Err(error) => Err(Failure::CouldNot { error: anyhow::anyhow!("{name}: {error}"), hint }),
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
        LoadError::Cancelled { .. } => return Failure::Interrupted,
        _ => None,
    };
    Failure::CouldNot { error: error.into(), hint }
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
pub(crate) fn same_file(a: &Path, b: &Path) -> bool {
    match (Place::of(a), Place::of(b)) {
        (Ok(a), Ok(b)) => a == b,
        _ => a == b,
    }
}
