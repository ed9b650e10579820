//! Tiny things far away, scenes far from the origin, rays that start far outside: every method and accelerator gives what the
//! oracle gives.

use brt_geometry::{Vec3, vec3};
use brt_image::rgb;
use brt_render::{Accelerator, CertifiedSettings, Method, Run, Settings};
use brt_scene::{Camera, Light, Material, MaterialId, Mesh, Scene, Shape};
use brt_testkit::{looking, render_with_layers, shifted};

const ACCELERATORS: [Accelerator; 4] =
    [Accelerator::Bvh, Accelerator::Grid, Accelerator::Extents, Accelerator::None];

/// How many pixels differ.
fn differing(a: &[[f32; 3]], b: &[[f32; 3]]) -> usize {
    a.iter().zip(b).filter(|(a, b)| a != b).count()
}

fn colors(scene: &Scene, method: Method, accelerator: Accelerator) -> Vec<[f32; 3]> {
    let settings = Settings { method, accelerator, ..Settings::new([90, 90]) };
    render_with_layers(scene, &settings, &Run::default()).colors
}

/// The oracle's picture, after all others gave the same.
fn agreed(scene: &Scene, what: &str) -> Vec<[f32; 3]> {
    assert_eq!(scene.check(), [], "{what}");
    let expected = colors(scene, Method::Reference, Accelerator::None);
    let exact = Method::Certified(CertifiedSettings { tolerance: 0.0 });
    for method in [Method::Full, exact] {
        for accelerator in ACCELERATORS {
            let lost = differing(&colors(scene, method, accelerator), &expected);
            assert_eq!(lost, 0, "{what}: {lost} pixels by {method:?}, {accelerator:?}");
        }
    }
    expected
}

fn glowing(scene: &mut Scene) -> MaterialId {
    scene.add_material(Material { ambient: 1.0, diffuse: 0.0, ..Material::matte("glow", rgb(1.0, 1.0, 1.0)) })
}

/// How many pixels are white.
fn white(colors: &[[f32; 3]]) -> usize {
    colors.iter().filter(|c| c[0] > 0.5).count()
}

#[test]
fn balls_a_million_scene_sizes_away_keep_their_rims() {
    let mut scene = Scene::new(looking([1e6, 0.45, 0.45], [0.0, 0.45, 0.45], 0.000_1));
    let material = glowing(&mut scene);
    for i in 0..64 {
        let center = vec3(f64::from(i % 4), f64::from(i / 4 % 4), f64::from(i / 16)) * 0.3;
        scene.add(Shape::Sphere { center, radius: 0.05 }, material);
    }
    agreed(&scene, "64 balls");
}

/// A field of view that shows a disc of this radius at this distance over about the middle half of the picture.
fn field_around(radius: f64, distance: f64) -> f64 {
    (4.0 * radius / distance).to_degrees()
}

#[test]
fn round_things_a_billion_radii_away_have_their_size() {
    for distance in [1e2, 1e5] {
        for share in [1e-5, 1e-7, 1e-9] {
            let r = distance * share;
            let along = vec3(0.0, 3.0 * r, 0.0);
            let shapes = [
                Shape::Sphere { center: Vec3::ZERO, radius: r },
                Shape::Cylinder { base: -along, top: along, radius: r, capped: false },
                Shape::Cone {
                    base: -along,
                    base_radius: 2.0 * r,
                    top: along,
                    top_radius: 0.0,
                    capped: false,
                },
            ];
            for (shape, expected) in shapes.into_iter().zip([0.196, 0.5, 0.5]) {
                let what = format!("{} of {r:e} at {distance:e}", shape.kind());
                let eye = [distance * 0.6, 0.0, distance * 0.8];
                let mut scene = Scene::new(looking(eye, [0.0; 3], field_around(r, distance)));
                let material = glowing(&mut scene);
                scene.add(shape, material);
                // Others far from it, so that the tree is not tiny either.
                for i in 0..5 {
                    let center = vec3(-1.0, f64::from(i) - 2.0, -3.0) * (0.1 * distance);
                    scene.add(Shape::Sphere { center, radius: r }, material);
                }
                let seen = white(&agreed(&scene, &what)) as f64 / 8100.0;
                // Of π/16, ½ and ½ of the picture: more or less a row of pixels on either side. At 1e-9 a pixel is a
                // hundred roundings wide.
                assert!((seen - expected).abs() < 0.06, "{what} covers {seen} of the picture");
            }
        }
    }
}

