//! Mistakes of certified ray tracing and of its prototypes, each as the scene that shows it.

use brt_geometry::{Vec3, vec3};
use brt_image::{Rgb, Transfer, rgb};
use brt_procedural as procedural;
use brt_render::{Certificate, CertifiedSettings, CheckedPixels, Method, Run, Settings};
use brt_scene::{Camera, Light, Material, Mesh, Projection, Scene, Shape};
use brt_testkit::{Rendered, looking, render_stored_at_every_level};

fn certified(scene: &Scene) -> Rendered {
    let method = Method::Certified(CertifiedSettings { tolerance: 1.0 });
    let settings = Settings { method, checked: CheckedPixels::All, ..Settings::new([150, 150]) };
    render_stored_at_every_level(scene, &settings, &Run::default(), Transfer::Linear)
}

/// How many samples differ from full ray tracing by more than a level.
fn above(picture: &Rendered) -> usize {
    let differs = |a: &[f32; 3], b: &[f32; 3]| (0..3).any(|c| (a[c] - b[c]).abs() > 1.0 / 255.0);
    picture.colors.iter().zip(&picture.full).filter(|(a, b)| differs(a, b)).count()
}

fn filled(picture: &Rendered) -> f64 {
    picture.stats.pixels.filled as f64 / picture.stats.pixels.total as f64
}

/// A box as six quadrilaterals.
fn add_box(scene: &mut Scene, lo: Vec3, hi: Vec3, material: brt_scene::MaterialId) {
    let at = |x: usize, y: usize, z: usize| {
        let pick = |i: usize, axis: usize| if i == 0 { lo[axis] } else { hi[axis] };
        vec3(pick(x, 0), pick(y, 1), pick(z, 2))
    };
    let sides = [
        [at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0)],
        [at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1)],
        [at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1)],
        [at(0, 1, 0), at(0, 1, 1), at(1, 1, 1), at(1, 1, 0)],
        [at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0)],
        [at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)],
    ];
    for side in sides {
        scene.add(Shape::Polygon { outline: side.to_vec(), holes: Vec::new() }, material);
    }
}

/// Two rules for the faces of closed solids at once (leave out those towards the light; those away from it) had left
/// out all of them: everything was lit. A box on a floor touches it, so its lower face is in contact with its shadow.
#[test]
fn boxes_that_stand_on_a_floor_cast_their_shadows() {
    let mut scene = Scene::new(looking([3.0, 5.0, 8.0], [0.0, 0.0, 0.0], 40.0));
    scene.lights.push(Light::Point { position: vec3(-4.0, 7.0, 2.0), color: Rgb::WHITE });
    let grey = scene.add_material(Material::matte("grey", rgb(0.7, 0.7, 0.7)));
    scene.add(Shape::Plane { normal: vec3(0.0, 1.0, 0.0), distance: 0.0 }, grey);
    for x in [-2.0, 0.0, 2.0] {
        add_box(&mut scene, vec3(x - 0.6, 0.0, -0.6), vec3(x + 0.6, 1.5, 0.6), grey);
    }
    let picture = certified(&scene);
    assert_eq!(above(&picture), 0);
    let shadow = picture.stats.certificates[Certificate::Shadow];
    assert!(shadow.proven > 30 && filled(&picture) > 0.5, "{shadow:?}, {}", filled(&picture));
    let darkest = |colors: &[[f32; 3]]| colors.iter().filter(|c| c[0] < 0.1).count();
    assert!(darkest(&picture.colors) > 500 && darkest(&picture.colors) == darkest(&picture.full));
}

/// A ball inside of a solid proves a shadow only if it is inside: a torus's middle is not.
#[test]
fn light_falls_through_the_hole_of_a_torus() {
    for name in ["torus", "mirror-torus"] {
        let mut scene = procedural::find(name).unwrap().build(Some(1600)).unwrap();
        scene.lights = vec![Light::Directional { direction: vec3(0.05, -1.0, 0.02), color: Rgb::WHITE }];
        assert_eq!(above(&certified(&scene)), 0, "{name}");
    }
}

/// Smooth normals may send mirror rays below the faces; nothing that is known of solids holds for them.
#[test]
fn mirrors_with_smooth_normals_are_left_to_rays() {
    let mut scene = Scene::new(looking([0.5, 2.0, 6.0], [0.0, 0.4, 0.0], 40.0));
    scene.background = rgb(0.2, 0.3, 0.5);
    scene.lights.push(Light::Point { position: vec3(-3.0, 5.0, 4.0), color: Rgb::WHITE });
    let mirror = Material { reflection: 0.7, diffuse: 0.2, ..Material::matte("mirror", Rgb::WHITE) };
    let mirror = scene.add_material(mirror);
    let floor = scene.add_material(Material::matte("floor", rgb(0.8, 0.5, 0.3)));
    scene.add(Shape::Plane { normal: vec3(0.0, 1.0, 0.0), distance: 0.0 }, floor);
    // A pyramid with the normals of a ball.
    let positions = vec![
        vec3(-1.0, 0.0, -1.0),
        vec3(1.0, 0.0, -1.0),
        vec3(1.0, 0.0, 1.0),
        vec3(-1.0, 0.0, 1.0),
        vec3(0.0, 1.6, 0.0),
    ];
    let normals = positions.iter().map(|&p| p - vec3(0.0, 0.3, 0.0)).collect();
    let triangles = vec![[3, 2, 4], [2, 1, 4], [1, 0, 4], [0, 3, 4]];
    scene.add(Shape::from(Mesh { positions, normals, triangles, ..Mesh::default() }), mirror);
    let picture = certified(&scene);
    assert_eq!(above(&picture), 0);
    assert!(picture.stats.certificates[Certificate::Surface].failed > 0);
}

