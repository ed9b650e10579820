//! A panic is our bug, and says so.

use std::panic::{self, PanicHookInfo};

use crate::output;

/// Exit code is 101, as for every panic; files that were begun are removed while the stack unwinds.
pub(crate) fn install_hook() {
    panic::set_hook(Box::new(|info| output::note(&message(info))));
}

fn message(info: &PanicHookInfo) -> String {
    let what = info.payload_as_str().unwrap_or("no message");
    let place = info.location().map(|l| format!(" at {l}")).unwrap_or_default();
    // Names of files need not be text.
    let command: Vec<String> = std::env::args_os().map(|arg| arg.to_string_lossy().into_owned()).collect();
    format!(
        "error: this is a bug in brt {}, not in your scene: {what}{place}\n\
         Please report it with the scene file and the command: {}",
        env!("CARGO_PKG_VERSION"),
        command.join(" "),
    )
}
