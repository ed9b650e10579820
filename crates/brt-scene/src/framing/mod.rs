//! A camera, lights and a floor for scenes that bring none: model files say what is there, not how to look at it.
//!
//! Everything here follows from the scene alone, so the same file always gives the same picture.

mod camera;
mod floor;
mod lights;
mod support;
mod view;

pub use camera::framed_camera;
pub use floor::add_floor;
pub use lights::studio_lights;
pub use view::{Up, View};

/// How a scene is put into the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Framing {
    /// From where.
    pub view: View,
    /// Which direction of the scene points up.
    pub up: Up,
    /// Enlargement, > 0; at 1 everything is in the picture, with a small margin.
    pub zoom: f64,
    /// Are the camera's rays parallel?
    pub parallel: bool,
    /// Width and height of the picture, of which only the ratio counts.
    pub size: [u32; 2],
}

impl Framing {
    /// An isometric view of everything in a square picture.
    pub fn new(up: Up) -> Self {
        Self { view: View::Iso, up, zoom: 1.0, parallel: false, size: [1, 1] }
    }
}