/// A tiny ball before a wall, seen in a mirror or by the shadow that it throws, and nothing else that is bounded.
fn alone_with_a_tiny_ball(radius: f64, distance: f64, mirror: bool) -> Scene {
    let eye = [0.0, 0.0, distance];
    let mut scene = Scene::new(looking(eye, [0.0; 3], field_around(radius, distance)));
    let wall = Material {
        reflection: if mirror { 0.8 } else { 0.0 },
        ..Material::matte("wall", rgb(0.9, 0.9, 0.9))
    };
    let wall = scene.add_material(wall);
    scene.add(Shape::Plane { normal: vec3(0.0, 0.0, 1.0), distance: 0.0 }, wall);
    let ball = glowing(&mut scene);
    let center = if mirror { vec3(0.0, 0.0, distance + 1.0) } else { vec3(0.0, 2.0 * radius, 1.0) };
    scene.add(Shape::Sphere { center, radius }, ball);
    scene
        .lights
        .push(Light::Point { position: vec3(0.0, 2.0 * radius, 0.9 * distance), color: rgb(1.0, 1.0, 1.0) });
    scene
}

#[test]
fn a_tiny_ball_alone_is_seen_in_mirrors_and_throws_its_shadow() {
    for distance in [1e2, 1e3] {
        for share in [1e-7, 1e-8, 1e-9] {
            for mirror in [false, true] {
                let what = format!("ball of {share:e} of {distance:e}, mirror {mirror}");
                let scene = alone_with_a_tiny_ball(distance * share, distance, mirror);
                let exact = agreed(&scene, &what);
                let levels = |c: f32| f64::from(c) * 255.0;
                for accelerator in ACCELERATORS {
                    let certified = Method::Certified(CertifiedSettings::default());
                    let settings = Settings { method: certified, accelerator, ..Settings::new([90, 90]) };
                    let colors = render_with_layers(&scene, &settings, &Run::default()).colors;
                    let off = colors
                        .iter()
                        .zip(&exact)
                        .filter(|(a, b)| (0..3).any(|c| (levels(a[c]) - levels(b[c])).abs() > 1.0));
                    assert_eq!(off.count(), 0, "{what} {accelerator:?}");
                }
            }
        }
    }
}

#[test]
fn a_scene_far_from_the_origin_looks_as_it_does_there() {
    let mut scene = Scene::new(looking([4.0, 3.0, 6.0], [0.0; 3], 40.0));
    let matte = scene.add_material(Material { reflection: 0.3, ..Material::matte("m", rgb(0.8, 0.6, 0.4)) });
    for i in 0..6 {
        let center = vec3(f64::from(i) - 2.5, f64::from(i % 2), 0.25 * f64::from(i));
        scene.add(Shape::Sphere { center, radius: 0.75 }, matte);
    }
    let corners =
        [vec3(-4.0, -1.0, -4.0), vec3(-4.0, -1.0, 4.0), vec3(4.0, -1.0, 4.0), vec3(4.0, -1.0, -4.0)];
    scene.add(Shape::Polygon { outline: corners.to_vec(), holes: Vec::new() }, matte);
    scene.lights.push(Light::Point { position: vec3(5.0, 8.0, 6.0), color: rgb(1.0, 1.0, 1.0) });
    let here = agreed(&scene, "at the origin");
    for offset in [1_048_576.0, 8_589_934_592.0, 8_796_093_022_208.0] {
        let there =
            agreed(&shifted(&scene, vec3(offset, -offset, 0.5 * offset)), &format!("{offset:e} away"));
        // All coordinates are multiples of a quarter: nothing is rounded by moving them.
        assert_eq!(differing(&here, &there), 0, "{offset:e} away");
    }
}

