//! Where encoded bytes go.

use std::io::{self, Write};

/// A destination of bytes that becomes valid only by [`Sink::commit`].
///
/// A sink dropped without it must leave no valid looking file behind, where it can.
pub trait Sink: Write + Send {
    /// Can [`Sink::patch`] be used?
    fn can_patch(&self) -> bool {
        false
    }

    /// Overwrites bytes that were written before, from `offset` bytes after the start.
    ///
    /// # Errors
    /// If the device fails, or the sink cannot go back.
    fn patch(&mut self, offset: u64, bytes: &[u8]) -> io::Result<()> {
        let _ = (offset, bytes);
        Err(io::ErrorKind::Unsupported.into())
    }

    /// All bytes are written: flush them, and put them in place.
    ///
    /// # Errors
    /// If the device fails; nothing is in place then.
    fn commit(self: Box<Self>) -> io::Result<()>;
}

/// Any writer as a sink that only flushes.
#[derive(Debug)]
pub struct PlainSink<W>(pub W);

impl<W: Write> Write for PlainSink<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush()
    }
}

impl<W: Write + Send> Sink for PlainSink<W> {
    fn commit(mut self: Box<Self>) -> io::Result<()> {
        self.flush()
    }
}
