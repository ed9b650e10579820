//! Metallic and rough materials as Whitted's model.
//!
//! The mapping, for base colour c, metallic m, roughness r and gloss g = 1 − r:
//!
//! * color = c; ambient = 0.1; diffuse = 0.8·(1 − 0.6·m·g): a smooth metal shows its surroundings instead of itself;
//! * specular = (0.15 + 0.45·m)·g; exponent = 2/r⁴ − 2 in 1 to 1000 (Blinn's lobe of that roughness);
//! * reflection = 0.6·m·g² + 0.04·g⁸: mirrors are metals, and anything polished a little;
//! * transmission t (KHR_materials_transmission): transmission = t, diffuse and ambient times 1 − t, refraction by
//!   KHR_materials_ior, no shadow where t > 0.5;
//! * alpha mode BLEND, alpha a: transmission = 1 − a without refraction, diffuse and ambient times a. Under MASK the
//!   whole material is there or not;
//! * emission e: added to the ambient share, as far as the colour allows: ambient = 0.1 + greatest channel of e, and the
//!   colour is e's where that is brighter;
//! * KHR_materials_unlit: ambient = 1, nothing else.

use brt_image::{Rgb, rgb};
use brt_scene::{Highlight, Material, MaterialId};
use gltf::Document;
use gltf::material::AlphaMode;

use crate::import::Draft;

/// Our materials in the file's order.
pub(super) fn read(document: &Document, draft: &mut Draft) -> Vec<MaterialId> {
    document
        .materials()
        .enumerate()
        .map(|(i, material)| {
            note_pictures(&material, i, draft);
            let ours = convert(&material, i);
            draft.scene.add_material(ours)
        })
        .collect()
}

fn note_pictures(material: &gltf::Material, i: usize, draft: &mut Draft) {
    let pbr = material.pbr_metallic_roughness();
    let pictures = [
        ("base colour", pbr.base_color_texture().is_some()),
        ("metallic-roughness", pbr.metallic_roughness_texture().is_some()),
        ("normal", material.normal_texture().is_some()),
        ("occlusion", material.occlusion_texture().is_some()),
        ("emission", material.emissive_texture().is_some()),
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
    let [r, g, b, alpha] = pbr.base_color_factor().map(|c| f64::from(c).clamp(0.0, 1.0));
    let mut ours = Material::matte(name, rgb(r, g, b));
    if material.unlit() {
        (ours.ambient, ours.diffuse) = (1.0, 0.0);
    } else {
        let metallic = f64::from(pbr.metallic_factor()).clamp(0.0, 1.0);
        shine(&mut ours, metallic, f64::from(pbr.roughness_factor()).clamp(0.0, 1.0));
        glow(&mut ours, material);
    }
    let (transmission, refraction) = match material.transmission() {
        Some(t) => {
            (f64::from(t.transmission_factor()).clamp(0.0, 1.0), f64::from(material.ior().unwrap_or(1.5)))
        }
        None => (0.0, 1.0),
    };
    if transmission > 0.0 {
        see_through(&mut ours, transmission, refraction);
    } else {
        match material.alpha_mode() {
            AlphaMode::Opaque => {}
            AlphaMode::Mask => {
                let cutoff = f64::from(material.alpha_cutoff().unwrap_or(0.5));
                see_through(&mut ours, if alpha < cutoff { 1.0 } else { 0.0 }, 1.0);
            }
            AlphaMode::Blend => see_through(&mut ours, 1.0 - alpha, 1.0),
        }
    }
    ours
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
    let strength = f64::from(material.emissive_strength().unwrap_or(1.0)).clamp(0.0, 1.0);
    let [r, g, b] = material.emissive_factor().map(|c| f64::from(c).clamp(0.0, 1.0) * strength);
    let light = r.max(g).max(b);
    // A texture that is ignored would be dark in most places: its factor alone says nothing.
    if light == 0.0 || material.emissive_texture().is_some() {
        return;
    }
    let body = ours.color.r.max(ours.color.g).max(ours.color.b);
    if light >= body {
        let scaled: Rgb = rgb(r, g, b) * (1.0 / light);
        ours.color = scaled;
    }
    ours.ambient += light;
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
