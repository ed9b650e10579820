//! Methods: which samples of a tile are traced, and which are filled. None knows another.

mod border;
mod full;
mod judge;
mod pixel_selected;
mod region;
mod worker;

pub use border::{BorderSettings, Regions};
pub use judge::{DeviationDelta, DifferenceDelta, Judge, VarianceDelta};
pub use pixel_selected::PixelSelectedSettings;

pub(crate) use border::render_border;
pub(crate) use full::{render_full, render_reference};
pub(crate) use pixel_selected::render_pixel_selected;
pub(crate) use worker::TileWorker;
