//! `brt completions` and `brt man`: what shells and `man` want to know, made from the command line's own definition.

use clap::{Args, Command};
use clap_complete::{Shell, generate};

use crate::exit::{Failure, Outcome};
use crate::output;

/// Options of `brt completions`.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Shell to complete in
    #[arg(value_enum, value_name = "SHELL")]
    shell: Shell,
}

/// Prints a completion script.
pub(crate) fn completions(options: &Options, mut command: Command) -> Result<Outcome, Failure> {
    let mut script = Vec::new();
    generate(options.shell, &mut command, "brt", &mut script);
    print(&script)
}

/// Prints the page of the whole command, followed by those of its subcommands.
pub(crate) fn man(mut command: Command) -> Result<Outcome, Failure> {
    command.build();
    let mut page = Vec::new();
    clap_mangen::Man::new(command.clone()).render(&mut page)?;
    for subcommand in command.get_subcommands().filter(|c| c.get_name() != "help") {
        clap_mangen::Man::new(subcommand.clone()).render(&mut page)?;
    }
    print(&page)
}

fn print(bytes: &[u8]) -> Result<Outcome, Failure> {
    output::bytes(bytes)?;
    Ok(Outcome::Done)
}
