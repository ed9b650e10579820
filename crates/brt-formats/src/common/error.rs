//! Why a scene could not be had, by who is to blame.

use std::io;
use std::path::PathBuf;

use brt_scene::{Diagnostic, Report, Severity};
use bytesize::ByteSize;
use thiserror::Error;

use super::budget::Halt;
use super::{Foreign, Format};

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
    #[error("{}: {foreign}", path.display())]
    Foreign {
        /// The file.
        path: PathBuf,
        /// Its format.
        foreign: Foreign,
    },
    /// The file's name is that of a scene, but its content is surely of another format.
    #[error("{}: the name says {}, the content {}; `--input-format {}` believes the content",
            path.display(), named.name(), content.name(), content.extensions()[0])]
    Misnamed {
        /// The file.
        path: PathBuf,
        /// The format of its name.
        named: Format,
        /// The format of its content.
        content: Format,
    },
    /// The file's format is written for other programs, but not read.
    #[error("{}: a {} can be written, but not read", path.display(), format.name())]
    OnlyWritten {
        /// The file.
        path: PathBuf,
        /// Its format.
        format: Format,
    },
    /// The file's format is one that this build leaves out.
    #[error("{}: this build reads no {}", path.display(), format.name())]
    LeftOut {
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
    /// [`Limits::cancel`](crate::Limits::cancel) became true.
    #[error("{}: reading was cancelled", path.display())]
    Cancelled {
        /// The file.
        path: PathBuf,
    },
}

/// Why bytes could not be understood as a scene.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ParseError {
    /// The format is written for other programs, but not read.
    #[error("a {} can be written, but not read", .0.name())]
    OnlyWritten(Format),
    /// The feature of this crate that reads the format is off.
    #[error("this build reads no {}", .0.name())]
    LeftOut(Format),
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
    /// [`Limits::cancel`](crate::Limits::cancel) became true.
    #[error("reading was cancelled")]
    Cancelled,
}

impl From<Halt> for ParseError {
    fn from(halt: Halt) -> Self {
        match halt {
            Halt::Limit(limit) => Self::LimitExceeded(limit),
            Halt::Cancelled => Self::Cancelled,
        }
    }
}

/// The format can be read, but not written.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[error("a {} can be read, but not written", .0.name())]
pub struct OnlyRead(pub Format);

/// A file asks for more than the [`Limits`](crate::Limits) allow. The message names the option of `brt` that allows more.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum LimitExceeded {
    /// More than [`Limits::memory`](crate::Limits::memory).
    #[error("with {what} it needs {} of memory, but {} are allowed: `--max-memory SIZE` allows more",
            size(*needed), size(*allowed))]
    Memory {
        /// What there is too much of, with its number.
        what: String,
        /// Bytes that everything up to it takes, at least.
        needed: u64,
        /// Bytes that are allowed.
        allowed: u64,
    },
    /// A multiple of what was read, which [`Limits::any_expansion`](crate::Limits::any_expansion) would allow.
    #[error("with {what} it needs {} of memory, but only {} were read: `--allow-expansion` lets that pass",
            size(*needed), size(*read))]
    Expansion {
        /// What there is too much of, with its number.
        what: String,
        /// Bytes that everything up to it takes.
        needed: u64,
        /// Bytes of all files that were read.
        read: u64,
    },
    /// A packed part unpacks to a multiple of its size, which
    /// [`Limits::any_expansion`](crate::Limits::any_expansion) would allow.
    #[error("`{name}` unpacks to more than {times} times its {}: `--allow-expansion` lets that pass", size(*packed))]
    Unpacking {
        /// Name of the part.
        name: String,
        /// Its bytes.
        packed: u64,
        /// How many times more may be in it.
        times: u64,
    },
    /// A file, or a part of one, is larger than an eighth of [`Limits::memory`](crate::Limits::memory).
    #[error("{} is too much for one file, which may have {}, an eighth of the memory that is allowed: `--max-memory SIZE` \
             allows more", size(*bytes), size(*allowed))]
    File {
        /// Bytes of the file, as far as it was looked at.
        bytes: u64,
        /// Bytes that are allowed.
        allowed: u64,
    },
    /// More than [`Limits::max_picture_pixels`](crate::Limits::max_picture_pixels).
    #[error("a picture of {pixels} pixels, but {allowed} are allowed: `--max-pixels N` allows more")]
    PicturePixels {
        /// Pixels that the file asks for.
        pixels: u64,
        /// Pixels that are allowed.
        allowed: u64,
    },
    /// The machine has no more.
    #[error("there is no memory for {what}, {}", size(*needed))]
    Machine {
        /// What there is no room for.
        what: String,
        /// Bytes that it takes.
        needed: u64,
    },
}

fn size(bytes: u64) -> String {
    if bytes == u64::MAX { "16 EiB or more".to_owned() } else { ByteSize(bytes).to_string() }
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