/// Rays that are reflected by a plane at the edge of what numbers can hold start beyond single precision.
#[test]
fn rays_from_beyond_single_precision_end() {
    let mut scene = Scene::new(looking([0.0, 1.0, 5.0], [0.0, 1.0, 0.0], 60.0));
    let mirror =
        scene.add_material(Material { reflection: 0.9, ..Material::matte("mirror", rgb(0.5, 0.5, 0.5)) });
    let glass = Material {
        transmission: 0.9,
        index_of_refraction: 1.5,
        ..Material::matte("glass", rgb(0.1, 0.1, 0.1))
    };
    let glass = scene.add_material(glass);
    scene.add(Shape::Plane { normal: vec3(0.0, 0.0, 1.0), distance: -1e30 }, mirror);
    scene.add(Shape::Plane { normal: vec3(1e-6, 0.0, -1.0), distance: -9e29 }, glass);
    for i in 0..9 {
        let center = vec3(f64::from(i % 3) - 1.0, f64::from(i / 3), 0.0);
        scene.add(Shape::Sphere { center, radius: 0.2 }, mirror);
    }
    scene.lights.push(Light::Point { position: vec3(0.0, 1e29, 1e29), color: rgb(1.0, 1.0, 1.0) });
    agreed(&scene, "planes 1e30 away");
}

/// Of a polygon smaller than what coordinates round by, all corners are seen at one place.
#[test]
fn what_is_smaller_than_rounding_is_not_met_all_over_its_plane() {
    let mut scene = Scene::new(looking([0.0, 0.0, 1e6], [0.0; 3], 10.0));
    let glow = glowing(&mut scene);
    for size in [1e-9, 1e-12, 1e-20] {
        let corners = [vec3(0.0, 0.0, size), vec3(size, 0.0, 0.0), vec3(0.0, size, 0.0)];
        scene.add(Shape::Polygon { outline: corners.to_vec(), holes: Vec::new() }, glow);
    }
    for i in 0..5 {
        scene.add(Shape::Sphere { center: vec3(1e3, f64::from(i) * 1e3, 0.0), radius: 1e-3 }, glow);
    }
    assert_eq!(white(&agreed(&scene, "polygons below rounding")), 0);
}

/// A face that is too thin to be one makes an object large, and is not seen: a scene is where its primitives are.
#[test]
fn what_is_no_face_does_not_keep_a_scene_far_from_the_origin() {
    let at = vec3(9_176_146_651_508.0, -3_856_638_394_476.0, 961_599_149_478.0);
    let eye = at + vec3(1.559, -0.7207, -0.5532);
    let camera =
        Camera { eye, look_at: at + vec3(-0.348, -0.0825, 0.5231), ..looking([0.0; 3], [1.0; 3], 1.981) };
    let mut scene = Scene::new(camera);
    let light = scene.add_material(Material::matte("light", rgb(0.9, 0.9, 0.9)));
    let dark = scene.add_material(Material::matte("dark", rgb(0.1, 0.1, 0.1)));
    let mesh = |corners: &[Vec3], triangles: &[[u32; 3]]| {
        let positions = corners.iter().map(|&p| at + p).collect();
        Shape::from(Mesh { positions, triangles: triangles.to_vec(), ..Mesh::default() })
    };
    let quad = [
        vec3(0.48, -0.1206, 1.2435),
        vec3(0.48, -0.341, 0.1572),
        vec3(-0.604, -0.1094, 0.1104),
        vec3(-0.604, 0.111, 1.1967),
    ];
    scene.add(mesh(&quad, &[[0, 1, 2], [0, 2, 3]]), light);
    let far = vec3(-0.94, -6.1e12, -0.5034);
    let thin = [vec3(0.715, -0.176, 1.2273), vec3(0.715, -0.512, -0.4318), far];
    scene.add(mesh(&thin, &[[0, 1, 2]]), light);
    let outline = [
        vec3(0.203, -0.1157, 0.963),
        vec3(0.203, -0.464, -0.755),
        vec3(-1.51, -0.098, -0.8292),
        vec3(-1.51, 0.25, 0.8888),
    ];
    let outline = outline.map(|p| at + p).to_vec();
    scene.add(Shape::Polygon { outline, holes: Vec::new() }, dark);
    let with_all = agreed(&scene, "with a thin face");
    scene.objects.remove(1);
    assert_eq!(differing(&with_all, &agreed(&scene, "without")), 0);
}
