//! What all importers of models share: the model under construction, smoothing, files beside the file, notices.

mod affine;
mod beside;
mod color;
mod crease;
mod draft;
mod geometry;
mod imported;
mod instances;
mod notices;
mod picture;
mod picture_decoder;
mod polygon;
mod weld;

pub(crate) use affine::Affine;
pub(crate) use beside::Beside;
pub(crate) use color::srgb;
pub(crate) use crease::{CREASE_DEG, Crease};
pub(crate) use draft::{Draft, Meshes, Part, Stop, fault};
pub(crate) use geometry::Geometry;
pub use imported::{Given, Imported};
pub(crate) use instances::{Graph, Instances};
pub(crate) use notices::Notices;
pub(crate) use picture::{Picture, Pictures};
pub(crate) use polygon::fan_or_cut;
pub(crate) use weld::Weld;
