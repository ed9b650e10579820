//! What reading and writing share: the formats, what a file may cost, what is said of it, and its words.

mod budget;
mod error;
mod foreign;
mod format;
mod limits;
mod machine;
mod problems;
mod words;

pub(crate) use budget::{Budget, Cost, Halt, Watched, counted};
pub use error::{LimitExceeded, LoadError, OnlyRead, ParseError};
pub use foreign::Foreign;
pub use format::Format;
pub use limits::Limits;
pub(crate) use problems::Problems;
pub(crate) use words::{Word, Words, counted_points, excerpt};

/// The comment of PLY files that hold a mesh of ours: its triangles as they are, colours as light, t downwards.
pub(crate) const EXACT_PLY: &str = "brt: a mesh as it is, colors are linear, t points down";
