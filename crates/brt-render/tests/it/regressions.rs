//! Mistakes that random scenes found, each as the scene that shows it.

use crate::common::{differing, rendered};
use brt_geometry::vec3;
use brt_image::rgb;
use brt_render::{Accelerator, BorderSettings, CertifiedSettings, Method, Run, Settings};
use brt_scene::{Light, Material, Mesh, Scene, Shape};
use brt_testkit::{looking, render_with_layers};

/// The eye exactly on a corner of a triangle that is otherwise behind it: the predicate finds a hit at a distance of
/// one rounding, so the outline must not say "behind".
#[test]
fn the_eye_on_a_corner_of_what_is_behind_it_sees_what_rays_see() {
    let mut seen_by_rays_only = 0;
    for step in 0..40 {
        let eye = vec3(0.1 * f64::from(step), 2.0e6 / 3.0, 0.7);
        let mut scene = Scene::new(looking(eye.into(), (eye + vec3(0.3, -1.0, 0.1)).into(), 40.0));
        scene.camera.up = vec3(0.0, 0.0, 1.0);
        scene.background = rgb(0.5, 0.5, 0.5);
        let dark = scene.add_material(Material::matte("m", rgb(0.0, 0.0, 0.0)));
        let positions = vec![eye, eye + vec3(0.3, 0.9, 0.2), eye + vec3(-0.4, 0.8, 0.1)];
        scene.add(Shape::from(Mesh { positions, triangles: vec![[0, 1, 2]], ..Mesh::default() }), dark);
        let full = rendered(&scene, Method::Full, [8, 8]);
        let border = Method::Border(BorderSettings { block: 1, ..BorderSettings::default() });
        seen_by_rays_only += usize::from(differing(&full, &rendered(&scene, border, [8, 8])) > 0);
    }
    assert_eq!(seen_by_rays_only, 0, "of 40 views");
}

/// Shadow rays that run within a wall's plane: where they meet it would be 0/0 and edge functions
/// noise, so they miss.
#[test]
fn a_light_in_the_plane_of_a_wall_of_triangles_never_shadows_it() {
    let mut by_chance = 0;
    for step in 0..40 {
        let angle = 0.02 + 0.037 * f64::from(step);
        let along = vec3(libm::cos(angle), 0.0, libm::sin(angle));
        let mut scene =
            Scene::new(looking([0.0, 0.0, 0.0], (along.cross(vec3(0.0, 1.0, 0.0)) * 3.0).into(), 60.0));
        let wall = scene.add_material(Material::matte("wall", rgb(1.0, 1.0, 1.0)));
        let at = |x: f64, y: f64| along.cross(vec3(0.0, 1.0, 0.0)) * 3.0 + along * x + vec3(0.0, y, 0.0);
        let outline = vec![at(-2.0, -2.0), at(2.0, -2.0), at(2.0, 2.0), at(0.0, 0.5), at(-2.0, 2.0)];
        scene.add(Shape::Polygon { outline, holes: Vec::new() }, wall);
        let direction = vec3(0.0, -1.0, 0.0) + along * 0.3;
        scene.lights.push(Light::Directional { direction, color: rgb(1.0, 1.0, 1.0) });
        let full = rendered(&scene, Method::Full, [32, 32]);
        let mut plain = full.history.clone();
        plain.sort_unstable();
        plain.dedup();
        // Background and wall are two; a third is a wall that shadows itself.
        by_chance += usize::from(plain.len() > 2);
    }
    assert_eq!(by_chance, 0, "of 40 walls");
}

/// Rays along an axis with zeros of both signs: for −0 the far side of a slab must not be taken for the near one.
#[test]
fn the_grid_keeps_the_shadow_of_a_light_along_an_axis() {
    let mut scene = Scene::new(looking([0.5, 0.3, 5.0], [0.0, 0.0, 0.0], 40.0));
    let material = scene.add_material(Material::matte("m", rgb(1.0, 1.0, 1.0)));
    for x in [-0.4, 0.0, 0.4, 0.8] {
        scene.add(Shape::Sphere { center: vec3(x, 0.0, -0.5), radius: 0.3 }, material);
        scene.add(Shape::Sphere { center: vec3(x, 0.0, 0.5), radius: 0.2 }, material);
    }
    scene.lights.push(Light::Directional { direction: vec3(0.0, 0.0, -1.0), color: rgb(1.0, 1.0, 1.0) });
    let picture = |accelerator| {
        let settings = Settings { accelerator, ..Settings::new([60, 40]) };
        render_with_layers(&scene, &settings, &Run::default())
    };
    let lost = differing(&picture(Accelerator::Bvh), &picture(Accelerator::Grid));
    assert_eq!(lost, 0);
}

