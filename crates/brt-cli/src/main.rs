//! The command `brt`: reads scenes, renders them, compares pictures.
//!
//! Exit codes: 0 done; 1 could not (file, limit); 2 wrong use; 3 done, but over the stated limit; 101 a bug of ours;
//! 129, 130 and 143 stopped by a signal (hangup, interrupt, termination).

mod cli;
mod commands;
mod context;
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
mod signals;
mod values;

use std::process::ExitCode;

use context::Context;

fn main() -> ExitCode {
    panics::install_hook();
    let context = Context::new();
    exit::run(&context.interrupt, || cli::run(&context))
}
