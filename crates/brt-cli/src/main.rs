//! The command `brt`: reads scenes, renders them, compares pictures.
//!
//! Exit codes: 0 done; 1 could not (file, limit); 2 wrong use; 3 done, but over the stated limit; 101 a bug of ours;
//! 130 interrupted.

mod cli;
mod commands;
mod diagnostics;
mod exit;
mod framing;
mod habits;
mod interrupt;
mod json;
mod output;
mod panics;
mod progress;
mod scene_input;
mod values;

use std::process::ExitCode;

fn main() -> ExitCode {
    panics::install_hook();
    exit::run(cli::run)
}
