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
    let count = |scene: &Scene| {
        let renderer = Renderer::new(checked(scene));
        renderer.prepared(Accelerator::Bvh, &Run::default()).unwrap().primitive_count()
    };
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

fn rectangle([x0, x1]: [f64; 2], [y0, y1]: [f64; 2], place: fn(Vec3) -> Vec3) -> Shape {
    let outline = [vec3(x0, y0, 0.0), vec3(x1, y0, 0.0), vec3(x1, y1, 0.0), vec3(x0, y1, 0.0)];
    Shape::Polygon { outline: outline.map(place).to_vec(), holes: Vec::new() }
}

fn glowing(name: &str, color: Rgb, opacity: f64) -> Material {
    Material { ambient: 1.0, diffuse: 0.0, opacity, ..Material::matte(name, color) }
}

/// A mesh of boxes, faces outward.
fn mesh_of_boxes(boxes: &[[Vec3; 2]], place: fn(Vec3) -> Vec3) -> Mesh {
    let mut mesh = Mesh::default();
    for face in boxes.iter().flat_map(|&[lo, hi]| faces_of_box(lo, hi, place)) {
        let first = mesh.positions.len() as u32;
        mesh.positions.extend(face);
        mesh.triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
    }
    mesh
}

/// The corner of a tilted box may be the origin itself, whose coordinates do not round.
#[test]
fn a_box_with_a_corner_at_the_origin_given_twice_is_one_box() {
    let mut scene = lit_scene();
    let material = matte(&mut scene, rgb(0.9, 0.7, 0.5));
    let mesh = mesh_of_boxes(&[[vec3(0.0, 0.0, 0.0), vec3(0.9, 0.3, 0.5)]], turned);
    scene.add(Shape::from(mesh.clone()), material);
    let once = colors(&scene);
    let mut again = mesh;
    again.triangles.iter_mut().for_each(|corners| corners.swap(0, 2));
    scene.add(Shape::from(again), material);
    assert_eq!(differing_by(1e-3, &colors(&scene), &once), 0);
}

/// What is partly there does not hide what lies in the same place, whichever the file names first.
#[test]
fn behind_a_veil_on_a_wall_the_wall_is_seen() {
    let (side, wall, veil) = ([-0.9, 0.9], rgb(0.0, 0.8, 0.0), rgb(1.0, 0.0, 0.0));
    for veil_first in [false, true] {
        let mut scene = lit_scene();
        let wall = scene.add_material(glowing("wall", wall, 1.0));
        let veil = scene.add_material(glowing("veil", veil, 0.25));
        let mut add = |material| scene.add(rectangle(side, side, turned), material);
        if veil_first {
            add(veil);
            add(wall);
        } else {
            add(wall);
            add(veil);
        }
        let seen = colors(&scene);
        let mixed = |c: &&[f32; 3]| (c[0] - 0.25).abs() < 1e-6 && (c[1] - 0.6).abs() < 1e-6 && c[2] == 0.0;
        let count = seen.iter().filter(mixed).count();
        assert!(count > 500, "veil first: {veil_first}: {count} pixels");
        let background = |c: &&[f32; 3]| c[2] == 0.5;
        assert_eq!(count + seen.iter().filter(background).count(), seen.len());
    }
}

/// Through a veil and the pane in its place no more light comes than through the pane.
#[test]
fn a_veil_does_not_take_a_panes_shadow_away() {
    let under = |names: &str| {
        let mut scene = lit_scene();
        scene.lights.truncate(1);
        let floor = matte(&mut scene, rgb(0.9, 0.9, 0.9));
        scene.add(Shape::Plane { normal: vec3(0.0, 1.0, 0.0), distance: -1.0 }, floor);
        let level = |p: Vec3| vec3(p.x, 1.0, p.y);
        for name in names.chars() {
            let material = match name {
                'p' => Material { transmission: 0.5, ..Material::matte("pane", rgb(0.5, 0.5, 0.5)) },
                _ => glowing("veil", rgb(1.0, 0.0, 0.0), 0.3),
            };
            let material = scene.add_material(material);
            scene.add(rectangle([-2.0, 2.0], [-2.0, 2.0], level), material);
        }
        colors(&scene)[60 * 100 + 50]
    };
    assert_eq!(under("p"), under("pv"));
    assert_eq!(under("pv"), under("vp"));
    assert!(under("v")[1] > under("p")[1]);
}

/// Two solids that touch are usually one mesh of a file.
#[test]
fn glass_that_touches_glass_in_one_mesh_is_as_in_two() {
    let (lo, hi) = (vec3(-1.0, -0.5, -0.6), vec3(1.2, 0.6, 0.7));
    let boxes = [[lo, vec3(0.25, hi.y, hi.z)], [vec3(0.25, lo.y, lo.z), hi]];
    let picture = |meshes: &[&[[Vec3; 2]]]| {
        let mut scene = lit_scene();
        checkered_floor(&mut scene);
        let glass = glass(&mut scene, 1.5);
        meshes.iter().for_each(|boxes| scene.add(Shape::from(mesh_of_boxes(boxes, |p| p)), glass));
        scene.max_depth = 12;
        colors(&scene)
    };
    assert_eq!(differing(&picture(&[&boxes]), &picture(&[&boxes[..1], &boxes[1..]])), 0);
}

