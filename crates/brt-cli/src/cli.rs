//! The command line: subcommands and their dispatch.

use clap::error::ErrorKind;
use clap::{CommandFactory, Parser, Subcommand};

use crate::commands::{compare, convert, formats, inspect, paper, peers, render, scene, shell};
use crate::context::Context;
use crate::exit::{Failure, Outcome};
use crate::output;

/// Border ray tracing: noise-free stills whose cost grows with the borders in the picture, not with its pixels.
#[derive(Debug, Parser)]
#[command(name = "brt", version, max_term_width = 100)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Render a scene to a picture
    Render(Box<render::Options>),
    /// Measure how far two pictures differ
    Compare(compare::Options),
    /// Show what is in a scene and what was not understood
    Inspect(inspect::Options),
    /// Rewrite any readable scene as TOML, or for POV-Ray or Tachyon
    Convert(convert::Options),
    /// Write one of our named scenes, or list them
    Scene(scene::Options),
    /// List the formats that can be read and written
    Formats,
    /// Measure every table and figure of the 1987 paper here, as one page
    Paper(paper::Options),
    /// Time the same scenes in POV-Ray and Tachyon, and compare the pictures
    Peers(peers::Options),
    /// Print a script that completes `brt` in a shell
    Completions(shell::Options),
    /// Print the manual page
    Man,
}

/// Does what the command line asks for.
pub(crate) fn run(context: &Context) -> Result<Outcome, Failure> {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) => return no_command(error),
    };
    match cli.command {
        Command::Render(options) => render::run(&options, context),
        Command::Compare(options) => compare::run(&options, context),
        Command::Inspect(options) => inspect::run(&options, context),
        Command::Convert(options) => convert::run(&options, context),
        Command::Scene(options) => scene::run(&options, context),
        Command::Formats => formats::run(),
        Command::Paper(options) => paper::run(&options, context),
        Command::Peers(options) => peers::run(&options, context),
        Command::Completions(options) => shell::completions(&options, Cli::command()),
        Command::Man => shell::man(Cli::command()),
    }
}

/// Help and version are no errors.
fn no_command(error: clap::Error) -> Result<Outcome, Failure> {
    match error.kind() {
        ErrorKind::DisplayHelp | ErrorKind::DisplayVersion => {
            output::printed(error.print())?;
            Ok(Outcome::Done)
        }
        _ => Err(Failure::CommandLine(error)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn definition_is_sound() {
        Cli::command().debug_assert();
    }
}
