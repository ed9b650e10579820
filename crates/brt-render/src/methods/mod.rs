//! Methods: which samples of a tile are traced, and which are filled. None knows another. Paper: P2.

mod border;
mod certified;
mod full;
mod item_buffer;
mod judge;
mod pencil;
mod pixel_selected;
mod region;
mod scan_line;
mod worker;

pub(crate) use border::render_border;
pub(crate) use certified::{Tolerance, render_certified};
pub(crate) use full::{render_full, render_reference, trace_row};
pub(crate) use item_buffer::render_item_buffer;
pub(crate) use pencil::render_pencil;
pub(crate) use pixel_selected::render_pixel_selected;
pub(crate) use scan_line::render_scan_line;
pub(crate) use worker::TileWorker;
