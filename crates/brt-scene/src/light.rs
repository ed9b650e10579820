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
    /// A point that shines in a cone: with full strength near its axis, not at all outside, smoothly between.
    ///
    /// With c the cosine of the angle to the axis, and s = (c - cos outer) / (cos inner - cos outer) clamped to
    /// [0, 1], the strength is s²·(3 - 2·s).
    Spot {
        /// Where it stands.
        position: Vec3,
        /// The cone's axis, away from the light; any length but 0.
        direction: Vec3,
        /// Colour and intensity, linear RGB.
        color: Rgb,
        /// Angle between the axis and where the strength begins to fall, degrees, ≥ 0, less than `outer_deg`.
        inner_deg: f64,
        /// Angle between the axis and where the light ends, degrees, above `inner_deg`, ≤ 180.
        outer_deg: f64,
    },
    /// A light infinitely far away.
    Directional {
        /// Direction in which the light travels; any length but 0.
        direction: Vec3,
        /// Colour and intensity, linear RGB.
        color: Rgb,
    },
}

impl Light {
    /// Colour and intensity, linear RGB, to change.
    pub fn color_mut(&mut self) -> &mut Rgb {
        match self {
            Self::Point { color, .. } | Self::Spot { color, .. } | Self::Directional { color, .. } => color,
        }
    }

    /// Colour and intensity, linear RGB.
    pub fn color(&self) -> Rgb {
        match self {
            Self::Point { color, .. } | Self::Spot { color, .. } | Self::Directional { color, .. } => *color,
        }
    }
}
