//! Materials of hard scenes.

use std::sync::Arc;

use brt_image::{Rgb, rgb};
use brt_scene::{Axis, Checker, Highlight, Material, Texels, Texture, TextureAlpha, TextureFilter, Wrap};

use super::Choices;

/// Colours far apart, so that a wrong hit is a wrong colour.
const COLORS: [Rgb; 5] =
    [rgb(1.0, 0.2, 0.1), rgb(0.1, 0.9, 0.3), rgb(0.2, 0.3, 0.9), rgb(0.9, 0.9, 0.9), rgb(0.1, 0.1, 0.1)];

/// A color: mostly one of a few, at times any, also brighter than white.
pub(super) fn color(choices: &mut Choices) -> Rgb {
    if choices.one_in(4) {
        return rgb(choices.between(0.0, 2.0), choices.between(0.0, 1.0), choices.between(0.0, 1.0));
    }
    choices.pick(&COLORS)
}

/// Light of its own and nothing else: its picture shows where it is hit, and nothing more.
pub(super) fn plain(color: Rgb) -> Material {
    Material { ambient: 1.0, diffuse: 0.0, ..Material::matte("", color) }
}

/// A flat mirror's material: perfect or dim.
pub(super) fn mirror(choices: &mut Choices) -> Material {
    let reflection = choices.pick(&[1.0, 0.5, 0.9]);
    Material { reflection, diffuse: 0.0, ..Material::matte("", Rgb::BLACK) }
}

/// Any material but glass and what is partly there.
pub(super) fn opaque(choices: &mut Choices) -> Material {
    let color = color(choices);
    let matte = Material::matte("", color);
    match choices.below(5) {
        0 => plain(color),
        1 => matte,
        2 => {
            let highlight = choices.pick(&[Highlight::Phong, Highlight::Blinn]);
            let exponent = choices.pick(&[50.0, 1.0, 0.0, 2.5, 200.0]);
            Material { specular: 0.7, highlight, exponent, ..matte }
        }
        3 => Material { reflection: choices.pick(&[0.5, 0.9, 1.0]), ..matte },
        _ => {
            let axis = choices.pick(&[Axis::X, Axis::Y, Axis::Z]);
            let size = choices.magnitude(-2.0, 1.0);
            Material { checker: Some(Checker { color: self::color(choices), size, axis }), ..matte }
        }
    }
}

/// Any material.
pub(super) fn any(choices: &mut Choices) -> Material {
    let base = opaque(choices);
    match choices.below(8) {
        0 => Material {
            transmission: 0.9,
            index_of_refraction: choices.pick(&[1.5, 1.0, 0.7, 2.4]),
            casts_shadow: choices.one_in(2),
            ..base
        },
        1 => Material { opacity: choices.pick(&[0.5, 0.2, 0.0]), ..base },
        2 => Material { casts_shadow: false, ..base },
        3 => Material { texture: Some(texture(choices)), ..base },
        4 => Material { emission: color(choices), ..base },
        _ => base,
    }
}

/// A picture of two by two texels, which meshes with texture coordinates show.
fn texture(choices: &mut Choices) -> Texture {
    let rgba = vec![[255, 40, 20, 255], [20, 200, 60, 90], [40, 60, 220, 0], [230, 230, 230, 200]];
    let picture = Arc::new(Texels { name: "four".to_owned(), width: 2, height: 2, rgba });
    Texture {
        picture,
        transform: [[choices.coordinate(2.0), 0.3, 0.1], [-0.2, choices.coordinate(2.0), 0.7]],
        wrap: choices.pick(&[[Wrap::Repeat; 2], [Wrap::Mirror; 2], [Wrap::Clamp; 2]]),
        filter: choices.pick(&[TextureFilter::Linear, TextureFilter::Nearest]),
        alpha: choices.pick(&[TextureAlpha::Ignored, TextureAlpha::Blend, TextureAlpha::Mask(0.5)]),
    }
}
