//! Bundles find what single rays find, also where that is nothing but rounding.

use brt_geometry::{Vec3, vec3};
use brt_image::Rgb;
use brt_render::{Method, RayOrder, Run, Settings};
use brt_scene::{Camera, Light, Material, Projection, Scene, Shape};
use brt_testkit::{first_difference, render_at_every_level, replay_hint};

/// A scene of a glowing material, seen by this camera.
fn glowing(camera: Camera, shapes: Vec<Shape>) -> Scene {
    let mut scene = Scene::new(camera);
    let glowing = Material { ambient: 1.0, diffuse: 0.0, ..Material::matte("glowing", Rgb::WHITE) };
    let glowing = scene.add_material(glowing);
    shapes.into_iter().for_each(|shape| scene.add(shape, glowing));
    scene.lights.push(Light::Point { position: vec3(0.0, 0.0, 50.0), color: Rgb::WHITE });
    scene
}

fn assert_bundles_are_single_rays(scene: &Scene) {
    let settings = Settings { method: Method::Full, ..Settings::new([64, 64]) };
    let by = |rays| render_at_every_level(scene, &settings, &Run { rays, ..Run::default() }).colors;
    if let Some(difference) = first_difference(settings.size, &by(RayOrder::Single), &by(RayOrder::Bundled)) {
        panic!("{}", replay_hint(scene, &settings, &difference));
    }
}

/// A ball's discriminant rounds by the square of its distance: a ray beside it is said to hit. It is the outermost of its
/// bundle, whose shaft misses the ball.
#[test]
fn rays_that_hit_a_far_ball_by_rounding() {
    let camera = Camera {
        eye: vec3(0.0, 0.0, 100.0),
        look_at: Vec3::ZERO,
        up: vec3(0.0, 1.0, 0.0),
        projection: Projection::Orthographic { extent: 1.0 },
    };
    for beside in [1e-12, 1e-10, 2e-10, 4e-10, 8e-10] {
        let ball = |center, radius| Shape::Sphere { center, radius };
        let mut shapes = vec![ball(vec3(-0.3828125 + 0.001 + beside, 0.4453125, 0.0), 0.001)];
        shapes.extend((0..8).map(|i| ball(vec3(0.05 * f64::from(i), -0.3, 0.0), 0.01)));
        assert_bundles_are_single_rays(&glowing(camera.clone(), shapes));
    }
}

/// Two small far triangles that share an edge: a ray on it misses the one by rounding, and must find the other.
#[test]
fn nothing_slips_between_far_faces() {
    let look_at = vec3(-58.94208756153358, -57.40803403954008, 33.473445719298475);
    let camera = Camera {
        eye: Vec3::ZERO,
        look_at,
        up: vec3(0.0, 1.0, 0.0),
        projection: Projection::Perspective { fov_deg: 4.0 },
    };
    let shared = [
        vec3(-66.1610440171614, -62.587929130760514, 41.526282411484424),
        vec3(-66.1605106251705, -62.5886940418154, 41.52597934838601),
    ];
    let face = |outline: Vec<Vec3>| Shape::Polygon { outline, holes: Vec::new() };
    let [a, b] = shared;
    let mut shapes = vec![
        face(vec![a, b, vec3(-66.16119703383794, -62.58847234626303, 41.52521988141067)]),
        face(vec![b, a, vec3(-66.16016322847739, -62.58842957707418, 41.52693143546268)]),
    ];
    let forward = look_at.normalize();
    let right = forward.cross(vec3(0.0, 1.0, 0.0)).normalize();
    let up = right.cross(forward);
    shapes.extend((0..7).map(|i| {
        let corner = forward * 100.0 + right * (0.2 * f64::from(i));
        face(vec![corner, corner + right * 0.1, corner + up * 0.1])
    }));
    assert_bundles_are_single_rays(&glowing(camera, shapes));
}

/// Light that overflows (its colour times nothing is no number) behind a ball, beside one that dims it: what is hidden
/// stays black, and each ray is counted once.
#[test]
fn hidden_points_stay_black_beside_dimmers() {
    let eye = vec3(0.0, 6.0, 6.0);
    let projection = Projection::Perspective { fov_deg: 45.0 };
    let mut scene = Scene::new(Camera { eye, look_at: Vec3::ZERO, up: vec3(0.0, 1.0, 0.0), projection });
    let bright = Rgb::WHITE * 1e300;
    scene.lights.push(Light::Point { position: vec3(0.0, 4.0, 0.0), color: bright });
    let floor = Material { diffuse: 1e20, ambient: 0.3, ..Material::matte("floor", Rgb::WHITE) };
    let floor = scene.add_material(floor);
    let solid = scene.add_material(Material::matte("solid", Rgb::WHITE));
    let veil = scene.add_material(Material { opacity: 0.5, ..Material::matte("veil", Rgb::WHITE) });
    for (x, material) in [(-1.0, solid), (1.0, veil)] {
        scene.add(Shape::Sphere { center: vec3(x, 1.0, 0.0), radius: 0.6 }, material);
    }
    let corners = [[-9.0, -9.0], [-9.0, 9.0], [9.0, 9.0], [9.0, -9.0]];
    let outline = corners.map(|[x, z]| vec3(x, 0.0, z)).to_vec();
    scene.add(Shape::Polygon { outline, holes: Vec::new() }, floor);
    assert_bundles_are_single_rays(&scene);
    let settings = Settings { method: Method::Full, ..Settings::new([64, 64]) };
    let rays = |rays| render_at_every_level(&scene, &settings, &Run { rays, ..Run::default() }).stats.rays;
    assert_eq!(rays(RayOrder::Single), rays(RayOrder::Bundled));
}

/// Light that grazes edges behind a half-transparent face: single rays start anew behind the face, and what is known of
/// the way as a whole may differ from that by rounding. Coordinates are such that rays meet edges exactly.
#[test]
fn light_that_grazes_edges_behind_dimmers() {
    let camera = Camera {
        eye: vec3(0.0, 0.975, 0.0),
        look_at: Vec3::ZERO,
        up: vec3(0.0, 0.0, -1.0),
        projection: Projection::Orthographic { extent: 8.0 },
    };
    let mut scene = Scene::new(camera);
    scene.lights.push(Light::Point { position: vec3(0.0625, 8.0, 0.0625), color: Rgb::WHITE });
    let floor = scene.add_material(Material { ambient: 0.0, ..Material::matte("floor", Rgb::WHITE) });
    let solid = scene.add_material(Material::matte("solid", Rgb::WHITE));
    let veil = scene.add_material(Material { opacity: 0.5, ..Material::matte("veil", Rgb::WHITE) });
    let square = |x: f64, y: f64, z: f64, side: f64| Shape::Polygon {
        outline: [[0.0, 0.0], [0.0, side], [side, side], [side, 0.0]]
            .map(|[a, b]| vec3(x + a, y, z + b))
            .to_vec(),
        holes: Vec::new(),
    };
    let cells = |count: i32| (0..count * count).map(move |i| (i / count - count / 2, i % count - count / 2));
    for (x, z) in cells(16).filter(|(x, z)| (x + z) % 2 == 0) {
        scene.add(square(f64::from(x) / 32.0, 6.0, f64::from(z) / 32.0, 1.0 / 32.0), solid);
    }
    for (x, z) in cells(4) {
        scene.add(square(f64::from(x) * 4.0, 1.3, f64::from(z) * 4.0, 4.0), veil);
    }
    scene.add(square(-10.0, 0.0, -10.0, 20.0), floor);
    assert_bundles_are_single_rays(&scene);
}
