//! All that the command says.
//!
//! What goes to standard output is what the command was called for: if it cannot be written, that is an error. If its
//! reader went away, it is not, for nobody misses it. On standard error there is nobody to tell.

use std::io::{self, IsTerminal, Write};

/// A line on standard output.
///
/// # Errors
/// If it cannot be written.
pub(crate) fn line(text: &str) -> io::Result<()> {
    printed(writeln!(io::stdout().lock(), "{}", printable(text)))
}

/// Bytes on standard output.
///
/// # Errors
/// If they cannot be written.
pub(crate) fn bytes(bytes: &[u8]) -> io::Result<()> {
    printed(io::stdout().lock().write_all(bytes))
}

/// What became of something that was printed to standard output.
///
/// # Errors
/// If it did not get there.
pub(crate) fn printed(result: io::Result<()>) -> io::Result<()> {
    match result.and_then(|()| io::stdout().lock().flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(io::Error::new(error.kind(), format!("cannot write standard output: {error}")))
        }
        _ => Ok(()),
    }
}

/// Refuses to write to a standard output that is not there.
///
/// # Errors
/// If it is closed.
pub(crate) fn check_open() -> io::Result<()> {
    if is_closed() {
        return Err(io::Error::other("cannot write standard output: it is closed"));
    }
    Ok(())
}

/// Was the command started without standard output?
///
/// The library opens the null device in its place, and all that is written is lost without an error. It does so for
/// reading and writing, which shells do not.
#[cfg(unix)]
fn is_closed() -> bool {
    use std::fs::{self, File};
    use std::os::fd::AsFd;
    use std::os::unix::fs::MetadataExt;

    use nix::fcntl::{FcntlArg, OFlag, fcntl};

    let stdout = io::stdout();
    let is_for_both = fcntl(&stdout, FcntlArg::F_GETFL)
        .is_ok_and(|flags| OFlag::from_bits_retain(flags) & OFlag::O_ACCMODE == OFlag::O_RDWR);
    let device = || {
        let file = File::from(stdout.as_fd().try_clone_to_owned().ok()?);
        Some(file.metadata().ok()?.rdev())
    };
    is_for_both && device().is_some_and(|id| fs::metadata("/dev/null").is_ok_and(|null| null.rdev() == id))
}

#[cfg(not(unix))]
fn is_closed() -> bool {
    false
}

/// A line on standard error.
pub(crate) fn note(text: &str) {
    let _ = writeln!(io::stderr().lock(), "{}", printable(text));
}

/// An error message.
pub(crate) fn error(text: &str) {
    note(&format!("error: {text}"));
}

/// A hint after an error message.
pub(crate) fn hint(text: &str) {
    note(&format!("hint: {text}"));
}

/// Text that is drawn already, escape sequences and all, on standard error.
pub(crate) fn drawn(text: &str) {
    let _ = writeln!(io::stderr().lock(), "{text}");
}

/// Do people see standard error?
pub(crate) fn errors_are_seen() -> bool {
    io::stderr().is_terminal()
}

/// May standard error be coloured?
pub(crate) fn errors_have_color() -> bool {
    let set = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    let draws_colors = set("TERM") && std::env::var_os("TERM").is_some_and(|term| term != "dumb");
    errors_are_seen() && !set("NO_COLOR") && draws_colors
}

/// Names in files may hold control characters, which must not reach a terminal.
fn printable(text: &str) -> String {
    text.chars().map(|c| if c.is_control() && c != '\n' { '\u{fffd}' } else { c }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn escape_sequences_of_files_do_not_reach_the_terminal() {
        assert_eq!(printable("a\u{1b}[31mb\nc"), "a\u{fffd}[31mb\nc");
    }
}
