//! The camera as other programs want it: three axes and the window that rays go through.

use brt_geometry::Vec3;
use brt_scene::{Projection, Scene};

/// Picture size of a scene that names none; the command `brt render` has the same.
const DEFAULT_SIZE: [u32; 2] = [1024, 1024];

/// A camera for a picture of known size.
pub(crate) struct View {
    /// Width and height in pixels.
    pub(crate) size: [u32; 2],
    pub(crate) eye: Vec3,
    /// Unit vectors, `right = forward × up`.
    pub(crate) forward: Vec3,
    pub(crate) right: Vec3,
    pub(crate) up: Vec3,
    /// Half the width and height of the window, at distance 1 if rays leave the eye.
    pub(crate) half_extent: [f64; 2],
    pub(crate) is_perspective: bool,
}

impl View {
    /// The view of a scene that passed its check.
    pub(crate) fn of(scene: &Scene) -> Self {
        let camera = &scene.camera;
        let size = scene.size.unwrap_or(DEFAULT_SIZE);
        let forward = (camera.look_at - camera.eye).try_normalize().unwrap_or_default();
        let right = forward.cross(camera.up.try_normalize().unwrap_or_default()).normalize();
        let (is_perspective, half_side) = match camera.projection {
            Projection::Perspective { fov_deg } => (true, libm::tan(0.5 * fov_deg.to_radians())),
            Projection::Orthographic { extent } => (false, 0.5 * extent),
        };
        let shorter = f64::from(size[0].min(size[1]));
        let half_extent = size.map(|side| half_side * f64::from(side) / shorter);
        Self { size, eye: camera.eye, forward, right, up: right.cross(forward), half_extent, is_perspective }
    }
}
