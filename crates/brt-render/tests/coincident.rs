//! What coincides is one thing: no salt and pepper, nothing hidden by itself, light straight through glass that touches
//! glass.

use brt_geometry::{Vec3, vec3};
use brt_image::{Rgb, rgb};
use brt_render::{Accelerator, CertifiedSettings, Method, Renderer, Run, Settings};
use brt_scene::{Light, Material, MaterialId, Mesh, Scene, Shape};
use brt_testkit::{checked, looking, render_with_layers};

/// How many pixels differ.
fn differing(a: &[[f32; 3]], b: &[[f32; 3]]) -> usize {
    a.iter().zip(b).filter(|(a, b)| a != b).count()
}

/// The picture by the oracle, after full and certified ray tracing gave the same.
fn colors(scene: &Scene) -> Vec<[f32; 3]> {
    assert_eq!(scene.check(), []);
    let exact = Method::Certified(CertifiedSettings { tolerance: 0.0 });
    let [expected, full, certified] = [Method::Reference, Method::Full, exact]
        .map(|method| Settings { method, ..Settings::new([100, 100]) })
        .map(|settings| render_with_layers(scene, &settings, &Run::default()).colors);
    assert_eq!(differing(&full, &expected), 0, "full");
    assert_eq!(differing(&certified, &expected), 0, "certified");
    expected
}

/// How many pixels differ by more than so many levels.
fn differing_by(levels: f32, a: &[[f32; 3]], b: &[[f32; 3]]) -> usize {
    let differs = |a: &[f32; 3], b: &[f32; 3]| (0..3).any(|c| (a[c] - b[c]).abs() * 255.0 > levels);
    a.iter().zip(b).filter(|(a, b)| differs(a, b)).count()
}

fn lit_scene() -> Scene {
    let mut scene = Scene::new(looking([3.1, 2.7, 5.3], [0.1, 0.2, 0.0], 32.0));
    scene.background = rgb(0.2, 0.3, 0.5);
    scene.lights.push(Light::Point { position: vec3(4.0, 7.0, 3.0), color: rgb(0.7, 0.7, 0.7) });
    scene.lights.push(Light::Directional { direction: vec3(-0.2, -0.1, -1.0), color: rgb(0.4, 0.4, 0.4) });
    scene
}

fn matte(scene: &mut Scene, color: Rgb) -> MaterialId {
    scene.add_material(Material::matte("m", color))
}

/// A turn about a slanted axis, so that no coordinate is a round number.
fn turned(p: Vec3) -> Vec3 {
    let [u, v, w] = [vec3(0.8, 0.36, 0.48), vec3(-0.6, 0.48, 0.64), vec3(0.0, -0.8, 0.6)];
    vec3(u.dot(p), v.dot(p), w.dot(p))
}

/// Faces of a box, outward, each a list of corners.
fn faces_of_box(lo: Vec3, hi: Vec3, place: fn(Vec3) -> Vec3) -> Vec<Vec<Vec3>> {
    let at = |i: usize| {
        let pick = |bit: usize, lo: f64, hi: f64| if i & bit == 0 { lo } else { hi };
        place(vec3(pick(1, lo.x, hi.x), pick(2, lo.y, hi.y), pick(4, lo.z, hi.z)))
    };
    let faces = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
    faces.iter().map(|face| face.iter().map(|&i| at(i)).collect()).collect()
}

fn add_faces(scene: &mut Scene, faces: &[Vec<Vec3>], material: MaterialId) {
    for face in faces {
        scene.add(Shape::Polygon { outline: face.clone(), holes: Vec::new() }, material);
    }
}

fn add_box(scene: &mut Scene, lo: Vec3, hi: Vec3, material: MaterialId) {
    add_faces(scene, &faces_of_box(lo, hi, turned), material);
}

#[test]
fn a_face_given_twice_is_one_face() {
    let mut scene = lit_scene();
    let material = matte(&mut scene, rgb(0.9, 0.7, 0.5));
    let faces = faces_of_box(vec3(-1.0, -0.7, -0.6), vec3(1.0, 0.8, 0.9), turned);
    add_faces(&mut scene, &faces, material);
    let once = colors(&scene);
    let count = |scene: &Scene| Renderer::new(checked(scene)).prepared(Accelerator::Bvh).primitive_count();
    let alone = count(&scene);
    for reversed in [false, true] {
        let mut twice = scene.clone();
        for face in &faces {
            let mut face = face.clone();
            face.rotate_left(1);
            if reversed {
                face.reverse();
            }
            add_faces(&mut twice, &[face], material);
        }
        assert_eq!(differing_by(1e-3, &colors(&twice), &once), 0, "reversed: {reversed}");
        assert_eq!(count(&twice), alone);
    }
}

