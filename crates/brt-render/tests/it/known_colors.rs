//! Scenes whose colours are known by algebra.

use std::f64::consts::PI;

use brt_geometry::{Vec3, vec3};
use brt_image::{Rgb, rgb};
use brt_render::{BorderSettings, Layer, Method, Run, Settings};
use brt_scene::{Camera, Light, Material, Projection, Scene, Shape};
use brt_testkit::{all_shapes, looking, render_at_every_level, render_with_layers};

const METHODS: [Method; 2] = [Method::Reference, Method::Full];

fn colors(scene: &Scene, settings: &Settings) -> Vec<[f32; 3]> {
    assert_eq!(scene.check(), []);
    render_at_every_level(scene, settings, &Run::default()).colors
}

/// Shines by itself in this colour and shows nothing else.
fn glowing(color: Rgb) -> Material {
    Material { ambient: 1.0, diffuse: 0.0, ..Material::matte("glowing", color) }
}

fn ball(center: Vec3, radius: f64) -> Shape {
    Shape::Sphere { center, radius }
}

#[test]
fn inside_a_glowing_ball_every_pixel_is_its_colour() {
    let mut scene = Scene::new(looking([0.3, 0.1, 0.2], [5.0, 1.0, 1.0], 140.0));
    let material = scene.add_material(glowing(rgb(0.3, 0.6, 0.9)));
    scene.add(ball(Vec3::ZERO, 2.0), material);
    for method in METHODS {
        let picture = colors(&scene, &Settings { method, ..Settings::new([40, 30]) });
        assert!(picture.iter().all(|c| *c == [0.3, 0.6, 0.9]), "{method:?}");
    }
}

#[test]
fn in_a_furnace_of_mirrors_that_lose_half_light_is_a_geometric_sum() {
    // Each bounce inside the ball adds its glow of ½, of which ½ reaches the next: ½ · (1 + ½ + … + ½^depth) = 1 − ½^(depth+1)
    let mut scene = Scene::new(looking([0.3, 0.1, 0.2], [5.0, 1.0, 1.0], 100.0));
    let mirror = Material { reflection: 0.5, ..glowing(rgb(0.5, 0.5, 0.5)) };
    let material = scene.add_material(mirror);
    scene.add(ball(Vec3::ZERO, 2.0), material);
    for depth in 0..12 {
        let picture = colors(&scene, &Settings { max_depth: Some(depth), ..Settings::new([16, 12]) });
        let expected = (1.0 - libm::pow(0.5, f64::from(depth) + 1.0)) as f32;
        assert!(picture.iter().all(|c| *c == [expected; 3]), "depth {depth}");
    }
}

#[test]
fn a_mirror_corridor_shows_its_walls_in_turn_up_to_the_known_depth() {
    let mut scene = Scene::new(looking([0.0, 0.0, 0.0], [0.0, 0.0, -1.0], 20.0));
    scene.background = rgb(9.0, 9.0, 9.0);
    let wall = |color| Material { reflection: 0.8, ..glowing(color) };
    let front = scene.add_material(wall(rgb(0.2, 0.0, 0.1)));
    let back = scene.add_material(wall(rgb(0.0, 0.3, 0.1)));
    scene.add(Shape::Plane { normal: vec3(0.0, 0.0, 1.0), distance: -1.0 }, front);
    scene.add(Shape::Plane { normal: vec3(0.0, 0.0, -1.0), distance: -2.0 }, back);
    for depth in [0, 1, 2, 5, 10] {
        // Red comes from even bounces, green from odd ones, blue from all.
        let sum = |first: u32, step: usize| -> f64 {
            (first..=depth).step_by(step).map(|k| libm::pow(0.8, f64::from(k))).sum()
        };
        let expected = [0.2 * sum(0, 2), 0.3 * sum(1, 2), 0.1 * sum(0, 1)];
        for method in METHODS {
            let settings = Settings { method, max_depth: Some(depth), ..Settings::new([15, 9]) };
            for color in colors(&scene, &settings) {
                (0..3).for_each(|c| assert!((f64::from(color[c]) - expected[c]).abs() < 1e-7, "{color:?}"));
            }
        }
    }
}

