//! Faces that coincide far from the origin, where coordinates are coarse, are moved to where they are met: whatever bounds
//! them bounds their hits.

use brt_geometry::{Vec3, vec3};
use brt_image::Rgb;
use brt_render::{Accelerator, CertifiedSettings, Method, Renderer, Run, Settings};
use brt_scene::{Camera, Light, Material, MaterialId, Mesh, Projection, Scene, Shape};
use brt_testkit::{checked, render_to_image};

/// As far away coordinates round by a billionth of the scene's size.
const FAR: f64 = 6e6;

/// Two faces this far apart coincide there.
const APART: f64 = 4e-8;

/// Seen from above, a hundred-thousandth of a unit wide.
fn scene_at(x: f64, height: f64) -> Scene {
    Scene::new(Camera {
        eye: vec3(x, height, 0.0),
        look_at: vec3(x, 0.0, 0.0),
        up: vec3(0.0, 0.0, -1.0),
        projection: Projection::Orthographic { extent: 1e-5 },
    })
}

fn add(scene: &mut Scene, corners: [Vec3; 3], normals: Vec<Vec3>, material: MaterialId) {
    let mesh = Mesh { positions: corners.to_vec(), normals, triangles: vec![[0, 1, 2]], ..Mesh::default() };
    scene.add(Shape::from(mesh), material);
}

/// How many pixels of a certified picture are farther from `full` than a level.
fn wrong_pixels(scene: &Scene) -> usize {
    let draw =
        |method| render_to_image(scene, &Settings { method, ..Settings::new([64, 64]) }, &Run::default()).0;
    let full = draw(Method::Full);
    let of = |tolerance| {
        let certified = draw(Method::Certified(CertifiedSettings { tolerance }));
        let is_wrong = |(a, b): &(&[f32; 3], &[f32; 3])| {
            (0..3).any(|c| f64::from((a[c] - b[c]).abs()) * 255.0 > tolerance)
        };
        certified.iter().zip(&full).filter(is_wrong).count()
    };
    of(1.0) + of(0.0)
}

/// A small face below the plane that it gets, with another face through the gap, and the eye right above: what may be seen
/// nearer than the other was told by where the small one had been.
fn faces_before_an_eye(x: f64) -> Scene {
    let mut scene = scene_at(x, 0.005);
    scene.lights.push(Light::Directional { direction: vec3(0.0, -1.0, 0.0), color: Rgb::WHITE });
    let white = scene.add_material(Material { ambient: 0.5, ..Material::matte("white", Rgb::WHITE) });
    let black =
        scene.add_material(Material { ambient: 0.1, diffuse: 0.0, ..Material::matte("black", Rgb::WHITE) });
    let large = [vec3(x - 2.0, APART, -2.0), vec3(x - 2.0, APART, 2.0), vec3(x - 1.0, APART, 0.0)];
    add(&mut scene, large, Vec::new(), white);
    add(
        &mut scene,
        [vec3(x, 0.0, -0.002), vec3(x - 0.002, 0.0, 0.0), vec3(x, 0.0, 0.002)],
        Vec::new(),
        white,
    );
    let height = |s: f64| 0.7 * APART - 1e-3 * s;
    let tilted = [
        vec3(x - 1.5, height(-1.5), -1.5),
        vec3(x - 1.5, height(-1.5), 1.5),
        vec3(x + 1.5, height(1.5), 0.0),
    ];
    add(&mut scene, tilted, Vec::new(), black);
    scene
}

/// A smooth face above the plane that it gets, with another one falling away from its edge: light that grazes both was
/// proven to pass by where the smooth one had been.
fn a_sheet_over_its_plane(x: f64) -> Scene {
    let mut scene = scene_at(x, 3.0);
    scene.lights.push(Light::Directional { direction: vec3(-1.0, -0.03, 0.0), color: Rgb::WHITE * 20.0 });
    let matte = |name: &str| Material { ambient: 0.0, ..Material::matte(name, Rgb::WHITE) };
    let ghost = scene.add_material(Material { casts_shadow: false, ..matte("ghost") });
    let solid = scene.add_material(matte("solid"));
    let large = [vec3(x - 2.0, 0.0, -2.0), vec3(x - 2.0, 0.0, 2.0), vec3(x - 1.0, 0.0, 0.0)];
    add(&mut scene, large, Vec::new(), solid);
    let smooth = [vec3(x, APART, -0.5), vec3(x - 0.5, APART, 0.0), vec3(x, APART, 0.5)];
    add(&mut scene, smooth, vec![vec3(0.0, 1.0, 0.0); 3], ghost);
    let falling = [vec3(x, APART, -0.5), vec3(x, APART, 0.5), vec3(x + 0.5, APART - 0.0005, 0.0)];
    add(&mut scene, falling, Vec::new(), solid);
    scene
}

#[test]
fn a_face_before_the_eye_is_seen_where_its_carrier_is() {
    for x in [0.0, FAR] {
        assert_eq!(wrong_pixels(&faces_before_an_eye(x)), 0, "at {x}");
    }
}

#[test]
fn light_reaches_a_sheet_where_its_carrier_is() {
    for x in [0.0, FAR] {
        assert_eq!(wrong_pixels(&a_sheet_over_its_plane(x)), 0, "at {x}");
    }
}

#[test]
fn round_things_that_are_apart_stay_two_wherever_they_are() {
    for x in [0.0, 1e13] {
        let mut scene = scene_at(x, 3.0);
        let white = scene.add_material(Material::matte("white", Rgb::WHITE));
        for side in [-0.03125, 0.03125] {
            let center = vec3(x + side, 0.0, 0.0);
            scene.add(Shape::Sphere { center, radius: 0.03 }, white);
            let top = center + vec3(0.0, 1.0, 0.0);
            scene.add(Shape::Cylinder { base: center, top, radius: 0.01, capped: false }, white);
        }
        let renderer = Renderer::new(checked(&scene));
        let prepared = renderer.prepared(Accelerator::Bvh, &Run::default()).unwrap();
        assert_eq!(prepared.primitive_count(), 4, "at {x}");
    }
}
