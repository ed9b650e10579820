//! The nouns that flow between the steps.

mod area;
mod block;
mod carrier;
mod certificate;
mod clearance;
mod grid;
mod history;
mod pattern;
mod perspective_image;
mod prepared;
mod stats;
mod texture;
mod tile;

pub(crate) use area::Area;
pub(crate) use block::Block;
pub(crate) use carrier::Carrier;
pub use certificate::{Certificate, CertificateCounts, Tries};
pub(crate) use clearance::slack;
pub use grid::SampleGrid;
pub use history::RayHistory;
pub(crate) use history::Step;
pub(crate) use pattern::SamplePattern;
pub(crate) use perspective_image::{MIXED, NOTHING, PerspectiveImage};
pub(crate) use prepared::{
    Beam, LIGHT_END, NO_COLORS, NO_NORMALS, NO_TEXCOORDS, PreparedChecker, PreparedLight, PreparedMaterial,
    PrimitiveInfo,
};
pub use prepared::{PreparedScene, Surface};
pub use stats::{BlockCounts, PixelCounts, RayCounts, Seconds, Stats};
pub(crate) use stats::{Counters, StageClock};
pub(crate) use texture::{PreparedTexture, TextureSample};
pub use tile::SampleState;
pub(crate) use tile::{Tile, TileSamples};