#[test]
fn a_floor_is_as_bright_as_lamberts_law_says() {
    // Light falls at 60° from the normal: 0.1 + 0.8 · cos 60° = 0.5 of the colour, times the light for the second part.
    let mut scene = Scene::new(looking([0.0, 3.0, 0.0], [0.0, 0.0, -1.0], 60.0));
    let floor = scene.add_material(Material::matte("floor", rgb(1.0, 0.5, 0.25)));
    scene.add(Shape::Plane { normal: vec3(0.0, 7.0, 0.0), distance: 0.0 }, floor);
    let direction = vec3(0.75_f64.sqrt(), -0.5, 0.0) * 3.0;
    scene.lights.push(Light::Directional { direction, color: rgb(1.0, 1.0, 2.0) });
    for color in colors(&scene, &Settings::new([20, 20])) {
        // 0.25 · (0.1 + 2 · 0.4) = 0.225
        let expected = [0.5, 0.25, 0.225];
        (0..3).for_each(|c| assert!((color[c] - expected[c]).abs() < 1e-6, "{color:?}"));
    }
}

#[test]
fn a_ball_hides_a_light_exactly_where_its_shadow_falls() {
    // A light straight above at height 4, a ball of radius 1 at height 2: the tangent cone has sin = 1/2, so the shadow on
    // the floor has radius 4 · tan 30°.
    let mut scene = Scene::new(looking([0.0, 1.0, 0.0], [0.0, 0.0, 0.0], 90.0));
    scene.camera.up = vec3(0.0, 0.0, -1.0);
    scene.camera.projection = Projection::Orthographic { extent: 6.0 };
    let floor = scene.add_material(Material { ambient: 0.0, ..Material::matte("floor", Rgb::WHITE) });
    scene.add(Shape::Plane { normal: vec3(0.0, 1.0, 0.0), distance: 0.0 }, floor);
    scene.add(ball(vec3(0.0, 2.0, 0.0), 1.0), floor);
    scene.lights.push(Light::Point { position: vec3(0.0, 4.0, 0.0), color: Rgb::WHITE });
    let picture = colors(&scene, &Settings::new([300, 300]));
    let radius = 4.0 / 3.0_f64.sqrt();
    for (i, color) in picture.iter().enumerate() {
        let at = |k: usize| (k as f64 - 149.5) / 50.0;
        let from_middle = libm::hypot(at(i % 300), at(i / 300));
        if (from_middle - radius).abs() > 1e-9 {
            assert_eq!(color[0] > 0.0, from_middle > radius, "pixel {} {}", i % 300, i / 300);
        }
    }
}

/// Number of pixels that show the only object.
fn covered(camera: Camera, shape: Shape, size: [u32; 2], method: Method) -> usize {
    let mut scene = Scene::new(camera);
    let material = scene.add_material(glowing(Rgb::WHITE));
    scene.add(shape, material);
    let settings = Settings { method, layers: vec![Layer::Surface], ..Settings::new(size) };
    let picture = render_with_layers(&scene, &settings, &Run::default());
    let white = picture.colors.iter().filter(|c| **c == [1.0; 3]).count();
    assert_eq!(white, picture.surface.iter().filter(|&&s| s == 0).count());
    white
}

#[test]
fn a_ball_covers_the_known_share_of_the_picture() {
    const N: u32 = 512;
    let camera = looking([0.0, 0.0, 3.0], [0.0, 0.0, 0.0], 90.0);
    let parallel = Camera { projection: Projection::Orthographic { extent: 2.0 }, ..camera.clone() };
    // In a square of side 2: a circle of radius 0.8; and from distance 3 a ball of radius 1 is a circle of radius 1/√8.
    for (camera, radius, square) in [(parallel, 0.8, 0.64), (camera, 1.0, 0.125)] {
        let middle = |k: u32| (2.0 * f64::from(k) + 1.0) / f64::from(N) - 1.0;
        let inside = |x: u32, y: u32| middle(x) * middle(x) + middle(y) * middle(y) < square;
        let expected = (0..N * N).filter(|i| inside(i % N, i / N)).count();
        for method in [Method::Full, Method::Border(BorderSettings::default())] {
            assert_eq!(covered(camera.clone(), ball(Vec3::ZERO, radius), [N, N], method), expected);
        }
        // And the pixels whose middles it covers make up its area.
        let share = expected as f64 / f64::from(N * N);
        assert!((share / (square * PI / 4.0) - 1.0).abs() < 3e-3, "{share}");
    }
}

