//! What an importer has to say about a file: data with positions, drawn by whoever shows it.

use std::ops::Range;

/// How bad it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// The scene was read, but something in the file was left out or replaced.
    Warning,
    /// The file cannot be used.
    Error,
}

/// One thing to say.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// How bad it is.
    pub severity: Severity,
    /// What is wrong, in a sentence without a full stop.
    pub message: String,
    /// The place in the file, in bytes; `None` where it is about the whole file.
    pub span: Option<Range<usize>>,
    /// What was expected, for the mark under the place.
    pub expected: Option<String>,
}

impl Diagnostic {
    /// An error at a place of the file.
    pub fn error(message: impl Into<String>, span: Option<Range<usize>>) -> Self {
        Self { severity: Severity::Error, message: message.into(), span, expected: None }
    }

    /// A warning at a place of the file.
    pub fn warning(message: impl Into<String>, span: Option<Range<usize>>) -> Self {
        Self { severity: Severity::Warning, message: message.into(), span, expected: None }
    }

    /// The same, saying what was expected.
    #[must_use]
    pub fn expecting(mut self, expected: impl Into<String>) -> Self {
        self.expected = Some(expected.into());
        self
    }
}

/// Everything an importer has to say about one file, in the file's order.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Report {
    /// Warnings and errors.
    pub diagnostics: Vec<Diagnostic>,
}

impl Report {
    /// Adds one thing to say.
    pub fn push(&mut self, diagnostic: Diagnostic) {
        self.diagnostics.push(diagnostic);
    }

    /// Is there an error among them?
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(|d| d.severity == Severity::Error)
    }
}
