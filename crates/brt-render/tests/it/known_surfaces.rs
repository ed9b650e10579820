//! What surfaces that glow, are partly there, or carry colours show, and lights in cones: known by algebra.

use std::sync::Arc;

use brt_geometry::{Affine, Vec3, vec3};
use brt_image::{Rgb, rgb};
use brt_render::{CertifiedSettings, Method, Run, Settings};
use brt_scene::{Light, Material, Mesh, Object, Projection, Scene, Shape};
use brt_testkit::{looking, render_at_every_level};

/// The picture by full ray tracing, after the oracle and certified ray tracing without tolerance gave the same.
fn colors(scene: &Scene, size: [u32; 2]) -> Vec<[f32; 3]> {
    assert_eq!(scene.check(), []);
    let exact = Method::Certified(CertifiedSettings { tolerance: 0.0 });
    let [full, reference, certified] = [Method::Full, Method::Reference, exact]
        .map(|method| Settings { method, ..Settings::new(size) })
        .map(|settings| render_at_every_level(scene, &settings, &Run::default()).colors);
    assert!(full == reference && full == certified);
    full
}

/// Parallel rays along -z over the square of side 2 around the origin.
fn facing_the_square() -> Scene {
    let mut scene = Scene::new(looking([0.0, 0.0, 10.0], [0.0, 0.0, 0.0], 30.0));
    scene.camera.projection = Projection::Orthographic { extent: 2.0 };
    scene
}

fn wall(z: f64) -> Shape {
    Shape::Plane { normal: vec3(0.0, 0.0, 1.0), distance: z }
}

fn black() -> Material {
    Material { ambient: 0.0, diffuse: 0.0, ..Material::matte("black", Rgb::BLACK) }
}

fn close(a: [f32; 3], b: [f64; 3]) -> bool {
    (0..3).all(|c| (f64::from(a[c]) - b[c]).abs() < 1e-6)
}

#[test]
fn emission_is_added_to_what_is_reflected() {
    let mut scene = facing_the_square();
    scene.lights.push(Light::Directional { direction: vec3(0.0, 0.0, -1.0), color: Rgb::WHITE });
    let lit = Material { emission: rgb(0.5, 0.25, 0.0), ..Material::matte("lit", rgb(0.5, 0.5, 0.5)) };
    let lit = scene.add_material(lit);
    scene.add(wall(0.0), lit);
    // ½·0.1 ambient and ½·0.8 diffuse are 0.45.
    assert!(colors(&scene, [8, 8]).iter().all(|&c| close(c, [0.95, 0.7, 0.45])));
}

#[test]
fn layers_that_are_half_there_show_halves_of_what_is_behind() {
    let mut scene = facing_the_square();
    scene.background = rgb(0.0, 0.0, 1.0);
    scene.max_depth = 0;
    let layer = |emission, opacity| Material { emission, opacity, ..black() };
    let red = scene.add_material(layer(rgb(1.0, 0.0, 0.0), 0.5));
    let green = scene.add_material(layer(rgb(0.0, 1.0, 0.0), 0.25));
    let nothing = scene.add_material(layer(Rgb::WHITE, 0.0));
    scene.add(wall(2.0), red);
    scene.add(wall(1.0), green);
    scene.add(wall(0.0), nothing);
    // ½ red; of the other half a quarter green, the rest background.
    assert!(colors(&scene, [8, 8]).iter().all(|&c| close(c, [0.5, 0.125, 0.375])));
}

#[test]
fn what_is_half_there_lets_half_the_light_through_and_a_ball_a_quarter() {
    let mut scene = Scene::new(looking([0.0, 8.0, 0.0], [0.0, 0.0, 0.0], 30.0));
    scene.camera.up = vec3(0.0, 0.0, -1.0);
    scene.camera.projection = Projection::Orthographic { extent: 0.5 };
    scene.lights.push(Light::Directional { direction: vec3(0.0, -1.0, 0.0), color: Rgb::WHITE });
    let floor = Material { ambient: 0.0, diffuse: 1.0, ..Material::matte("floor", Rgb::WHITE) };
    let floor = scene.add_material(floor);
    let veil = scene.add_material(Material { opacity: 0.5, ..black() });
    scene.add(Shape::Plane { normal: vec3(0.0, 1.0, 0.0), distance: 0.0 }, floor);
    let up = vec3(0.0, 1.0, 0.0);
    // Above the eye: seen by light only.
    let disc = Shape::Disc { center: vec3(0.0, 20.0, 0.0), normal: up, radius: 3.0 };
    let ball = Shape::Sphere { center: vec3(0.0, 30.0, 0.0), radius: 3.0 };
    for (shapes, share) in
        [(vec![], 1.0), (vec![disc.clone()], 0.5), (vec![ball.clone()], 0.25), (vec![disc, ball], 0.125)]
    {
        scene.objects.truncate(1);
        shapes.into_iter().for_each(|shape| scene.add(shape, veil));
        assert!(colors(&scene, [8, 8]).iter().all(|&c| close(c, [share; 3])), "{share}");
    }
}

