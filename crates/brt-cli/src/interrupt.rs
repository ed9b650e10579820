//! Wishes to stop: Ctrl-C and its like.
//!
//! A signal sets a flag, which the long loops ask for; the command returns then, and gives up its files on the way. Not
//! everything asks: a library that reads a model, a write to a pipe that nobody reads. So the thread that took the signal
//! waits a little, and if the process is still there, removes the files that were begun and ends it.

use std::process;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU8, Ordering};
use std::thread;
use std::time::Duration;

use brt::image::AbortHandle;

use crate::output;
use crate::signals::{self, Signal};

/// How long the command may take to return by itself.
const GRACE: Duration = Duration::from_millis(350);
/// How long each further step may take: together they stay well below a second.
const PATIENCE: Duration = Duration::from_millis(150);

/// Whether and why the command is to stop.
pub(crate) struct Interrupt(Arc<State>);

#[derive(Default)]
struct State {
    cancel: AtomicBool,
    /// The exit code for the signal that came.
    code: AtomicU8,
    was_told: AtomicBool,
}

impl Interrupt {
    /// From now on a signal does not end the process at once.
    pub(crate) fn listen(files: AbortHandle) -> Self {
        let state = Arc::new(State::default());
        let heard = Arc::clone(&state);
        signals::on_first(move |signal| stop(signal, &heard, &files));
        Self(state)
    }

    /// Set once a signal came.
    pub(crate) fn flag(&self) -> &AtomicBool {
        &self.0.cancel
    }

    /// The exit code that tells of the signal, if one came.
    pub(crate) fn exit_code(&self) -> Option<u8> {
        self.0.cancel.load(Ordering::Acquire).then(|| self.0.code.load(Ordering::Relaxed))
    }

    /// The last words, once.
    pub(crate) fn tell(&self) {
        self.0.tell(true);
    }
}

impl State {
    fn tell(&self, no_file_was_written: bool) {
        if !self.was_told.swap(true, Ordering::Relaxed) {
            output::error(if no_file_was_written {
                "interrupted, no file was written"
            } else {
                "interrupted"
            });
        }
    }
}

/// On the thread that took the signal.
fn stop(signal: Signal, state: &Arc<State>, files: &AbortHandle) {
    state.code.store(signal.exit_code(), Ordering::Relaxed);
    state.cancel.store(true, Ordering::Release);
    thread::sleep(GRACE);
    let no_file_was_written = files.abort(PATIENCE);
    // Standard error may be stuck, and so may be the end of the process, which flushes standard output.
    let state = Arc::clone(state);
    let ending = thread::Builder::new().spawn(move || {
        state.tell(no_file_was_written);
        process::exit(signal.exit_code().into());
    });
    if ending.is_ok() {
        thread::sleep(PATIENCE);
    }
    signals::end_by(signal);
}
