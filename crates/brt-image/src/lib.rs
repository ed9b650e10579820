//! Pictures: colours, transfer functions, encoders and decoders, and measures of difference.
//!
//! The crate renders nothing and knows no scene. It promises: the same pixels give the same
//! file on every machine; encoders hold O(width) memory; a file appears only when complete;
//! no file that is read can cause a panic or more memory than the limits allow.
//!
//! ```
//! use brt_image::*;
//! let folder = tempfile::tempdir()?;
//! let path = folder.path().join("grey.png");
//! let size = PictureSize::new(4, 2);
//! let mut writer = encoder(Target::File(path.clone()).open()?, size, Encoding::default())?;
//! writer.write(&[[0.5; 3]; 4])?; // the first row, linear
//! writer.write(&[[0.5; 3]; 4])?;
//! writer.finish()?;
//! let picture = read_picture(&path, PictureLimits::default())?;
//! assert_eq!(picture.levels(0), [188.0; 3]); // sRGB
//! assert_eq!(compare(&picture, &picture)?.max_error, 0.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod codec;
mod color;
mod compare;
mod false_color;
mod image;
mod metrics;
mod picture;
mod pixels;
mod transfer;

pub use codec::{
    AbortHandle, BandWriter, BitDepth, Channels, Compression, DecodeError, DecodeProblem, EncodeError,
    Encoding, ExrEncoder, ExrLayers, FileSet, PictureFormat, PictureLimits, Place, PlainSink, Sink, Target,
    WorkClock, decode_picture, encoder, read_picture,
};
pub use color::{Rgb, rgb};
pub use compare::{SizeMismatch, compare, heat_color, heat_map, heat_rows};
pub use false_color::id_color;
pub use image::{Band, Image, PictureSize, PixelCountError};
pub use metrics::{Comparison, DifferenceMeter};
pub use picture::Picture;
pub use pixels::{PixelRows, straight};
pub use transfer::Transfer;
