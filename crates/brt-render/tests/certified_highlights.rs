//! Highlights end where a surface turns away from a light: certified pictures must not carry them on.

use brt_geometry::{Vec3, vec3};
use brt_image::{Rgb, Transfer};
use brt_render::{CertifiedSettings, CheckedPixels, Method, Run, Settings};
use brt_scene::{Light, Material, Scene, Shape};
use brt_testkit::{looking, render_with_layers};

/// How many samples differ from full ray tracing by more than a level.
fn above(scene: &Scene) -> usize {
    let settings = CertifiedSettings { tolerance: 1.0, transfer: Transfer::Linear };
    let method = Method::Certified(settings);
    let settings = Settings { method, checked: CheckedPixels::All, ..Settings::new([150, 150]) };
    let picture = render_with_layers(scene, &settings, &Run::default());
    let differs = |a: &[f32; 3], b: &[f32; 3]| (0..3).any(|c| (a[c] - b[c]).abs() > 1.0 / 255.0);
    picture.colors.iter().zip(&picture.full).filter(|(a, b)| differs(a, b)).count()
}

fn shiny() -> Material {
    Material { specular: 0.8, exponent: 1.0, ..Material::matte("shiny", Rgb::WHITE) }
}

/// A light in the plane of a face is before or behind it by rounding alone, from sample to sample.
#[test]
fn a_light_in_the_plane_of_a_face_is_left_to_rays() {
    let normal = vec3(1.0, 2.0, 3.0).normalize();
    let (along, across) = normal.tangents();
    let center = vec3(0.3, 0.2, 0.1);
    let at = |u: f64, v: f64| center + along * u + across * v;
    let eye: Vec3 = center + normal * 6.0 - along * 4.0;
    let mut scene = Scene::new(looking(eye.into(), center.into(), 40.0));
    scene.lights.push(Light::Point { position: at(5.0, 1.0), color: Rgb::WHITE });
    let material = scene.add_material(shiny());
    let outline = vec![at(-3.0, -2.0), at(3.0, -2.0), at(3.0, 2.0), at(-3.0, 2.0)];
    scene.add(Shape::Polygon { outline, holes: Vec::new() }, material);
    assert_eq!(above(&scene), 0);
}

/// Light that comes in through the open end of a tube reaches the edge of its outer side from behind.
#[test]
fn light_through_the_open_end_of_a_tube_brings_no_highlight_outside() {
    for height in [0.2, 0.6, 1.0] {
        let mut scene = Scene::new(looking([6.0, 3.0, 4.0], [0.0, 0.5, 0.0], 35.0));
        scene.lights.push(Light::Point { position: vec3(-1.3, 1.0 + height, -0.2), color: Rgb::WHITE });
        let material = scene.add_material(shiny());
        let (base, top) = (vec3(0.0, -1.0, 0.0), vec3(0.0, 1.0, 0.0));
        scene.add(Shape::Cylinder { base, top, radius: 1.5, capped: false }, material);
        assert_eq!(above(&scene), 0, "light {height} above the rim");
    }
}
