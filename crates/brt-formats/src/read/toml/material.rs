//! The tables `[materials.NAME]`.

use brt_image::Rgb;
use brt_scene::{Axis, Checker, Highlight, Material};

use super::fields::Fields;
use super::files::Files;
use super::texture::read_texture;
use super::value::{Value, boolean, color, number, one_of};
use crate::common::Problems;

const KNOWN: &[&str] = &[
    "color",
    "ambient",
    "diffuse",
    "specular",
    "exponent",
    "highlight",
    "reflection",
    "transmission",
    "index_of_refraction",
    "casts_shadow",
    "emission",
    "opacity",
    "checker",
    "texture",
];

const HIGHLIGHTS: [(&str, Highlight); 2] = [("phong", Highlight::Phong), ("blinn", Highlight::Blinn)];
const AXES: [(&str, Axis); 3] = [("x", Axis::X), ("y", Axis::Y), ("z", Axis::Z)];

/// Reads a material; what is left out is that of [`Material::matte`].
pub(super) fn read_material(
    name: &str,
    value: &Value,
    files: &mut Files,
    problems: &mut Problems,
) -> Option<Material> {
    let matte = Material::matte(name, Rgb::WHITE);
    let mut fields = Fields::of_value(value, "the material", problems)?;
    fields.only(&[KNOWN]);
    let body = fields.required("color", color);
    let ambient = fields.or("ambient", matte.ambient, number);
    let diffuse = fields.or("diffuse", matte.diffuse, number);
    let specular = fields.or("specular", matte.specular, number);
    let exponent = fields.or("exponent", matte.exponent, number);
    let highlight = fields.or("highlight", matte.highlight, |v| one_of("highlight", v, &HIGHLIGHTS));
    let reflection = fields.or("reflection", matte.reflection, number);
    let transmission = fields.or("transmission", matte.transmission, number);
    let index_of_refraction = fields.or("index_of_refraction", matte.index_of_refraction, number);
    let casts_shadow = fields.or("casts_shadow", matte.casts_shadow, boolean);
    let emission = fields.or("emission", matte.emission, color);
    let opacity = fields.or("opacity", matte.opacity, number);
    let checker = match fields.value("checker") {
        Some(value) => read_checker(value, fields.problems).map(Some),
        None => Some(None),
    };
    let texture = match fields.value("texture") {
        Some(value) => read_texture(value, files, fields.problems).map(Some),
        None => Some(None),
    };
    Some(Material {
        texture: texture?,
        color: body?,
        checker: checker?,
        ambient: ambient?,
        diffuse: diffuse?,
        specular: specular?,
        exponent: exponent?,
        highlight: highlight?,
        reflection: reflection?,
        transmission: transmission?,
        index_of_refraction: index_of_refraction?,
        casts_shadow: casts_shadow?,
        emission: emission?,
        opacity: opacity?,
        ..matte
    })
}

fn read_checker(value: &Value, problems: &mut Problems) -> Option<Checker> {
    let mut fields = Fields::of_value(value, "the checker", problems)?;
    fields.only(&[&["color", "size", "axis"]]);
    let second = fields.required("color", color);
    let size = fields.required("size", number);
    let axis = fields.or("axis", Axis::default(), |v| one_of("axis", v, &AXES));
    Some(Checker { color: second?, size: size?, axis: axis? })
}
