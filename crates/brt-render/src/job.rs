//! What all tiles of a window have in common.

use brt_image::Transfer;

use crate::perspective::Outlines;
use crate::picture::Crop;
use crate::prepare::PreparedCamera;
use crate::products::{PreparedScene, SampleGrid};
use crate::settings::Settings;
use crate::tracing::BoundingSpheres;

/// Everything that the tiles of a window have in common.
pub(crate) struct Job<'a> {
    pub(crate) scene: &'a PreparedScene,
    pub(crate) camera: &'a PreparedCamera,
    pub(crate) grid: &'a SampleGrid,
    /// Where the window lies in the grid.
    pub(crate) crop: Crop,
    pub(crate) settings: &'a Settings,
    pub(crate) max_depth: u32,
    /// How the sink stores colours.
    pub(crate) transfer: Transfer,
    /// Only if a perspective image is made.
    pub(crate) outlines: Option<Outlines>,
    /// Only for methods that look for what a bundle of rays may meet.
    pub(crate) spheres: Option<BoundingSpheres>,
}
