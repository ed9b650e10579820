//! Each certificate on a block where it holds and on the next one where it does not.

use brt_geometry::{Ray, RayBlock, Start, Taylor, Vec3, vec3};
use brt_image::{Rgb, rgb};
use brt_scene::{Axis, Checker, Light, Material, Mesh, Scene, Shape};
use brt_testkit::looking;

use super::screen::is_screened;
use super::*;
use crate::methods::certified::candidates::Candidates;
use crate::methods::certified::known_history::{KnownLighting, KnownSight};
use crate::prepare::{PreparedCamera, prepare};
use crate::products::{Area, Carrier, NOTHING, PreparedScene, SampleGrid};
use crate::run::Cancel;
use crate::settings::{Accelerator, Samples};
use crate::tracing::Patch;

/// Seen from above the origin, 0.1 units to a sample at height 0: sample 32, 32 is in the middle.
struct Stage {
    scene: PreparedScene,
    camera: PreparedCamera,
}

fn floor_scene(light: Vec3) -> Scene {
    let mut camera = looking([0.0, 20.0, 0.0], [0.0; 3], 0.0);
    camera.up = vec3(0.0, 0.0, -1.0);
    camera.projection = brt_scene::Projection::Orthographic { extent: 6.4 };
    let mut scene = Scene::new(camera);
    scene.lights.push(Light::Point { position: light, color: Rgb::WHITE });
    let floor = scene.add_material(Material::matte("floor", Rgb::WHITE));
    scene.add(Shape::Plane { normal: vec3(0.0, 1.0, 0.0), distance: 0.0 }, floor);
    scene
}

impl Stage {
    fn of(scene: Scene) -> Self {
        let checked = scene.checked().unwrap();
        let scene = prepare(&checked, Accelerator::Bvh, Cancel::NEVER).unwrap();
        let grid = SampleGrid::new([64, 64], Samples::One);
        let camera = PreparedCamera::new(&checked.camera, scene.origin, &grid);
        Self { scene, camera }
    }

    /// The rays through four by four samples around a place on the floor.
    fn block(&self, x: f64, z: f64) -> RayBlock {
        let [x0, y0] = [x, z].map(|place| (32.0 + 10.0 * place) as u32 - 2);
        RayBlock::new(self.camera.block(&Area { x0, y0, x1: x0 + 4, y1: y0 + 4 }))
    }

    /// What such rays see first, and where.
    fn patch(&self, block: &RayBlock) -> Patch<'_> {
        let mut candidates = Candidates::new(&self.scene);
        let seen = first_seen(&mut candidates, block, Carrier::NOWHERE, None, KnownSight::Unknown);
        let KnownSight::Met(id) = seen else { panic!("{seen:?}") };
        let t = block.distance(&self.scene.primitives[id as usize], Start::Elsewhere);
        Patch::at(&self.scene, &block.ray, id, t).unwrap()
    }

    /// How the floor there sees the light.
    fn lighting(&self, x: f64, z: f64) -> KnownLighting {
        let block = self.block(x, z);
        let patch = self.patch(&block);
        let light = &self.scene.lights[0];
        let ways = patch.ways_to(light);
        let mut candidates = Candidates::new(&self.scene);
        lighting(&mut candidates, &patch, None, light, &ways, KnownLighting::Unknown)
    }
}

#[test]
fn visibility_is_proven_inside_of_a_ball_and_beside_it_but_not_at_its_rim() {
    let mut scene = floor_scene(vec3(0.0, 10.0, 0.0));
    let ball = scene.add_material(Material::matte("ball", Rgb::WHITE));
    scene.add(Shape::Sphere { center: vec3(0.0, 3.0, 0.0), radius: 1.0 }, ball);
    let stage = Stage::of(scene);
    let seen = |x: f64| {
        let mut candidates = Candidates::new(&stage.scene);
        first_seen(&mut candidates, &stage.block(x, 0.0), Carrier::NOWHERE, None, KnownSight::Unknown)
    };
    assert!(matches!(seen(0.0), KnownSight::Met(1)));
    assert!(matches!(seen(2.0), KnownSight::Met(0)));
    assert!(matches!(seen(1.0), KnownSight::Among(_)));
    // What leaves the floor upwards meets the ball, or nothing.
    let up = |x: f64| {
        let patch = stage.patch(&stage.block(x, 0.0));
        let block = RayBlock::new(Ray::new(patch.point, vec3(0.0, 1.0, 0.0).lift::<Taylor>()));
        first_seen(&mut Candidates::new(&stage.scene), &block, patch.carrier, None, KnownSight::Unknown)
    };
    assert!(matches!(up(2.0), KnownSight::Met(NOTHING)));
}

#[test]
fn a_light_is_hidden_inside_of_a_shadow_and_seen_outside_but_its_border_is_open() {
    let mut scene = floor_scene(vec3(10.0, 10.0, 0.0));
    let ball = scene.add_material(Material::matte("ball", Rgb::WHITE));
    // Its shadow falls on the floor about −2, 0; across it is 0.83 units wide to each side.
    scene.add(Shape::Sphere { center: vec3(2.8, 4.0, 0.0), radius: 0.5 }, ball);
    let stage = Stage::of(scene);
    assert!(matches!(stage.lighting(-2.0, 0.0), KnownLighting::Hidden));
    assert!(matches!(stage.lighting(-2.0, 0.83), KnownLighting::Among(_)));
    assert!(matches!(stage.lighting(-2.0, 1.5), KnownLighting::Seen));
}

