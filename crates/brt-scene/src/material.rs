//! How a surface answers light: Whitted's model (1980).
//!
//! Seen colour = `emission + color·ambient + Σ light·(color·diffuse·(n·l) + specular·highlight) +
//! reflection·(mirror ray) + transmission·(refracted ray)`, the sum over lights that are in front of the surface and not
//! hidden. Of that `opacity` is seen, and `1 - opacity` of what lies straight behind. Both faces of a surface are seen.
//! The mirror ray is not tinted. All factors are without unit, usually in [0, 1].

use brt_image::Rgb;

use crate::Texture;

/// A material, named by objects.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Unique name.
    pub name: String,
    /// Colour of the body, linear RGB.
    pub color: Rgb,
    /// Light of its own, linear RGB, added to all that is reflected. It lights nothing else.
    pub emission: Rgb,
    /// Share of the surface that is there, in [0, 1]: the rest shows what lies behind, in a straight line, and lets as
    /// much light through, neither tinted.
    pub opacity: f64,
    /// Second colour in a chequered pattern.
    pub checker: Option<Checker>,
    /// A picture that the colour is multiplied with.
    pub texture: Option<Texture>,
    /// Share of the colour seen without any light, ≥ 0.
    pub ambient: f64,
    /// Lambert's factor, ≥ 0.
    pub diffuse: f64,
    /// Strength of the highlight, ≥ 0; highlights have the light's colour.
    pub specular: f64,
    /// Sharpness of the highlight, ≥ 0.
    pub exponent: f64,
    /// Formula of the highlight.
    pub highlight: Highlight,
    /// Share of the mirror ray, ≥ 0.
    pub reflection: f64,
    /// Share of the refracted ray, ≥ 0; goes to the mirror ray where total reflection takes place.
    pub transmission: f64,
    /// Index of refraction of the inside (behind the normal) relative to the outside, > 0.
    pub index_of_refraction: f64,
    /// Does it hide lights from others? Glass usually should not: shadow rays are not refracted.
    pub casts_shadow: bool,
}

impl Material {
    /// A matte material: ambient 0.1, diffuse 0.8, nothing else.
    pub fn matte(name: impl Into<String>, color: Rgb) -> Self {
        Self {
            name: name.into(),
            color,
            emission: Rgb::BLACK,
            opacity: 1.0,
            checker: None,
            texture: None,
            ambient: 0.1,
            diffuse: 0.8,
            specular: 0.0,
            exponent: 50.0,
            highlight: Highlight::Phong,
            reflection: 0.0,
            transmission: 0.0,
            index_of_refraction: 1.0,
            casts_shadow: true,
        }
    }
}

/// Formula of the highlight, for unit vectors n (normal), l (to the light), v (to the viewer).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Highlight {
    /// `max(0, r·v)^exponent`, r = l mirrored at n (Phong 1975).
    #[default]
    Phong,
    /// `max(0, n·h)^exponent`, h half-way between l and v (Blinn 1977).
    Blinn,
}

/// A chequered pattern: squares in the two axes other than `axis`, the same all along it.
#[derive(Clone, Debug, PartialEq)]
pub struct Checker {
    /// Colour of every other square, linear RGB; the material's own is that of the square at the origin.
    pub color: Rgb,
    /// Side of a square in scene units, > 0.
    pub size: f64,
    /// Direction along which the pattern does not change: the normal of a flat floor.
    pub axis: Axis,
}

/// A coordinate axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Axis {
    /// (1, 0, 0)
    X,
    /// (0, 1, 0)
    #[default]
    Y,
    /// (0, 0, 1)
    Z,
}
