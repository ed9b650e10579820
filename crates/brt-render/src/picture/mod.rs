//! From samples to pixels, and from tiles to rows that stream out.

mod band;
mod crop;
mod filter;
mod layers;
mod mean;
mod paint;
mod sink;

pub(crate) use band::{BandAssembler, FullTile, TilePicture};
pub(crate) use crop::Crop;
pub(crate) use filter::{TileShares, reduce, reduce_alpha, reduce_into};
pub use layers::LayerRows;
pub(crate) use layers::{LayerSources, tile_layer};
pub use paint::LayerPainter;
pub use sink::{KeptRows, Rows, Sink};
