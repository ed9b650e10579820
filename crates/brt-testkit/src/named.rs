//! Scenes that tests call by name.

use std::path::Path;

use brt_formats::{Limits, load};
use brt_geometry::{Vec3, vec3};
use brt_image::{Rgb, rgb};
use brt_scene::{Axis, Camera, Checker, Highlight, Light, Material, Mesh, Projection, Scene, Shape};

/// One of the seed scenes `a`, `b` and `c`.
///
/// # Panics
/// If there is no such file, or it is not fit to be rendered.
pub fn seed_scene(name: &str) -> Scene {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../scenes/seed/{name}.toml"));
    match load(&path, &Limits::default()) {
        Ok(loaded) => loaded.scene.into_inner(),
        Err(error) => panic!("{error}"),
    }
}

/// A perspective view from `eye` to `target`, upright.
pub fn looking(eye: [f64; 3], target: [f64; 3], fov_deg: f64) -> Camera {
    Camera {
        eye: eye.into(),
        look_at: target.into(),
        up: vec3(0.0, 1.0, 0.0),
        projection: Projection::Perspective { fov_deg },
    }
}

/// A small scene with every shape, kind of material and kind of light.
pub fn all_shapes() -> Scene {
    let mut scene = Scene::new(looking([0.5, 3.5, 9.0], [0.0, 0.6, 0.0], 42.0));
    scene.background = rgb(0.25, 0.4, 0.7);
    let towards = vec3(-1.0, -2.0, -1.5);
    scene.lights = vec![
        Light::Point { position: vec3(-4.0, 6.0, 5.0), color: rgb(0.9, 0.85, 0.8) },
        Light::Directional { direction: towards, color: rgb(0.3, 0.3, 0.35) },
    ];
    add_floor(&mut scene);
    add_round_shapes(&mut scene);
    add_polygons(&mut scene);
    add_meshes(&mut scene);
    scene
}

fn add_floor(scene: &mut Scene) {
    let checker = Checker { color: rgb(0.2, 0.25, 0.3), size: 1.25, axis: Axis::Y };
    let floor = Material { checker: Some(checker), ..Material::matte("floor", rgb(0.85, 0.8, 0.7)) };
    let floor = scene.add_material(floor);
    scene.add(Shape::Plane { normal: vec3(0.0, 2.0, 0.0), distance: 0.0 }, floor);
}

fn add_round_shapes(scene: &mut Scene) {
    let shiny = |name: &str, color| Material { specular: 0.6, ..Material::matte(name, color) };
    let mirror = scene.add_material(Material {
        reflection: 0.6,
        diffuse: 0.2,
        ..shiny("mirror", rgb(0.8, 0.85, 0.9))
    });
    let glass = scene.add_material(Material {
        transmission: 0.9,
        index_of_refraction: 1.5,
        diffuse: 0.0,
        ambient: 0.0,
        reflection: 0.1,
        casts_shadow: false,
        ..shiny("glass", Rgb::WHITE)
    });
    let blinn =
        Material { highlight: Highlight::Blinn, exponent: 22.5, ..shiny("blinn", rgb(0.9, 0.3, 0.2)) };
    let blinn = scene.add_material(blinn);
    scene.add(Shape::Sphere { center: vec3(-1.8, 1.0, -0.5), radius: 1.0 }, mirror);
    scene.add(Shape::Sphere { center: vec3(0.4, 0.7, 2.2), radius: 0.7 }, glass);
    let (base, top) = (vec3(2.3, 0.0, -1.0), vec3(2.3, 1.8, -1.0));
    scene.add(Shape::Cylinder { base, top, radius: 0.5, capped: true }, blinn);
    let (base, top) = (vec3(0.3, 0.0, -1.6), vec3(0.6, 1.9, -1.6));
    scene.add(Shape::Cone { base, base_radius: 0.7, top, top_radius: 0.0, capped: false }, blinn);
    let (base, top) = (vec3(3.1, 0.3, 1.2), vec3(2.2, 0.8, 1.5));
    scene.add(Shape::Cone { base, base_radius: 0.3, top, top_radius: 0.15, capped: true }, mirror);
    let (center, normal) = (vec3(-3.2, 1.6, 1.0), vec3(1.0, 0.2, 0.6));
    scene.add(Shape::Disc { center, normal, radius: 0.7 }, mirror);
}

fn add_polygons(scene: &mut Scene) {
    let green = scene.add_material(Material::matte("green", rgb(0.3, 0.7, 0.35)));
    let triangle = vec![vec3(-1.2, 0.0, 2.6), vec3(-0.4, 0.0, 3.0), vec3(-0.9, 1.1, 2.7)];
    scene.add(Shape::Polygon { outline: triangle, holes: Vec::new() }, green);
    let at = |x: f64, y: f64| vec3(x, y, -3.0);
    let arrow = vec![at(-3.0, 0.2), at(-1.5, 0.9), at(0.0, 0.2), at(-1.0, 3.0), at(-2.4, 2.6)];
    let hole = vec![at(-1.9, 1.4), at(-1.2, 1.4), at(-1.5, 2.1)];
    scene.add(Shape::Polygon { outline: arrow, holes: vec![hole] }, green);
    let wall = vec![at(1.0, 0.5), at(3.4, 0.5), at(3.8, 1.9), at(2.2, 2.8), at(0.9, 1.7)];
    scene.add(Shape::Polygon { outline: wall, holes: Vec::new() }, green);
}

fn add_meshes(scene: &mut Scene) {
    let yellow = Material { specular: 0.4, exponent: 40.0, ..Material::matte("yellow", rgb(0.9, 0.8, 0.3)) };
    let yellow = scene.add_material(yellow);
    let flat = octahedron(vec3(-2.6, 0.5, 2.4), 0.5);
    let mut smooth = octahedron(vec3(1.7, 0.45, 3.0), 0.45);
    smooth.normals = smooth.positions.iter().map(|&p| p - vec3(1.7, 0.45, 3.0)).collect();
    scene.add(Shape::from(flat), yellow);
    scene.add(Shape::from(smooth), yellow);
}

fn octahedron(center: Vec3, radius: f64) -> Mesh {
    let offsets = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]];
    let positions = offsets.map(|o| center + Vec3::from(o.map(f64::from)) * radius).to_vec();
    let triangles =
        vec![[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
    Mesh { positions, triangles, ..Mesh::default() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn named_scenes_are_fit_to_be_rendered_and_show_every_kind_of_shape() {
        let scene = all_shapes();
        assert_eq!(scene.check(), []);
        let kinds: std::collections::BTreeSet<&str> = scene.objects.iter().map(|o| o.shape.kind()).collect();
        assert_eq!(kinds.len(), 7, "{kinds:?}");
        assert!(["a", "b", "c"].iter().all(|name| seed_scene(name).check().is_empty()));
    }
}