#[test]
fn other_shapes_cover_their_known_shares_too() {
    let camera = Camera {
        projection: Projection::Orthographic { extent: 4.0 },
        ..looking([0.0, 0.0, 5.0], [0.0, 0.0, 0.0], 90.0)
    };
    let (down, up) = (vec3(0.0, -1.0, 0.0), vec3(0.0, 1.0, 0.0));
    let square = |half: f64| {
        [[-half, -half], [half, -half], [half, half], [-half, half]].map(|[x, y]| vec3(x, y, 0.0)).to_vec()
    };
    let cases = [
        // from the side: 2 high, 1 wide
        (Shape::Cylinder { base: down, top: up, radius: 0.5, capped: true }, 2.0),
        // a triangle 2 high on a base of 2
        (Shape::Cone { base: down, base_radius: 1.0, top: up, top_radius: 0.0, capped: false }, 2.0),
        // turned by 60°: an ellipse with half axes 1 and ½
        (Shape::Disc { center: Vec3::ZERO, normal: vec3(0.75_f64.sqrt(), 0.0, 0.5), radius: 1.0 }, PI / 2.0),
        // 3 × 3 less 1 × 1
        (Shape::Polygon { outline: square(1.5), holes: vec![square(0.5)] }, 8.0),
    ];
    for (shape, expected) in cases {
        let area = covered(camera.clone(), shape.clone(), [400, 400], Method::Full) as f64 * 1e-4;
        assert!((area / expected - 1.0).abs() < 5e-3, "{}: {area}, not {expected}", shape.kind());
    }
}

#[test]
fn glass_with_the_index_of_air_is_invisible() {
    // Deep enough that what the last bounce brings is far below the tolerance.
    let scene = Scene { max_depth: 9, ..all_shapes() };
    let mut with_glass = scene.clone();
    with_glass.max_depth += 2;
    let air =
        Material { transmission: 1.0, index_of_refraction: 1.0, casts_shadow: false, ..glowing(Rgb::BLACK) };
    let air = with_glass.add_material(air);
    with_glass.add(ball(vec3(0.5, 2.0, 5.0), 1.0), air);
    let settings = Settings::new([120, 90]);
    let (without, with) = (colors(&scene, &settings), colors(&with_glass, &settings));
    // Beyond the ball rays start anew with rounded origins and directions: borders may move by a pixel of a million.
    let differs = |a: &[f32; 3], b: &[f32; 3]| (0..3).any(|c| (a[c] - b[c]).abs() > 1e-5);
    let differing = without.iter().zip(&with).filter(|(a, b)| differs(a, b)).count();
    assert!(differing <= 2, "{differing} pixels");
    let plain = colors(&scene, &Settings { max_depth: Some(0), ..settings });
    assert_ne!(plain, without, "the scene has nothing behind the glass that could be changed");
}

#[test]
fn glass_bends_rays_by_snells_law() {
    // Through a glass ball of index 1.5 the far side is seen at the focal length n·R / (2·(n − 1)) = 1.5 R from its middle:
    // rays near the axis cross there. A dot there fills the ball's middle, a dot at twice that distance does not.
    let mut scene = Scene::new(looking([0.0, 0.0, 50.0], [0.0, 0.0, 0.0], 1.0));
    scene.camera.projection = Projection::Orthographic { extent: 0.2 };
    let glass = Material { transmission: 1.0, index_of_refraction: 1.5, ..glowing(Rgb::BLACK) };
    let glass = scene.add_material(glass);
    let white = scene.add_material(glowing(Rgb::WHITE));
    scene.add(ball(Vec3::ZERO, 1.0), glass);
    let dot = |z: f64| Shape::Disc { center: vec3(0.0, 0.0, z), normal: vec3(0.0, 0.0, 1.0), radius: 0.002 };
    let mut share = |z: f64| {
        scene.objects.truncate(1);
        scene.add(dot(z), white);
        let picture = colors(&scene, &Settings::new([100, 100]));
        picture.iter().filter(|c| c[0] == 1.0).count() as f64 / 1e4
    };
    assert_eq!(share(-1.5), 1.0);
    // At 3 R rays from height h arrive at −h: of the square of side 0.2 a circle of radius 0.002 is left.
    let expected = PI * 0.002 * 0.002 / 0.04;
    let seen = share(-3.0);
    assert!((seen / expected - 1.0).abs() < 0.3, "{seen}, not {expected}");
}
