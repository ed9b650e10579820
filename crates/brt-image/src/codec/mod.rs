//! Picture files: encoders fed by bands of rows, and decoders of whole pictures.
//!
//! Encoders hold O(width) memory, whatever the height.

mod deflate;
mod error;
mod exr_read;
mod exr_write;
mod file_set;
mod format;
mod latch;
mod part_file;
mod place;
mod png_filter;
mod png_read;
mod png_write;
mod pnm_read;
mod pnm_write;
mod read;
mod replace;
mod rows;
mod sink;
mod target;
mod work_clock;

#[cfg(test)]
mod alpha_tests;
#[cfg(test)]
mod file_set_tests;
#[cfg(test)]
mod mutation_tests;
#[cfg(test)]
mod round_trip_tests;

pub use error::{DecodeError, DecodeProblem, EncodeError};
pub use exr_write::{ExrEncoder, ExrLayers};
pub use file_set::{AbortHandle, FileSet};
pub use format::{BandWriter, BitDepth, Channels, Compression, Encoding, PictureFormat, encoder};
pub use place::Place;
pub use read::{PictureLimits, decode_picture, read_picture};
pub use sink::{PlainSink, Sink};
pub use target::Target;
pub use work_clock::WorkClock;
