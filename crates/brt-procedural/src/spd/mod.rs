//! The standard procedural databases of Eric Haines ("A Proposal for Standard Graphics Environments", IEEE CG&A 7(11),
//! November 1987), rebuilt from their geometry.
//!
//! Shading follows the rules of the Neutral File Format: no ambient light, n lights of intensity 1/√n, the highlight
//! as strong as the mirror, cones and cylinders without caps. Glass hides no light.

mod balls;
mod gears;
mod mount;
mod rings;
mod tetra;
mod tree;

pub(super) use balls::build as balls;
pub(super) use gears::build as gears;
pub(super) use mount::build as mount;
pub(super) use rings::build as rings;
pub(super) use tetra::build as tetra;
pub(super) use tree::build as tree;

use brt_geometry::Vec3;
use brt_image::rgb;
use brt_scene::{Camera, Light, Material, Projection, Scene, Shape};

/// An empty scene with what all databases share: the sky, 45° across, 512 × 512 pixels.
fn start(eye: Vec3, look_at: Vec3, up: Vec3, lights: &[Vec3]) -> Scene {
    let projection = Projection::Perspective { fov_deg: 45.0 };
    let mut scene = Scene::new(Camera { eye, look_at, up, projection });
    scene.size = Some([512, 512]);
    scene.background = rgb(0.078, 0.361, 0.753);
    let intensity = 1.0 / libm::sqrt(lights.len() as f64);
    let color = rgb(intensity, intensity, intensity);
    scene.lights.extend(lights.iter().map(|&position| Light::Point { position, color }));
    scene
}

/// The exponent of materials without a highlight, as the files print it.
const NO_SHINE: f64 = 100_000.0;

/// A fill colour without glass: `kd` is the diffuse share, `ks` that of highlight and mirror.
fn fill(name: impl Into<String>, color: [f64; 3], kd: f64, ks: f64, shine: f64) -> Material {
    Material {
        ambient: 0.0,
        diffuse: kd,
        specular: ks,
        exponent: shine,
        reflection: ks,
        ..Material::matte(name, color_of(color))
    }
}

/// Makes a fill colour transparent.
fn glass(fill: Material, transmission: f64, index_of_refraction: f64) -> Material {
    Material { transmission, index_of_refraction, casts_shadow: false, ..fill }
}

fn color_of([r, g, b]: [f64; 3]) -> brt_image::Rgb {
    rgb(r, g, b)
}

fn polygon(outline: impl Into<Vec<Vec3>>) -> Shape {
    Shape::Polygon { outline: outline.into(), holes: Vec::new() }
}
