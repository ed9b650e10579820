//! The eye.

use brt_geometry::Vec3;

/// Where the picture is seen from. Right-handed: `right = forward × up`; the picture's rows run downwards.
#[derive(Clone, Debug, PartialEq)]
pub struct Camera {
    /// Position of the eye; for a parallel projection the centre of the plane that rays start on.
    pub eye: Vec3,
    /// A point in the middle of the picture.
    pub look_at: Vec3,
    /// A direction that points up in the picture; need not be normal to the view.
    pub up: Vec3,
    /// How rays spread.
    pub projection: Projection,
}

/// How the rays of the picture spread.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Projection {
    /// All rays leave the eye.
    Perspective {
        /// Full angle across the shorter side of the picture, in degrees, in (0, 180).
        fov_deg: f64,
    },
    /// All rays are parallel.
    Orthographic {
        /// Length of the picture's shorter side in scene units.
        extent: f64,
    },
}
