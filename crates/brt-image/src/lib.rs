//! Pictures: colours, transfer functions, encoders and decoders, and measures of difference.

mod color;

pub use color::{Rgb, rgb};