/// A plate of triangles whose corners are rounded off its plane: none lies on the plane of another, and there are many.
#[test]
fn many_faces_almost_in_one_plane_are_prepared_in_time_that_grows_with_their_number() {
    let seconds = |side: u32| {
        let mut mesh = Mesh::default();
        let rounded = |p: Vec3| {
            let digits = |x: f64| (x * 1e12).round() / 1e12;
            vec3(digits(p.x), digits(p.y), digits(p.z))
        };
        for (i, j) in (0..=side).flat_map(|i| (0..=side).map(move |j| (i, j))) {
            let share = |i: u32| f64::from(i) / f64::from(side);
            mesh.positions.push(rounded(turned(vec3(share(i), share(j), 0.0))));
        }
        for (i, j) in (0..side).flat_map(|i| (0..side).map(move |j| (i, j))) {
            let at = |i: u32, j: u32| i * (side + 1) + j;
            mesh.triangles.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
            mesh.triangles.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
        }
        let mut scene = lit_scene();
        let material = matte(&mut scene, rgb(0.9, 0.7, 0.5));
        scene.add(Shape::from(mesh), material);
        let scene = checked(&scene);
        let begin = std::time::Instant::now();
        assert_eq!(
            Renderer::new(scene).prepared(Accelerator::None, &Run::default()).unwrap().primitive_count()
                as u32,
            2 * side * side
        );
        begin.elapsed().as_secs_f64()
    };
    // 16 times as many: 256 times as long if all are compared with all. Between the two lies what other programs may do.
    let [few, many] = [seconds(60), seconds(240)];
    assert!(many < 80.0 * few.max(0.003), "{few} and {many} s");
}

/// Coordinates far from the origin are rounded there: planes of one face through other corners differ by that.
#[test]
fn a_box_cut_by_other_diagonals_far_from_the_origin_is_one_box() {
    for distance in [10.0, 1e3, 1e5] {
        let offset = vec3(1.0, -0.3, 0.7) * distance;
        let box_cut_at = |corner: usize| {
            let mut mesh = Mesh::default();
            for mut face in faces_of_box(vec3(-0.7, -0.6, -0.5), vec3(0.9, 0.3, 0.5), turned) {
                face.rotate_left(corner);
                let first = mesh.positions.len() as u32;
                mesh.positions.extend(face.into_iter().map(|p| p + offset));
                mesh.triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
            }
            Shape::from(mesh)
        };
        let mut scene = lit_scene();
        scene.camera.eye = scene.camera.eye + offset;
        scene.camera.look_at = scene.camera.look_at + offset;
        scene.lights.remove(0);
        let material = matte(&mut scene, rgb(0.9, 0.7, 0.5));
        scene.add(box_cut_at(0), material);
        let once = colors(&scene);
        scene.add(box_cut_at(1), material);
        let off = differing_by(1.0, &colors(&scene), &once);
        assert_eq!(off, 0, "{distance} away");
    }
}

/// A lamp in a ceiling lights the room under it, however the room is turned.
#[test]
fn a_light_that_lies_in_a_face_is_not_hidden_by_it() {
    let picture = |height: f64| {
        let mut scene = lit_scene();
        scene.lights = vec![Light::Point { position: turned(vec3(0.1, height, 0.3)), color: Rgb::WHITE }];
        let white = matte(&mut scene, rgb(0.9, 0.9, 0.9));
        let level = |p: Vec3| turned(vec3(p.x, -0.5, p.y));
        scene.add(rectangle([-3.0, 3.0], [-3.0, 3.0], level), white);
        let ceiling = |p: Vec3| turned(vec3(p.x, 0.9, p.y));
        scene.add(rectangle([-3.0, 3.0], [-3.0, 3.0], ceiling), white);
        scene.camera = looking([0.0; 3], [0.0; 3], 90.0);
        scene.camera.eye = turned(vec3(0.4, 0.5, 2.0));
        scene.camera.look_at = turned(vec3(0.0, -0.5, 0.0));
        scene.camera.up = turned(vec3(0.0, 1.0, 0.0));
        colors(&scene)
    };
    let (just_under, in_the_ceiling) = (picture(0.899_999), picture(0.9));
    // The ceiling itself is lit by neither.
    let off = differing_by(2.0, &just_under, &in_the_ceiling);
    assert!(off < 20, "{off} pixels");
}

/// Planes have no box that could say how large the scene is.
#[test]
fn planes_alone_and_far_away_are_one() {
    for (distance, with_ball) in [(6.1, false), (6.1e9, false), (6.1e9, true)] {
        let mut scene = Scene::new(looking([0.0, 0.0, 0.0], [1.0, 2.0, 3.0], 40.0));
        let white = scene.add_material(Material::matte("white", rgb(0.9, 0.9, 0.9)));
        for scale in [1.0, 3.0, 7.0, -0.3] {
            let (normal, distance) = (vec3(1.0, 2.0, 3.0) * scale, distance * scale);
            scene.add(Shape::Plane { normal, distance }, white);
        }
        if with_ball {
            scene.add(Shape::Sphere { center: vec3(0.0, 0.0, -9.0), radius: 1.0 }, white);
        }
        let renderer = Renderer::new(checked(&scene));
        let prepared = renderer.prepared(Accelerator::Bvh, &Run::default()).unwrap();
        assert!(
            prepared.primitive_count() <= 2 + usize::from(with_ball),
            "{distance}: {}",
            prepared.primitive_count()
        );
    }
}
