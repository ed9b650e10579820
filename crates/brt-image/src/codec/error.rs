//! What can go wrong with picture files, divided by who can do something about it.

use std::io;
use std::path::PathBuf;

use thiserror::Error;

use crate::PictureSize;

/// Why a picture could not be written.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum EncodeError {
    /// The disk, pipe or device failed. Sinks made by `Target` name themselves in the message.
    #[error(transparent)]
    Io(#[from] io::Error),
    /// The format cannot hold a picture of this size.
    #[error("a picture of {size} cannot be written as {format}")]
    Size {
        /// The size asked for.
        size: PictureSize,
        /// Name of the format.
        format: &'static str,
    },
    /// The caller gave a band that is no number of whole rows.
    #[error("{pixels} pixels are not whole rows of {width}")]
    PartialRow {
        /// Pixels (or values of a layer) given.
        pixels: usize,
        /// Pixels in a row.
        width: u32,
    },
    /// The caller gave more or fewer rows than the picture has.
    #[error("the picture has {expected} rows, {given} were given")]
    RowCount {
        /// Height of the picture.
        expected: u32,
        /// Rows given in all.
        given: u64,
    },
    /// The format has no alpha.
    #[error("{format} cannot hold transparency; PNG and EXR can")]
    NoAlpha {
        /// Name of the format.
        format: &'static str,
    },
    /// The caller gave rows with alpha to a picture without, or none or too few to one with it.
    #[error("alpha was given for {given} of {expected} pixels")]
    AlphaCount {
        /// Values that the picture takes.
        expected: usize,
        /// Values given.
        given: usize,
    },
    /// The names or the number of extra layers do not fit.
    #[error("layers: {0}")]
    Layers(String),
    /// The encoding library refused.
    #[error("the {format} encoder failed: {message}")]
    Library {
        /// Name of the format.
        format: &'static str,
        /// What the library says.
        message: String,
    },
}

/// Why a picture file could not be read.
#[derive(Debug, Error)]
#[error("cannot read picture {}: {problem}", path.display())]
pub struct DecodeError {
    /// The file.
    pub path: PathBuf,
    /// What is wrong; the message above includes it, so it is no separate source.
    pub problem: DecodeProblem,
}

/// What is wrong with the bytes of a picture.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum DecodeProblem {
    /// The reader failed, or the file ended early.
    #[error("{0}")]
    Io(#[from] io::Error),
    /// It is neither PNG, PPM, PGM nor EXR.
    #[error("not a PNG, PPM, PGM or EXR file")]
    UnknownFormat,
    /// The file is damaged.
    #[error("damaged {format}: {message}")]
    Malformed {
        /// Name of the format.
        format: &'static str,
        /// What is wrong.
        message: String,
    },
    /// The file is sound, but of a kind not read here.
    #[error("{0} is not supported")]
    Unsupported(String),
    /// The picture is larger than the caller allows.
    #[error("{size} is more than the limit of {limit} pixels")]
    LimitExceeded {
        /// Size the file claims.
        size: PictureSize,
        /// Pixels allowed.
        limit: u64,
    },
}

impl DecodeProblem {
    /// The file is damaged in the way `message` says.
    pub(crate) fn malformed(format: &'static str, message: impl Into<String>) -> Self {
        Self::Malformed { format, message: message.into() }
    }
}
