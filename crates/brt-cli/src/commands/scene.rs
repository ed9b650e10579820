//! `brt scene`: our named scenes as files.

use std::path::PathBuf;

use brt::{library, write_toml};
use clap::Args;

use super::convert::check_toml_name;
use crate::commands::text_file;
use crate::context::Context;
use crate::exit::{Failure, Outcome, wrong_use};
use crate::output;

/// Options of `brt scene`.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Name of the scene; without one all are listed
    #[arg(value_name = "NAME")]
    name: Option<String>,
    /// How large a scene is built; what it counts differs from scene to scene
    #[arg(long, value_name = "K", allow_negative_numbers = true, requires = "name")]
    size: Option<u32>,
    /// TOML file to write; `-` for standard output
    #[arg(short, long, value_name = "FILE", default_value = "-")]
    output: PathBuf,
}

/// Writes a scene, or lists all.
pub(crate) fn run(options: &Options, context: &Context) -> Result<Outcome, Failure> {
    let Some(name) = &options.name else {
        return list();
    };
    let unknown = || wrong_use(format!("no scene is named `{name}`; `brt scene` lists those there are"));
    let scene = library::find(name).ok_or_else(unknown)?;
    check_toml_name(&options.output)?;
    let built = scene.build(options.size).map_err(|error| wrong_use(error.to_string()))?;
    text_file::write(text_file::open(&options.output, &context.files)?, &write_toml(&built))?;
    context.files.commit()?;
    Ok(Outcome::Done)
}

fn list() -> Result<Outcome, Failure> {
    for scene in library::all() {
        output::line(&format!("{:<13} {}", scene.name, scene.summary))?;
        if let Some((meaning, default)) = scene.size() {
            output::line(&format!("{:<13} --size {default}: {meaning}", ""))?;
        }
    }
    Ok(Outcome::Done)
}
