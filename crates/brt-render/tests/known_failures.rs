//! Failures that are known, asserted as such, so that the day they are gone is noticed.
//!
//! The first three come from rounding where a primitive is met far from where it is, or is not met where it is: the
//! plain search over all primitives believes such hits, boxes and outlines do not. No picture that is looked at shows
//! them. The others are mistakes.

use brt_geometry::vec3;
use brt_image::rgb;
use brt_render::{Accelerator, BorderSettings, HistoryKind, Layer, Method, Run, Settings};
use brt_scene::{Light, Material, Mesh, Scene, Shape};
use brt_testkit::{Rendered, looking, render_with_layers};

fn rendered(scene: &Scene, method: Method, size: [u32; 2]) -> Rendered {
    assert_eq!(scene.check(), []);
    let layers = vec![Layer::History];
    let settings = Settings { method, layers, history: HistoryKind::Lit, ..Settings::new(size) };
    render_with_layers(scene, &settings, &Run { threads: 1, ..Run::default() })
}

fn differing(a: &Rendered, b: &Rendered) -> usize {
    a.colors.iter().zip(&b.colors).filter(|(a, b)| a != b).count()
}

/// Balls seen along an axis from a million times their distance from each other: discriminants round by more than the
/// boxes' margin, and the tree's own rounding does not help across an axis.
#[test]
fn balls_a_million_scene_sizes_away_lose_their_rims_in_the_tree() {
    let mut scene = Scene::new(looking([1e6, 0.45, 0.45], [0.0, 0.45, 0.45], 0.000_1));
    let material = Material { ambient: 1.0, ..Material::matte("m", rgb(1.0, 1.0, 1.0)) };
    let material = scene.add_material(material);
    for i in 0..64 {
        let center = vec3(f64::from(i % 4), f64::from(i / 4 % 4), f64::from(i / 16)) * 0.3;
        scene.add(Shape::Sphere { center, radius: 0.05 }, material);
    }
    let size = [400, 400];
    let (full, reference) = (rendered(&scene, Method::Full, size), rendered(&scene, Method::Reference, size));
    let lost = differing(&full, &reference);
    assert!((1..2000).contains(&lost), "{lost} pixels");
}

/// The eye exactly on a corner of a triangle that is otherwise behind it: the outline says "behind", the predicate
/// finds a hit at a distance of one rounding.
#[test]
fn the_eye_on_a_corner_of_what_is_behind_it_may_see_it() {
    let mut seen_by_rays_only = 0;
    for step in 0..40 {
        let eye = vec3(0.1 * f64::from(step), 2.0e6 / 3.0, 0.7);
        let mut scene = Scene::new(looking(eye.into(), (eye + vec3(0.3, -1.0, 0.1)).into(), 40.0));
        scene.camera.up = vec3(0.0, 0.0, 1.0);
        scene.background = rgb(0.5, 0.5, 0.5);
        let dark = scene.add_material(Material::matte("m", rgb(0.0, 0.0, 0.0)));
        let positions = vec![eye, eye + vec3(0.3, 0.9, 0.2), eye + vec3(-0.4, 0.8, 0.1)];
        scene.add(Shape::Mesh(Mesh { positions, normals: Vec::new(), triangles: vec![[0, 1, 2]] }), dark);
        let full = rendered(&scene, Method::Full, [8, 8]);
        let border = Method::Border(BorderSettings { block: 1, ..BorderSettings::default() });
        seen_by_rays_only += usize::from(differing(&full, &rendered(&scene, border, [8, 8])) > 0);
    }
    assert!((1..40).contains(&seen_by_rays_only), "{seen_by_rays_only} of 40 views");
}

/// Shadow rays that run within a wall's plane: where they meet it is 0/0, and edge functions are noise.
#[test]
fn a_light_in_the_plane_of_a_wall_of_triangles_shadows_it_by_chance() {
    let mut by_chance = 0;
    for step in 0..40 {
        let angle = 0.02 + 0.037 * f64::from(step);
        let along = vec3(angle.cos(), 0.0, angle.sin());
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
    assert!((1..40).contains(&by_chance), "{by_chance} of 40 walls");
}

/// Rays along an axis with zeros of both signs: for −0 the grid takes the far side of a slab for the near one and
/// passes by. Once this fails, `Accelerator::Grid` belongs into the list of `exact_methods.rs`.
#[test]
fn the_grid_loses_the_shadow_of_a_light_along_an_axis() {
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
    assert!(lost > 0);
}

/// A plane that a directional light's rays meet beyond the end of the space that is looked at.
#[test]
fn the_scan_line_method_loses_the_shadow_of_a_plane_far_away() {
    let mut scene = Scene::new(looking([0.0, 0.0, 5.0], [0.0, 0.0, 0.0], 30.0));
    let material = scene.add_material(Material::matte("m", rgb(1.0, 1.0, 1.0)));
    scene.add(Shape::Sphere { center: vec3(0.0, 0.0, 0.0), radius: 0.8 }, material);
    // The light comes nearly along the plane, from behind it.
    scene.add(Shape::Plane { normal: vec3(0.0, 1.0, 0.0), distance: 3.0 }, material);
    scene.lights.push(Light::Directional { direction: vec3(0.0, -0.1, -1.0), color: rgb(1.0, 1.0, 1.0) });
    let size = [60, 40];
    let (full, scan_line) = (rendered(&scene, Method::Full, size), rendered(&scene, Method::ScanLine, size));
    assert!(differing(&full, &scan_line) > 0);
}
