//! Ctrl-C: the rendering ends at its next tile, and files that were begun are removed.

use std::sync::atomic::{AtomicBool, Ordering};

/// What shells expect of a command that was interrupted.
pub(crate) const EXIT_CODE: u8 = 130;

static CANCEL: AtomicBool = AtomicBool::new(false);
/// Is something going on that asks for `CANCEL` and has files to remove?
static LISTENING: AtomicBool = AtomicBool::new(false);

/// From now on an interrupt only sets the flag that is returned. The second one ends the process at once, for those
/// who cannot wait; a hidden `.part` file may stay then.
pub(crate) fn listen() -> &'static AtomicBool {
    let handler = || {
        let first = !CANCEL.swap(true, Ordering::Relaxed);
        if !(first && LISTENING.load(Ordering::Relaxed)) {
            std::process::exit(i32::from(EXIT_CODE));
        }
    };
    // Without a handler an interrupt ends the process, which is good enough.
    LISTENING.store(ctrlc::set_handler(handler).is_ok(), Ordering::Relaxed);
    &CANCEL
}