/// Candidates inherited but not yet looked at were once counted as if they were too many, and large blocks stayed open.
#[test]
fn more_primitives_than_lists_hold_keep_nothing_else_from_being_proven() {
    let mut scene = Scene::new(looking([0.0, 9.0, 6.0], [0.0, 0.0, 0.0], 50.0));
    scene.lights.push(Light::Point { position: vec3(0.0, 9.0, 0.0), color: Rgb::WHITE });
    let grey = scene.add_material(Material::matte("grey", rgb(0.7, 0.7, 0.7)));
    scene.add(Shape::Plane { normal: vec3(0.0, 1.0, 0.0), distance: 0.0 }, grey);
    for i in 0..400 {
        let (x, z) = (f64::from(i % 20) * 0.05 - 0.5, f64::from(i / 20) * 0.05 - 0.5);
        scene.add(Shape::Sphere { center: vec3(x, 3.0, z), radius: 0.02 }, grey);
    }
    let picture = certified(&scene);
    assert_eq!(above(&picture), 0);
    assert!(filled(&picture) > 0.5, "{}", filled(&picture));
}

fn shiny() -> Material {
    Material { specular: 0.8, exponent: 1.0, ..Material::matte("shiny", Rgb::WHITE) }
}

/// A light in the plane of a face is before or behind it by rounding alone, from sample to sample.
#[test]
fn a_light_in_the_plane_of_a_face_is_left_to_rays() {
    let normal = vec3(1.0, 2.0, 3.0).normalize();
    let (along, across) = normal.tangents();
    let center = vec3(0.3, 0.2, 0.1);
    let at = |u: f64, v: f64| center + along * u + across * v;
    let eye: Vec3 = center + normal * 6.0 - along * 4.0;
    let mut scene = Scene::new(looking(eye.into(), center.into(), 40.0));
    scene.lights.push(Light::Point { position: at(5.0, 1.0), color: Rgb::WHITE });
    let material = scene.add_material(shiny());
    let outline = vec![at(-3.0, -2.0), at(3.0, -2.0), at(3.0, 2.0), at(-3.0, 2.0)];
    scene.add(Shape::Polygon { outline, holes: Vec::new() }, material);
    assert_eq!(above(&certified(&scene)), 0);
}

/// Light that comes in through the open end of a tube reaches the edge of its outer side from behind.
#[test]
fn light_through_the_open_end_of_a_tube_brings_no_highlight_outside() {
    for height in [0.2, 0.6, 1.0] {
        let mut scene = Scene::new(looking([6.0, 3.0, 4.0], [0.0, 0.5, 0.0], 35.0));
        scene.lights.push(Light::Point { position: vec3(-1.3, 1.0 + height, -0.2), color: Rgb::WHITE });
        let material = scene.add_material(shiny());
        let (base, top) = (vec3(0.0, -1.0, 0.0), vec3(0.0, 1.0, 0.0));
        scene.add(Shape::Cylinder { base, top, radius: 1.5, capped: false }, material);
        assert_eq!(above(&certified(&scene)), 0, "light {height} above the rim");
    }
}

/// Fills were cut off at black, though files may ask for darker colours.
#[test]
fn negative_colors_are_filled_as_they_are() {
    let mut scene = Scene::new(looking([0.0, 0.0, 5.0], [0.0, 0.0, 0.0], 45.0));
    scene.background = rgb(-3.0, 0.2, -0.5);
    let grey = scene.add_material(Material::matte("grey", rgb(0.7, 0.7, 0.7)));
    scene.add(Shape::Sphere { center: vec3(0.0, 0.0, 0.0), radius: 1.0 }, grey);
    let picture = certified(&scene);
    assert_eq!(above(&picture), 0);
    assert!(filled(&picture) > 0.5);
}

/// Light nearly along a polygon met its fitted plane above the floor, where none of its corners was: a third of the picture
/// was off by 60 levels. Such polygons are cut into triangles now.
#[test]
fn polygons_off_their_plane_hide_lights_where_they_are() {
    let mut scene = Scene::new(Camera {
        eye: vec3(-7.0, 10.0, 0.2),
        look_at: vec3(-7.0, 0.0, 0.2),
        up: vec3(0.0, 0.0, -1.0),
        projection: Projection::Orthographic { extent: 0.4 },
    });
    scene.lights.push(Light::Directional { direction: vec3(0.0, -1.0, -40.0), color: rgb(10.0, 10.0, 10.0) });
    let white = scene.add_material(Material::matte("white", Rgb::WHITE));
    let positions = [[-30.0, 0.0, -30.0], [50.0, 0.0, -30.0], [-30.0, 0.0, 50.0]].map(Vec3::from).to_vec();
    scene.add(Shape::from(Mesh { positions, triangles: vec![[0, 2, 1]], ..Mesh::default() }), white);
    let outline = [[-8.0, -0.004, 0.0], [8.0, -0.0005, 0.0], [8.0, -0.029, -8.0], [-8.0, -0.0005, -8.0]];
    scene.add(Shape::Polygon { outline: outline.map(Vec3::from).to_vec(), holes: Vec::new() }, white);
    assert_eq!(scene.check(), []);
    assert_eq!(above(&certified(&scene)), 0);
}
