//! Pictures: colours, transfer functions, encoders and decoders, and measures of difference.

mod color;
mod quantize;
mod transfer;

pub use color::{Rgb, rgb};
pub use transfer::Transfer;
