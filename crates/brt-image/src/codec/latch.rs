//! A shared sink that remembers its first error.
//!
//! The PNG library keeps its writer to itself, and part of it panics when that writer fails.
//! So it is given a writer that never fails: the error is remembered here, the sink dropped at
//! once (which removes an incomplete file), and the encoder asks after each band.

use std::io::{self, Write};
use std::sync::{Arc, Mutex, PoisonError};

use super::sink::Sink;

/// One of two handles on a sink: the library writes through one, the encoder asks the other.
pub(crate) struct Latch(Arc<Mutex<State>>);

enum State {
    Open(Box<dyn Sink>),
    /// The error is taken out by the first who asks.
    Failed(Option<io::Error>),
}

impl Latch {
    /// Two handles on the sink.
    pub(crate) fn pair(sink: Box<dyn Sink>) -> (Self, Self) {
        let shared = Arc::new(Mutex::new(State::Open(sink)));
        (Self(Arc::clone(&shared)), Self(shared))
    }

    /// Has everything gone well so far?
    ///
    /// # Errors
    /// The sink's first error.
    pub(crate) fn check(&self) -> io::Result<()> {
        self.with(|state| match state {
            State::Open(_) => Ok(()),
            State::Failed(error) => Err(error.take().unwrap_or_else(closed)),
        })
    }

    /// Commits the sink.
    ///
    /// # Errors
    /// The sink's first error.
    pub(crate) fn commit(&self) -> io::Result<()> {
        match self.with(|state| std::mem::replace(state, State::Failed(None))) {
            State::Open(sink) => sink.commit(),
            State::Failed(error) => Err(error.unwrap_or_else(closed)),
        }
    }

    fn with<R>(&self, act: impl FnOnce(&mut State) -> R) -> R {
        act(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

fn closed() -> io::Error {
    io::Error::other("the picture was given up after an earlier error")
}

impl Write for Latch {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.with(|state| {
            if let State::Open(sink) = state
                && let Err(error) = sink.write_all(bytes)
            {
                *state = State::Failed(Some(error));
            }
        });
        Ok(bytes.len())
    }

    /// The sink is flushed when it is committed.
    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
