//! The perspective image of a tile.

use super::{Area, Tile};

/// Stands for "no primitive" and "no surface" where a sample sees the background.
pub(crate) const NOTHING: u32 = u32::MAX;

/// Stands for "several primitives" where an area shows more than one.
pub(crate) const MIXED: u32 = u32::MAX - 1;

/// Per sample of a tile: what its ray meets first. Made without rays. Paper: P3.
#[doc(alias = "item buffer")]
#[doc(alias = "visibility buffer")]
#[derive(Clone, Debug, Default)]
pub(crate) struct PerspectiveImage {
    /// Primitive met first, or [`NOTHING`].
    pub(crate) primitive: Vec<u32>,
    /// Its surface, or [`NOTHING`].
    pub(crate) surface: Vec<u32>,
    /// Areas that were painted at once, with the primitive that they show or [`MIXED`]. They tile the tile.
    pub(crate) areas: Vec<(Area, u32)>,
    /// Flat primitives whose edges all samples that show them are clear of, but for the doubtful ones; by id.
    pub(crate) clear: Vec<u32>,
    /// Columns and rows of samples that lie on an edge, or too near to it for what is proven of the others.
    pub(crate) doubtful: Vec<[u32; 2]>,
}

impl PerspectiveImage {
    /// Makes room for a tile; contents are old.
    pub(crate) fn reset(&mut self, tile: &Tile) {
        self.areas.clear();
        self.clear.clear();
        self.doubtful.clear();
        self.primitive.resize(tile.sample_count(), NOTHING);
        self.surface.resize(tile.sample_count(), NOTHING);
    }
}