#[test]
fn a_mesh_given_many_times_costs_no_more_than_one() {
    let mut scene = lit_scene();
    let material = matte(&mut scene, rgb(0.9, 0.7, 0.5));
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    for face in faces_of_box(vec3(-1.0, -0.7, -0.6), vec3(1.0, 0.8, 0.9), turned) {
        let first = positions.len() as u32;
        positions.extend(face);
        triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
    }
    let mesh = Mesh { positions, triangles, ..Mesh::default() };
    scene.add(Shape::from(mesh.clone()), material);
    let once = colors(&scene);
    let full = Settings { method: Method::Full, ..Settings::new([100, 100]) };
    let tests = |scene: &Scene| render_with_layers(scene, &full, &Run::default()).stats.primitive_tests;
    let alone = tests(&scene);
    for _ in 0..200 {
        scene.add(Shape::from(mesh.clone()), material);
    }
    assert_eq!(tests(&scene), alone);
    assert_eq!(differing(&colors(&scene), &once), 0);
}

/// Two boxes end to end look as one, wherever they overlap.
#[test]
fn boxes_that_touch_or_overlap_in_their_planes_look_as_one() {
    let (lo, hi) = (vec3(-1.3, -0.5, -0.6), vec3(1.4, 0.6, 0.7));
    let picture = |boxes: &[[Vec3; 2]]| {
        let mut scene = lit_scene();
        let material = matte(&mut scene, rgb(0.9, 0.7, 0.5));
        boxes.iter().for_each(|&[lo, hi]| add_box(&mut scene, lo, hi, material));
        colors(&scene)
    };
    let whole = picture(&[[lo, hi]]);
    let cut = |x: f64, y: f64| [[lo, vec3(x, hi.y, hi.z)], [vec3(y, lo.y, lo.z), hi]];
    for (x, y) in [(0.1, 0.1), (0.5, -0.3), (1.0 / 3.0, 1.0 / 7.0)] {
        // The seam is seen by the pixels on it at most.
        let off = differing_by(1.0, &picture(&cut(x, y)), &whole);
        assert!(off <= 4, "cut at {x}, {y}: {off} pixels");
    }
}

#[test]
fn a_floor_and_what_stands_on_it_do_not_flicker() {
    let mut scene = lit_scene();
    // From below, where the floor and the bottom of the box lie in one plane.
    scene.camera = looking([1.0, -4.0, 2.0], [0.0, 0.0, 0.0], 30.0);
    scene.lights.push(Light::Point { position: vec3(-2.0, -5.0, 3.0), color: rgb(0.8, 0.8, 0.8) });
    let floor = matte(&mut scene, rgb(0.2, 0.8, 0.2));
    scene.add(Shape::Plane { normal: vec3(0.0, 1.0, 0.0), distance: 0.0 }, floor);
    let alone = colors(&scene);
    let red = matte(&mut scene, rgb(0.9, 0.1, 0.1));
    add_faces(&mut scene, &faces_of_box(vec3(-0.7, 0.0, -0.6), vec3(0.8, 1.0, 0.5), |p| p), red);
    scene.add(Shape::Disc { center: vec3(0.3, 0.0, 0.1), normal: vec3(0.0, -2.0, 0.0), radius: 0.9 }, red);
    // Of what coincides the first counts: the floor hides all that stands on it.
    assert_eq!(differing(&colors(&scene), &alone), 0);
}

