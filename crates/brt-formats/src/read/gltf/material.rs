//! Metallic and rough materials as Whitted's model.
//!
//! The mapping, for base colour c, metallic m, roughness r and gloss g = 1 − r:
//!
//! * color = c; ambient = 0.1; diffuse = 0.8·(1 − 0.6·m·g): a smooth metal shows its surroundings instead of itself;
//! * specular = (0.15 + 0.45·m)·g; exponent = 2/r⁴ − 2 in 1 to 1000 (Blinn's lobe of that roughness);
//! * reflection = 0.6·m·g² + 0.04·g⁸: mirrors are metals, and anything polished a little;
//! * transmission t (KHR_materials_transmission): transmission = t, diffuse and ambient times 1 − t, no shadow where t > 0.5;
//!   refraction by KHR_materials_ior where KHR_materials_volume makes it solid, else walls are thin and refract nothing;
//! * base colour texture: the colour is multiplied with it;
//! * alpha mode OPAQUE: opacity 1, the texture's alpha ignored; BLEND: opacity = alpha, times the texture's; MASK: the
//!   texture's alpha times the material's is held against the cutoff, without a texture all is there or nothing;
//! * emission = emissive factor times KHR_materials_emissive_strength; with an emissive texture, which is ignored, none:
//!   it would be dark in most places, and the factor alone says nothing;
//! * KHR_materials_unlit: ambient = 1, nothing else.

use brt_image::rgb;
use brt_scene::{Highlight, Material, MaterialId, TextureAlpha};
use gltf::Document;
use gltf::material::AlphaMode;

use super::texture::{Textures, texcoord_set};
use crate::import::{Draft, Stop};

/// A material and the set of texture coordinates that its texture uses.
#[derive(Clone, Copy)]
pub(super) struct Surface {
    pub(super) material: MaterialId,
    pub(super) texcoords: Option<u32>,
}

/// Our materials in the file's order.
pub(super) fn read(
    document: &Document,
    textures: &mut Textures,
    draft: &mut Draft,
) -> Result<Vec<Surface>, Stop> {
    document
        .materials()
        .enumerate()
        .map(|(i, material)| {
            note_pictures(&material, i, draft);
            let mut ours = convert(&material, i);
            let info = material.pbr_metallic_roughness().base_color_texture();
            ours.texture = info.as_ref().and_then(|info| textures.read(info, i, draft));
            cover(&mut ours, &material);
            let texcoords = info.filter(|_| ours.texture.is_some()).map(|info| texcoord_set(&info));
            Ok(Surface { material: draft.add_material(ours)?, texcoords })
        })
        .collect()
}

fn note_pictures(material: &gltf::Material, i: usize, draft: &mut Draft) {
    let pbr = material.pbr_metallic_roughness();
    let pictures = [
        ("metallic-roughness", pbr.metallic_roughness_texture().is_some()),
        ("normal", material.normal_texture().is_some()),
        ("occlusion", material.occlusion_texture().is_some()),
        ("emission", material.emissive_texture().is_some()),
        ("transmission", material.transmission().is_some_and(|t| t.transmission_texture().is_some())),
    ];
    for (name, is_there) in pictures {
        if is_there {
            draft.notices.note(&format!("{name} textures ignored"), format!("material {i}"));
        }
    }
}

fn convert(material: &gltf::Material, i: usize) -> Material {
    let pbr = material.pbr_metallic_roughness();
    let name = material.name().map_or_else(|| format!("material {i}"), str::to_owned);
    let [r, g, b, _] = pbr.base_color_factor().map(|c| f64::from(c).clamp(0.0, 1.0));
    let mut ours = Material::matte(name, rgb(r, g, b));
    if material.unlit() {
        (ours.ambient, ours.diffuse) = (1.0, 0.0);
    } else {
        let metallic = f64::from(pbr.metallic_factor()).clamp(0.0, 1.0);
        shine(&mut ours, metallic, f64::from(pbr.roughness_factor()).clamp(0.0, 1.0));
        glow(&mut ours, material);
    }
    if let Some(transmission) = material.transmission() {
        let share = f64::from(transmission.transmission_factor()).clamp(0.0, 1.0);
        let is_solid = material.volume().is_some_and(|volume| volume.thickness_factor() > 0.0);
        let refraction = if is_solid { f64::from(material.ior().unwrap_or(1.5)) } else { 1.0 };
        see_through(&mut ours, share, refraction);
    }
    ours
}

/// Opacity, and what the texture's alpha is for.
fn cover(ours: &mut Material, material: &gltf::Material) {
    let alpha = f64::from(material.pbr_metallic_roughness().base_color_factor()[3]).clamp(0.0, 1.0);
    match (material.alpha_mode(), &mut ours.texture) {
        (AlphaMode::Opaque, _) => {}
        (AlphaMode::Blend, texture) => {
            ours.opacity = alpha;
            if let Some(texture) = texture {
                texture.alpha = TextureAlpha::Blend;
            }
        }
        (AlphaMode::Mask, texture) => {
            let cutoff = f64::from(material.alpha_cutoff().unwrap_or(0.5)).max(0.0);
            match texture {
                // A texture only takes away from what the factor says.
                Some(texture) if cutoff <= alpha && alpha > 0.0 => {
                    texture.alpha = TextureAlpha::Mask(cutoff / alpha);
                }
                _ => ours.opacity = if alpha < cutoff { 0.0 } else { 1.0 },
            }
        }
    }
}

fn shine(ours: &mut Material, metallic: f64, roughness: f64) {
    let gloss = 1.0 - roughness;
    ours.diffuse = 0.8 * (1.0 - 0.6 * metallic * gloss);
    ours.specular = (0.15 + 0.45 * metallic) * gloss;
    let square = roughness * roughness;
    ours.exponent = (2.0 / (square * square) - 2.0).clamp(1.0, 1000.0);
    ours.highlight = Highlight::Blinn;
    let square = gloss * gloss;
    let polish = square * square * square * square;
    ours.reflection = 0.6 * metallic * square + 0.04 * polish;
    // Shares below what a level of 255 shows cost rays for nothing.
    if ours.reflection < 1.0 / 255.0 {
        ours.reflection = 0.0;
    }
}

fn glow(ours: &mut Material, material: &gltf::Material) {
    /// Far beyond every picture's white, and far from overflow.
    const STRONGEST: f64 = 1e9;
    if material.emissive_texture().is_some() {
        return;
    }
    let strength = f64::from(material.emissive_strength().unwrap_or(1.0)).clamp(0.0, STRONGEST);
    let [r, g, b] = material.emissive_factor().map(|c| f64::from(c).clamp(0.0, 1.0) * strength);
    ours.emission = rgb(r, g, b);
}

fn see_through(ours: &mut Material, share: f64, refraction: f64) {
    if share <= 0.0 {
        return;
    }
    ours.transmission = share;
    ours.diffuse *= 1.0 - share;
    ours.ambient *= 1.0 - share;
    ours.index_of_refraction = if refraction > 0.0 { refraction.clamp(0.1, 10.0) } else { 1.0 };
    ours.casts_shadow = share <= 0.5;
}
