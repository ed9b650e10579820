//! `brt convert`: any scene that can be read, as TOML or for another ray tracer.

use std::path::{Path, PathBuf};

use brt::{Format, write, write_beside};
use clap::Args;

use crate::commands::scene_files;
use crate::context::Context;
use crate::exit::{Failure, Outcome, wrong_use};
use crate::framing::frame;
use crate::scene_input::{self, InputOptions, check_distinct, is_dash};
use crate::{diagnostics, output, values};

/// Options of `brt convert`.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Scene file; `-` reads standard input
    #[arg(value_name = "IN")]
    input: PathBuf,
    /// File to write, .toml, .pov (POV-Ray) or .dat (Tachyon); `-` for TOML on standard output
    ///
    /// Beside `OUT.toml` large meshes become `OUT.NAME.ply` and pictures `OUT.NAME.png`, which it names; on standard
    /// output all stands in the text.
    #[arg(value_name = "OUT", required_unless_present = "output", conflicts_with = "output")]
    out: Option<PathBuf>,
    /// Same as OUT
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,
    /// Picture size that the scene asks for, and that a view without a camera is framed for [default: the scene's, else
    /// 1024x1024]
    #[arg(short, long, value_name = "WxH", allow_hyphen_values = true, value_parser = values::size)]
    size: Option<[u32; 2]>,
    /// Leave out warnings
    #[arg(short, long)]
    quiet: bool,
    /// Options for reading the scene
    #[command(flatten)]
    reading: InputOptions,
}

/// Converts a scene.
pub(crate) fn run(options: &Options, context: &Context) -> Result<Outcome, Failure> {
    let Options { input: from, size, reading, quiet, .. } = options;
    let path =
        options.output.as_ref().or(options.out.as_ref()).ok_or_else(|| wrong_use("no file to write"))?;
    let format = written_format(path)?;
    check_distinct(from, std::slice::from_ref(path))?;
    let input = scene_input::read(from, reading, &context.interrupt)?;
    if !quiet {
        input.show_warnings();
    }
    scene_input::check_spares(&input.files, std::slice::from_ref(path))?;
    let mut scene = input.scene.into_inner();
    if let Some(size) = *size {
        scene.size = Some(size);
        frame(&mut scene, &input.given, size);
    }
    let written = if is_dash(path) { write(format, &scene) } else { write_beside(format, &scene, path) }?;
    scene_files::put(from, path, &written, &context.files)?;
    let report = written.report;
    if !quiet && !report.diagnostics.is_empty() {
        output::drawn(&diagnostics::draw(&report, &path.display().to_string(), ""));
    }
    Ok(Outcome::Done)
}

/// The format that a file's name asks for; refuses those that are not written.
fn written_format(path: &Path) -> Result<Format, Failure> {
    if is_dash(path) {
        return Ok(Format::Toml);
    }
    Format::from_path(path).filter(|format| format.writes()).ok_or_else(|| {
        wrong_use(format!(
            "{}: not the name of a scene that can be written, expected `.toml`, `.pov` or `.dat`",
            path.display()
        ))
    })
}

/// Refuses file names of other formats than ours.
pub(super) fn check_toml_name(path: &Path) -> Result<(), Failure> {
    if is_dash(path) || Format::from_path(path) == Some(Format::Toml) {
        return Ok(());
    }
    Err(wrong_use(format!(
        "{}: our scenes are written as TOML, expected a name with `.toml`",
        path.display()
    )))
}
