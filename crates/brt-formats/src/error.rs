//! Why a scene could not be had, by who is to blame.

use std::io;
use std::path::PathBuf;

use brt_scene::{Diagnostic, Report, Severity};
use thiserror::Error;

use crate::{Foreign, Format, LimitKind};

/// Why a scene file could not be loaded.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum LoadError {
    /// The file could not be read.
    #[error("cannot read {}", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// The file's format is not known, neither by its name nor by its content.
    #[error("{}: neither name nor content is that of a known scene format", path.display())]
    UnknownFormat {
        /// The file.
        path: PathBuf,
    },
    /// The file's format is known, but not read.
    #[error("{}: {} is not read yet: {}", path.display(), foreign.name, foreign.advice)]
    Foreign {
        /// The file.
        path: PathBuf,
        /// Its format.
        foreign: Foreign,
    },
    /// The file's format is written for other programs, but not read.
    #[error("{}: a {} can be written, but not read", path.display(), format.name())]
    OnlyWritten {
        /// The file.
        path: PathBuf,
        /// Its format.
        format: Format,
    },
    /// The file is not text in UTF-8, as its format demands.
    #[error("{}: not UTF-8 text from byte {position} on", path.display())]
    NotUtf8 {
        /// The file.
        path: PathBuf,
        /// Offset of the first byte that is not UTF-8.
        position: usize,
    },
    /// The file has errors.
    #[error("{}: {}", path.display(), first_error(report))]
    Malformed {
        /// The file.
        path: PathBuf,
        /// The errors, and warnings before them; positions are byte offsets in `text`.
        report: Report,
        /// The file's text.
        text: String,
    },
    /// The file asks for more than the [`Limits`](crate::Limits) allow.
    #[error("{}: {exceeded}", path.display())]
    LimitExceeded {
        /// The file.
        path: PathBuf,
        /// Which limit.
        exceeded: LimitExceeded,
    },
}

/// Why bytes could not be understood as a scene.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ParseError {
    /// The format is written for other programs, but not read.
    #[error("a {} can be written, but not read", .0.name())]
    OnlyWritten(Format),
    /// Not text in UTF-8, as the format demands.
    #[error("not UTF-8 text from byte {position} on")]
    NotUtf8 {
        /// Offset of the first byte that is not UTF-8.
        position: usize,
    },
    /// The text has errors; at least one is in the report.
    #[error("{}", first_error(.0))]
    Malformed(Report),
    /// The text asks for more than the [`Limits`](crate::Limits) allow.
    #[error(transparent)]
    LimitExceeded(#[from] LimitExceeded),
}

/// The format can be read, but not written.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[error("a {} can be read, but not written", .0.name())]
pub struct OnlyRead(pub Format);

/// A file asks for more than the [`Limits`](crate::Limits) allow.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[error("more than {limit} {what}")]
pub struct LimitExceeded {
    /// Which limit.
    pub what: LimitKind,
    /// Its value.
    pub limit: u64,
}

fn first_error(report: &Report) -> String {
    let is_error = |d: &&Diagnostic| d.severity == Severity::Error;
    let text = |d: &Diagnostic| match &d.expected {
        Some(expected) => format!("{}, expected {expected}", d.message),
        None => d.message.clone(),
    };
    let first = report.diagnostics.iter().find(is_error).map(text).unwrap_or_default();
    match report.diagnostics.iter().filter(is_error).count() {
        0 | 1 => first,
        n => format!("{first} (and {} more)", n - 1),
    }
}