#[test]
fn round_things_that_coincide_are_one() {
    let axis = |t: f64| turned(vec3(0.2, -1.0 + 2.0 * t, 0.1));
    let cylinder =
        |a: f64, b: f64| Shape::Cylinder { base: axis(a), top: axis(b), radius: 0.5, capped: false };
    let cone = |a: f64, b: f64| {
        let radius = |t: f64| 0.7 - 0.5 * t;
        Shape::Cone {
            base: axis(a),
            base_radius: radius(a),
            top: axis(b),
            top_radius: radius(b),
            capped: false,
        }
    };
    let ball = |_: f64, _: f64| Shape::Sphere { center: axis(0.4), radius: 0.8 };
    let shapes: [&dyn Fn(f64, f64) -> Shape; 3] = [&cylinder, &cone, &ball];
    for shape in shapes {
        let picture = |parts: &[(f64, f64)]| {
            let mut scene = lit_scene();
            let material = matte(&mut scene, rgb(0.9, 0.7, 0.5));
            parts.iter().for_each(|&(a, b)| scene.add(shape(a, b), material));
            colors(&scene)
        };
        let whole = picture(&[(0.0, 1.0)]);
        for parts in [&[(0.0, 1.0), (0.0, 1.0)][..], &[(0.0, 0.6), (0.3, 1.0)], &[(0.7, 0.0), (1.0, 0.5)]] {
            let off = differing_by(1.0, &picture(parts), &whole);
            assert!(off <= 6, "{} {parts:?}: {off} pixels", shape(0.0, 1.0).kind());
        }
    }
}

fn glass(scene: &mut Scene, index: f64) -> MaterialId {
    scene.add_material(Material {
        transmission: 0.95,
        index_of_refraction: index,
        casts_shadow: false,
        ambient: 0.0,
        diffuse: 0.0,
        ..Material::matte("glass", Rgb::BLACK)
    })
}

fn checkered_floor(scene: &mut Scene) {
    let checker = brt_scene::Checker { color: rgb(0.1, 0.1, 0.4), size: 0.3, axis: brt_scene::Axis::Y };
    let floor = Material { checker: Some(checker), ..Material::matte("floor", rgb(0.9, 0.9, 0.8)) };
    let floor = scene.add_material(floor);
    scene.add(Shape::Plane { normal: vec3(0.0, 1.0, 0.0), distance: -0.8 }, floor);
}

/// Light goes straight from glass into the same glass.
#[test]
fn glass_that_touches_glass_is_one_piece() {
    let (lo, hi) = (vec3(-1.0, -0.5, -0.6), vec3(1.2, 0.6, 0.7));
    let picture = |boxes: &[[Vec3; 2]]| {
        let mut scene = lit_scene();
        checkered_floor(&mut scene);
        let glass = glass(&mut scene, 1.5);
        boxes.iter().for_each(|&[lo, hi]| {
            add_faces(&mut scene, &faces_of_box(lo, hi, |p| p), glass);
        });
        scene.max_depth = 12;
        colors(&scene)
    };
    let whole = picture(&[[lo, hi]]);
    let halves = picture(&[[lo, vec3(0.25, hi.y, hi.z)], [vec3(0.25, lo.y, lo.z), hi]]);
    // The joint takes its share of the light, so brightness differs; what is seen through it does not move.
    let joint = |c: &[f32; 3]| c.map(|x| x * 0.95);
    let is_as = |a: &[f32; 3], b: &[f32; 3]| (0..3).all(|c| (a[c] - b[c]).abs() < 1.0 / 255.0);
    let explained = |a: &[f32; 3], b: &[f32; 3]| {
        is_as(a, b)
            || is_as(a, &joint(b))
            || is_as(a, &joint(&joint(b)))
            || is_as(a, &joint(&joint(&joint(b))))
    };
    let off = halves.iter().zip(&whole).filter(|(a, b)| !explained(a, b)).count();
    assert!(off <= 150, "{off} of 10000 pixels");
}

/// A glass block on a floor shows the floor, whichever was added first.
#[test]
fn glass_on_a_floor_shows_the_floor() {
    let picture = |floor_first: bool, gap: f64| {
        let mut scene = lit_scene();
        if floor_first {
            checkered_floor(&mut scene);
        }
        let glass = glass(&mut scene, 1.3);
        let lo = vec3(-0.8, -0.8 + gap, -0.6);
        add_faces(&mut scene, &faces_of_box(lo, vec3(0.9, 0.4, 0.5), |p| p), glass);
        if !floor_first {
            checkered_floor(&mut scene);
        }
        colors(&scene)
    };
    let (first, last) = (picture(true, 0.0), picture(false, 0.0));
    assert_eq!(differing(&first, &last), 0);
    // With air between, the floor is darker by what the bottom takes, but it is there.
    let is_background =
        |c: &&[f32; 3]| (c[2] - 0.5 * 0.95 * 0.95).abs() < 0.01 && (c[0] - 0.2 * 0.95 * 0.95).abs() < 0.01;
    let apart = picture(true, 1e-3);
    let holes = first.iter().filter(is_background).count();
    assert!(
        holes <= apart.iter().filter(is_background).count() + 20,
        "{holes} pixels look through the floor"
    );
}
