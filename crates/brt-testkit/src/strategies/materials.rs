//! Random materials.

use std::sync::Arc;

use brt_image::{Rgb, rgb};
use brt_scene::{Axis, Checker, Highlight, Material, Texels, Texture, TextureAlpha, TextureFilter, Wrap};
use proptest::prelude::*;

/// Any material: matte or shiny, chequered or not, glowing, mirror or glass, textured, sometimes not wholly there; the name is to be set by the caller.
pub fn any_material() -> impl Strategy<Value = Material> {
    let factors = (0.0..0.4, 0.0..1.0, prop_oneof![Just(0.0), 0.0..1.0]);
    let further = prop_oneof![
        3 => Just((0.0, 0.0, 1.0)),
        2 => (0.05..0.9).prop_map(|reflection| (reflection, 0.0, 1.0)),
        2 => (0.0..0.3, 0.3..1.0, prop_oneof![Just(1.0), Just(1.5), 1.0..2.0]),
    ];
    let emission = prop_oneof![4 => Just(Rgb::BLACK), 1 => any_color()];
    let opacity = prop_oneof![6 => Just(1.0), 1 => 0.0..1.0, 1 => prop::sample::select(vec![0.0, 0.5])];
    let flags = (any::<bool>(), prop::bool::weighted(0.8));
    (any_color(), (checker(), texture()), factors, exponent(), flags, further, (emission, opacity)).prop_map(
        |(
            color,
            (checker, texture),
            factors,
            exponent,
            (is_blinn, casts_shadow),
            further,
            (emission, opacity),
        )| {
            let (ambient, diffuse, specular) = factors;
            Material {
                emission,
                opacity,
                checker,
                texture,
                ambient,
                diffuse,
                specular,
                exponent,
                highlight: if is_blinn { Highlight::Blinn } else { Highlight::Phong },
                reflection: further.0,
                transmission: further.1,
                index_of_refraction: further.2,
                casts_shadow,
                ..Material::matte("", color)
            }
        },
    )
}

pub(super) fn any_color() -> impl Strategy<Value = Rgb> {
    prop::array::uniform3(0.0..1.0).prop_map(|[r, g, b]| rgb(r, g, b))
}

fn exponent() -> impl Strategy<Value = f64> {
    prop_oneof![(0_u32..200).prop_map(f64::from), 0.0..100.0]
}

fn checker() -> impl Strategy<Value = Option<Checker>> {
    let axis = prop::sample::select(vec![Axis::X, Axis::Y, Axis::Z]);
    let checker = (any_color(), 0.2..2.0, axis).prop_map(|(color, size, axis)| Checker { color, size, axis });
    prop::option::weighted(0.2, checker)
}

/// A small picture, which meshes with texture coordinates show.
fn texture() -> impl Strategy<Value = Option<Texture>> {
    let picture = (1_u32..4, 1_u32..4, prop::collection::vec(any::<[u8; 4]>(), 9));
    let wrap = prop::array::uniform2(prop::sample::select(vec![Wrap::Repeat, Wrap::Mirror, Wrap::Clamp]));
    let alpha = prop_oneof![
        2 => Just(TextureAlpha::Ignored),
        1 => Just(TextureAlpha::Blend),
        1 => (0.0..1.0).prop_map(TextureAlpha::Mask),
    ];
    let transform = prop::array::uniform2(prop::array::uniform3(-2.0..2.0));
    let texture = (picture, wrap, alpha, transform, any::<bool>()).prop_map(
        |((width, height, mut rgba), wrap, alpha, transform, is_sharp)| {
            rgba.truncate((width * height) as usize);
            let picture = Arc::new(Texels { name: "random".to_owned(), width, height, rgba });
            let filter = if is_sharp { TextureFilter::Nearest } else { TextureFilter::Linear };
            Texture { picture, transform, wrap, filter, alpha }
        },
    );
    prop::option::weighted(0.4, texture)
}
