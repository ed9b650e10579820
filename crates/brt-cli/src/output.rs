//! All that the command says. A reader that went away is no error: there is nobody to tell.

use std::io::{self, IsTerminal, Write};

/// A line on standard output.
pub(crate) fn line(text: &str) {
    let _ = writeln!(io::stdout().lock(), "{}", printable(text));
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
    errors_are_seen() && !set("NO_COLOR") && std::env::var_os("TERM").is_none_or(|term| term != "dumb")
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
