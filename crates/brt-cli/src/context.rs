//! What every command works with.

use brt::FileSet;

use crate::interrupt::Interrupt;

/// The files of a command, and whether it is to stop.
pub(crate) struct Context {
    /// All that it writes, for all to appear together.
    pub(crate) files: FileSet,
    /// Set by signals.
    pub(crate) interrupt: Interrupt,
}

impl Context {
    /// Listens to signals from now on. Threads that are started before would take them away.
    pub(crate) fn new() -> Self {
        let files = FileSet::new();
        let interrupt = Interrupt::listen(files.abort_handle());
        Self { files, interrupt }
    }
}
