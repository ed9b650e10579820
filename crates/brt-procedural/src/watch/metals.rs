//! What the movement is made of.

use brt_image::{Rgb, rgb};
use brt_scene::{Highlight, Material, MaterialId, Scene};

/// The materials of the still life.
#[derive(Clone, Copy)]
pub(super) struct Metals {
    /// The blackened main plate.
    pub(super) plate: MaterialId,
    /// Polished bridges.
    pub(super) steel: MaterialId,
    /// Every other stripe on the barrel bridge.
    pub(super) stripe: MaterialId,
    /// Bevels of bridges: brighter mirrors.
    pub(super) edge: MaterialId,
    /// Wheels.
    pub(super) brass: MaterialId,
    /// Settings, rims, balance.
    pub(super) gold: MaterialId,
    /// Pinions and arbors.
    pub(super) arbor: MaterialId,
    /// Screws and the hairspring, tempered blue.
    pub(super) blued: MaterialId,
    /// Night sky.
    pub(super) sky: MaterialId,
    /// Jewels.
    pub(super) ruby: MaterialId,
    /// The lens.
    pub(super) glass: MaterialId,
    /// The mirror on which everything lies.
    pub(super) table: MaterialId,
    /// The backdrop.
    pub(super) backdrop: MaterialId,
}

struct Look {
    diffuse: f64,
    specular: f64,
    exponent: f64,
    reflection: f64,
}

fn material(name: &str, color: Rgb, look: &Look) -> Material {
    Material {
        ambient: 0.05,
        diffuse: look.diffuse,
        specular: look.specular,
        exponent: look.exponent,
        highlight: Highlight::Blinn,
        reflection: look.reflection,
        ..Material::matte(name, color)
    }
}

impl Metals {
    pub(super) fn add_to(scene: &mut Scene) -> Self {
        let mut add = |name: &str, color: Rgb, [diffuse, specular, exponent, reflection]: [f64; 4]| {
            scene.add_material(material(name, color, &Look { diffuse, specular, exponent, reflection }))
        };
        let plate = add("blackened plate", rgb(0.05, 0.055, 0.07), [0.7, 0.25, 60.0, 0.12]);
        let steel = add("steel", rgb(0.46, 0.47, 0.5), [0.38, 0.5, 60.0, 0.5]);
        let stripe = add("striped steel", rgb(0.26, 0.27, 0.3), [0.4, 0.5, 30.0, 0.36]);
        let edge = add("polished bevel", rgb(0.75, 0.78, 0.82), [0.35, 0.9, 40.0, 0.5]);
        let brass = add("brass", rgb(0.78, 0.46, 0.12), [0.6, 0.5, 70.0, 0.25]);
        let gold = add("gold", rgb(0.92, 0.56, 0.16), [0.55, 0.8, 90.0, 0.3]);
        let arbor = add("pinion steel", rgb(0.5, 0.52, 0.56), [0.35, 0.9, 120.0, 0.45]);
        let blued = add("blued steel", rgb(0.02, 0.07, 0.34), [0.7, 0.9, 110.0, 0.3]);
        let sky = add("night sky", rgb(0.01, 0.03, 0.16), [0.8, 0.8, 150.0, 0.16]);
        let ruby = add("ruby", rgb(0.75, 0.015, 0.07), [0.65, 1.0, 250.0, 0.14]);
        let table = add("dark mirror", rgb(0.01, 0.014, 0.03), [0.4, 0.0, 50.0, 0.5]);
        let backdrop = add("backdrop", rgb(0.008, 0.016, 0.05), [0.6, 0.75, 16.0, 0.0]);
        let glass = scene.add_material(Material {
            transmission: 0.88,
            index_of_refraction: 1.45,
            casts_shadow: false,
            ..material(
                "lens",
                Rgb::WHITE,
                &Look { diffuse: 0.0, specular: 0.8, exponent: 300.0, reflection: 0.08 },
            )
        });
        Self { plate, steel, stripe, edge, brass, gold, arbor, blued, sky, ruby, glass, table, backdrop }
    }
}
