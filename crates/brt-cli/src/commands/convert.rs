//! `brt convert`: any scene that can be read, as TOML.

use std::path::PathBuf;

use brt::{Format, write_toml};
use clap::Args;

use crate::commands::text_file::TextFile;
use crate::exit::{Failure, Outcome, wrong_use};
use crate::scene_input::{self, LimitOptions, check_distinct, is_dash};

/// Options of `brt convert`.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Scene file; `-` reads TOML from standard input
    #[arg(value_name = "IN")]
    input: PathBuf,
    /// TOML file to write; `-` for standard output
    #[arg(value_name = "OUT.toml")]
    output: PathBuf,
    /// Options that bound the scene
    #[command(flatten)]
    limits: LimitOptions,
}

/// Converts a scene.
pub(crate) fn run(options: &Options) -> Result<Outcome, Failure> {
    let Options { input, output, limits } = options;
    check_toml_name(output)?;
    check_distinct(input, std::slice::from_ref(output))?;
    let input = scene_input::read(input, &limits.limits(u64::MAX))?;
    input.show_warnings();
    TextFile::open(output)?.write(&write_toml(&input.scene))?;
    Ok(Outcome::Done)
}

/// Refuses file names of other formats.
pub(super) fn check_toml_name(path: &std::path::Path) -> Result<(), Failure> {
    if is_dash(path) || Format::from_path(path).is_some_and(Format::writes) {
        return Ok(());
    }
    Err(wrong_use(format!("{}: scenes are written as TOML, expected a name with `.toml`", path.display())))
}