/// A plane that a directional light's rays meet beyond the end of the space that is looked at.
#[test]
fn the_scan_line_method_keeps_the_shadow_of_a_plane_far_away() {
    let mut scene = Scene::new(looking([0.0, 0.0, 5.0], [0.0, 0.0, 0.0], 30.0));
    let material = scene.add_material(Material::matte("m", rgb(1.0, 1.0, 1.0)));
    scene.add(Shape::Sphere { center: vec3(0.0, 0.0, 0.0), radius: 0.8 }, material);
    // The light comes nearly along the plane, from behind it.
    scene.add(Shape::Plane { normal: vec3(0.0, 1.0, 0.0), distance: 3.0 }, material);
    scene.lights.push(Light::Directional { direction: vec3(0.0, -0.1, -1.0), color: rgb(1.0, 1.0, 1.0) });
    let size = [60, 40];
    let (full, scan_line) = (rendered(&scene, Method::Full, size), rendered(&scene, Method::ScanLine, size));
    assert_eq!(differing(&full, &scan_line), 0);
}

/// Between two walls of perfect glass every bounce doubles the rays: at depth 1000 that is for ever.
#[test]
fn glass_between_glass_ends_in_time_and_alike_for_full_and_reference() {
    let mut scene = Scene::new(looking([0.0, 0.0, 3.0], [0.0, 0.0, 0.0], 30.0));
    scene.max_depth = 1000;
    let glass = scene.add_material(Material {
        reflection: 1.0,
        transmission: 1.0,
        index_of_refraction: 1.5,
        ..Material::matte("glass", rgb(0.1, 0.1, 0.1))
    });
    for distance in [-1.0, 0.0, 1.0] {
        scene.add(Shape::Plane { normal: vec3(0.0, 0.0, 1.0), distance }, glass);
    }
    let size = [2, 1];
    let (full, reference) = (rendered(&scene, Method::Full, size), rendered(&scene, Method::Reference, size));
    assert_eq!(differing(&full, &reference), 0);
    assert_eq!(full.stats.rays.mirror + full.stats.rays.refracted, 2 << 16);
}

/// A floor seen along itself, with corners off its plane by a rounding, and a wall at its far edge: what seems clear of the
/// edge by far is not known to be on this side of the wall.
#[test]
fn a_floor_seen_along_itself_is_not_taken_to_be_clear_of_its_edges() {
    let (base, off) = (1e4, 2.295e-7);
    let at = |x: f64, y: f64, z: f64| vec3(base + x, base + y, base + z);
    let mut scene = Scene::new(looking(at(0.0, 2e-6, -0.1).into(), at(0.0, 9e-7, 1.0).into(), 1.8336e-4));
    scene.lights.push(Light::Point { position: at(0.3, 40.0, -10.0), color: rgb(1.0, 1.0, 1.0) });
    let left = [(-1.0, off, 0.0), (-1.1, -off, 0.33), (-1.1, -off, 0.67), (-1.0, off, 1.0)];
    let right = left.iter().rev().map(|&(x, y, z)| (-x, y, z));
    let floor = left.iter().copied().chain(right).map(|(x, y, z)| at(x, y, z)).collect();
    let wall = [(-1.0, 0.03), (1.0, 0.03), (1.0, 3.0), (-1.0, 3.0)].map(|(x, y)| at(x, y, 1.0)).to_vec();
    for (name, outline) in [("floor", floor), ("wall", wall)] {
        let material = scene.add_material(Material::matte(name, rgb(0.8, 0.8, 0.8)));
        scene.add(Shape::Polygon { outline, holes: Vec::new() }, material);
    }
    let exact = CertifiedSettings { tolerance: 0.0 };
    let full = rendered(&scene, Method::Full, [64, 64]);
    assert_eq!(differing(&full, &rendered(&scene, Method::Certified(exact), [64, 64])), 0);
}

/// Cut into triangles, it has one that is 10⁻¹⁰ as wide as long, and as wide as the notch where that is seen.
#[test]
fn a_vast_floor_with_a_tiny_notch_is_whole_beside_it() {
    let mut camera = looking([0.0, 0.006, -0.0018], [0.0, 0.0, -0.0018], 30.0);
    camera.up = vec3(0.0, 0.0, 1.0);
    let mut scene = Scene::new(camera);
    let material = Material { ambient: 1.0, ..Material::matte("m", rgb(1.0, 1.0, 1.0)) };
    let material = scene.add_material(material);
    let corners = [(-1e6, -1e6), (-1e6, 1e6), (-3e-4, 0.0), (3e-4, 0.0), (1e6, 1e6), (1e6, -1e6)];
    let outline = corners.map(|(x, z)| vec3(x, 0.0, z)).to_vec();
    scene.add(Shape::Polygon { outline, holes: Vec::new() }, material);
    for method in [Method::Full, Method::Reference] {
        let picture = rendered(&scene, method, [120, 90]);
        assert!(picture.colors.iter().all(|color| *color == [1.0; 3]), "{method:?}");
    }
}