/// A wall of many triangles: none hides the light from a block alone.
fn wall(side: u32) -> Mesh {
    let mut mesh = Mesh::default();
    let share = |i: u32| 4.0 * f64::from(i) / f64::from(side) - 2.0;
    for (i, j) in (0..=side).flat_map(|i| (0..=side).map(move |j| (i, j))) {
        mesh.positions.push(vec3(share(i), 5.0, share(j)));
    }
    for (i, j) in (0..side).flat_map(|i| (0..side).map(move |j| (i, j))) {
        let at = |i: u32, j: u32| i * (side + 1) + j;
        mesh.triangles.push([at(i, j), at(i, j + 1), at(i + 1, j + 1)]);
        mesh.triangles.push([at(i, j), at(i + 1, j + 1), at(i + 1, j)]);
    }
    mesh
}

#[test]
fn faces_that_share_their_edges_hide_a_light_together_until_one_of_them_is_missing() {
    let screened = |mesh: Mesh| {
        let mut scene = floor_scene(vec3(0.0, 15.0, 0.0));
        let wall = scene.add_material(Material::matte("wall", Rgb::WHITE));
        scene.add(Shape::from(mesh), wall);
        let mut stage = Stage::of(scene);
        // From below the wall; its middle way crosses the inside of a face.
        stage.camera.eye = vec3(0.0, 4.0, 0.0);
        let block = stage.block(0.13, 0.33);
        let floor = stage.scene.primitives.iter().position(|p| p.bounds().is_none()).unwrap();
        let t = block.distance(&stage.scene.primitives[floor], Start::Elsewhere);
        let patch = Patch::at(&stage.scene, &block.ray, floor as u32, t).unwrap();
        let light = &stage.scene.lights[0];
        let ways = patch.ways_to(light);
        let candidates = Candidates::new(&stage.scene);
        let shaft = shaft_of(&candidates, &patch, light, &ways).unwrap();
        let ids: Vec<u32> =
            (0..stage.scene.primitives.len() as u32).filter(|id| *id != floor as u32).collect();
        is_screened(&stage.scene, &ids, &shaft, &patch, light, &ways)
    };
    let whole = wall(24);
    assert!(screened(whole.clone()));
    // One that the shaft crosses.
    let mut with_a_hole = whole;
    with_a_hole.triangles.remove(2 * (12 * 24 + 13));
    assert!(!screened(with_a_hole));
}

/// A step: rays that leave the lower face pass its side wall only if that stands behind an edge.
#[test]
fn rays_that_leave_a_face_clear_of_its_edges_never_meet_what_lies_below_and_beside_it() {
    let mut scene = floor_scene(vec3(3.0, 10.0, 0.0));
    let white = scene.add_material(Material::matte("white", Rgb::WHITE));
    let face = |corners: [Vec3; 4]| Shape::Polygon { outline: corners.to_vec(), holes: Vec::new() };
    let [a, b, c, d] =
        [vec3(-1.0, 1.0, 1.0), vec3(1.0, 1.0, 1.0), vec3(1.0, 1.0, -1.0), vec3(-1.0, 1.0, -1.0)];
    let down = vec3(0.0, -1.0, 0.0);
    scene.add(face([a, b, c, d]), white);
    // The side below its right edge, the same side standing over it, and one that leans in over the face.
    scene.add(face([b, b + down, c + down, c]), white);
    scene.add(face([b - down, b, c, c - down]), white);
    scene.add(face([b, c, vec3(0.2, 1.6, -1.0), vec3(0.2, 1.6, 1.0)]), white);
    let stage = Stage::of(scene);
    let block = stage.block(-0.5, 0.0);
    let patch = stage.patch(&block);
    let clear = Clear::of(&stage.scene, &patch, &block.ray, stage.camera.eye).unwrap();
    let ways = patch.ways_to(&stage.scene.lights[0]);
    let leaving = clear.leaving(&ways.towards).unwrap();
    let never = |place: Vec3| {
        let is_it = |id: &usize| {
            let (plane, corners) = stage.scene.primitives[*id].flat()?;
            let middle =
                corners.iter().fold(Vec3::ZERO, |sum, p| sum + *p) * (1.0 / corners.len().max(1) as f64);
            ((middle - place).length() < 1e-9 && plane.normal.length() > 0.0).then_some(())
        };
        let id = (0..stage.scene.primitives.len()).find(|id| is_it(id).is_some()).unwrap();
        leaving.never_meets(&stage.scene.primitives[id])
    };
    assert!(never(vec3(1.0, 0.5, 0.0)), "the side below");
    assert!(!never(vec3(0.6, 1.3, 0.0)), "what leans over it");
    // Along the face nothing is known.
    assert!(clear.leaving(&vec3(1.0, 1e-3, 0.0).lift()).is_none());
}

#[test]
fn a_square_of_a_checker_is_one_colour_and_its_border_is_none() {
    let mut scene = floor_scene(vec3(0.0, 10.0, 0.0));
    let black = rgb(0.0, 0.0, 0.0);
    scene.materials[0].checker = Some(Checker { color: black, size: 1.0, axis: Axis::Y });
    let stage = Stage::of(scene);
    let color = |x: f64| {
        let patch = stage.patch(&stage.block(x, 0.5));
        cell_color(patch.material, &patch.point)
    };
    assert_eq!([color(0.5), color(1.5)], [Some(Rgb::WHITE), Some(black)]);
    assert_eq!(color(1.0), None);
}
