//! Lights. None falls off with distance (Whitted 1980).

use brt_geometry::Vec3;
use brt_image::Rgb;

/// A source of light without extent.
#[derive(Clone, Debug, PartialEq)]
pub enum Light {
    /// A point that shines in all directions.
    Point {
        /// Where it stands.
        position: Vec3,
        /// Colour and intensity, linear RGB.
        color: Rgb,
    },
    /// A light infinitely far away.
    Directional {
        /// Direction in which the light travels; any length but 0.
        direction: Vec3,
        /// Colour and intensity, linear RGB.
        color: Rgb,
    },
}