#[test]
fn colours_of_points_are_interpolated_and_tint_the_material() {
    let mut scene = facing_the_square();
    let tinted = Material { ambient: 1.0, diffuse: 0.0, ..Material::matte("tinted", rgb(1.0, 0.5, 1.0)) };
    let tinted = scene.add_material(tinted);
    let mesh = Mesh {
        positions: [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
            .map(|[x, y]| vec3(x, y, 0.0))
            .to_vec(),
        colors: vec![Rgb::BLACK, rgb(1.0, 1.0, 0.0), rgb(1.0, 1.0, 1.0), rgb(0.0, 0.0, 1.0)],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        ..Mesh::default()
    };
    scene.add(mesh.into(), tinted);
    // Red and green grow with x, blue with y: linear over both triangles.
    let picture = colors(&scene, [10, 10]);
    for (i, &c) in picture.iter().enumerate() {
        let (x, y) = ((i % 10) as f64 / 10.0 + 0.05, 0.95 - (i / 10) as f64 / 10.0);
        assert!(close(c, [x, 0.5 * x, y]), "{i}: {c:?}");
    }
}

#[test]
fn objects_share_a_mesh_and_mirrored_ones_keep_their_fronts() {
    let mut scene = facing_the_square();
    let glowing = scene.add_material(Material { emission: rgb(0.5, 0.5, 0.5), ..black() });
    let points = [[0.25, -0.25], [0.75, -0.25], [0.75, 0.25], [0.25, 0.25]];
    let mesh = Arc::new(Mesh {
        positions: points.map(|[x, y]| vec3(x, y, 0.0)).to_vec(),
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        ..Mesh::default()
    });
    let mirrored =
        Affine { axes: [vec3(-1.0, 0.0, 0.0), vec3(0.0, 2.0, 0.0), vec3(0.0, 0.0, 1.0)], offset: Vec3::ZERO };
    for transform in [Affine::IDENTITY, mirrored] {
        scene.objects.push(Object { transform, ..Object::new(Shape::Mesh(mesh.clone()), glowing) });
    }
    let glows = colors(&scene, [8, 8]).iter().map(|c| c[0] > 0.0).collect::<Vec<_>>();
    for (i, &is_there) in glows.iter().enumerate() {
        // Pixels are ¼ wide: right the square of two, left that of two by four.
        let (column, row) = (i % 8, i / 8);
        let expected = match column {
            5 | 6 => (3..5).contains(&row),
            1 | 2 => (2..6).contains(&row),
            _ => false,
        };
        assert_eq!(is_there, expected, "{column}, {row}");
    }
    assert_eq!(scene.bounds(), Some([vec3(-0.75, -0.5, 0.0), vec3(0.75, 0.5, 0.0)]));
}

#[test]
fn a_spot_lights_a_disc_with_a_soft_edge() {
    let mut scene = facing_the_square();
    let matte = Material { ambient: 0.0, diffuse: 1.0, ..Material::matte("matte", Rgb::WHITE) };
    let matte = scene.add_material(matte);
    scene.add(wall(0.0), matte);
    scene.lights.push(Light::Spot {
        position: vec3(0.0, 0.0, 1.0),
        direction: vec3(0.0, 0.0, -3.0),
        color: Rgb::WHITE,
        inner_deg: 20.0,
        outer_deg: 35.0,
    });
    for (i, c) in colors(&scene, [20, 20]).iter().enumerate() {
        let (x, y) = ((i % 20) as f64 / 10.0 - 0.95, 0.95 - (i / 20) as f64 / 10.0);
        let cosine = 1.0 / (1.0 + x * x + y * y).sqrt();
        let [inner, outer] = [20.0_f64, 35.0].map(|angle| libm::cos(angle.to_radians()));
        let s = ((cosine - outer) / (inner - outer)).clamp(0.0, 1.0);
        assert!(close(*c, [cosine * s * s * (3.0 - 2.0 * s); 3]), "{i}");
    }
}
