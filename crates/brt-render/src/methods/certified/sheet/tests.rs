//! What is proven of sheets, on some where it holds and on others where it does not.

use brt_geometry::{Start, Vec3, vec3};
use brt_image::Rgb;
use brt_scene::{Light, Material, Mesh, Projection, Scene, Shape};
use brt_testkit::{Random, looking};

use super::*;
use crate::margins::LEAST_RISE;
use crate::methods::certified::candidates::Candidates;
use crate::prepare::{PreparedCamera, prepare};
use crate::products::SampleGrid;
use crate::run::Cancel;
use crate::settings::{Accelerator, Samples};
use crate::tracing::Interaction;

/// Triangles of a landscape lie this far apart.
const STEP: f64 = 0.25;

/// A smooth landscape under a camera above the origin, 0.1 units to a sample: sample 32, 32 is in the middle.
struct Stage {
    scene: PreparedScene,
    camera: PreparedCamera,
}

/// A height over each place, and the normal there.
type Landscape<'l> = &'l dyn Fn(f64, f64) -> (f64, Vec3);

/// A landscape of `2 half` by `2 half` units.
fn mesh_of(landscape: Landscape, half: f64) -> Mesh {
    let side = (2.0 * half / STEP) as u32;
    let mut mesh = Mesh::default();
    for (i, j) in (0..=side).flat_map(|i| (0..=side).map(move |j| (i, j))) {
        let [x, z] = [i, j].map(|i| f64::from(i) * STEP - half);
        let (height, normal) = landscape(x, z);
        mesh.positions.push(vec3(x, height, z));
        mesh.normals.push(normal);
    }
    let at = |i: u32, j: u32| i * (side + 1) + j;
    for (i, j) in (0..side).flat_map(|i| (0..side).map(move |j| (i, j))) {
        mesh.triangles.push([at(i, j), at(i, j + 1), at(i + 1, j + 1)]);
        mesh.triangles.push([at(i, j), at(i + 1, j + 1), at(i + 1, j)]);
    }
    mesh
}

/// A hill, or a hollow where it is steep the other way: y = −k (x² + z²) / 2.
fn bowl(k: f64) -> impl Fn(f64, f64) -> (f64, Vec3) {
    move |x, z| (-0.5 * k * (x * x + z * z), vec3(k * x, 1.0, k * z))
}

fn scene_of(landscape: Landscape, light: Vec3) -> Scene {
    let mut camera = looking([0.0, 20.0, 0.0], [0.0; 3], 0.0);
    camera.up = vec3(0.0, 0.0, -1.0);
    camera.projection = Projection::Orthographic { extent: 6.4 };
    let mut scene = Scene::new(camera);
    scene.lights.push(Light::Point { position: light, color: Rgb::WHITE });
    let earth = scene.add_material(Material::matte("earth", Rgb::WHITE));
    scene.add(Shape::from(mesh_of(landscape, 2.0)), earth);
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

    /// What a sample shows, and how far away.
    fn shown(&self, sample: [u32; 2]) -> Option<(u32, f64)> {
        let ray = self.camera.sample_ray(sample);
        let hits = self.scene.primitives.iter().map(|primitive| primitive.first_hit(&ray, Start::Elsewhere));
        let found = (0_u32..).zip(hits).filter(|(_, hit)| hit.found).map(|(id, hit)| (id, hit.t));
        found.min_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// The triangles that an area shows.
    fn facets(&self, area: Area) -> Option<Facets> {
        let samples = (area.y0..area.y1).flat_map(|y| (area.x0..area.x1).map(move |x| [x, y]));
        let mut ids: Vec<u32> = samples.map(|sample| self.shown(sample).unwrap().0).collect();
        ids.sort_unstable();
        ids.dedup();
        Facets::new(&self.scene, &self.camera, area, &ids)
    }

    /// How eight by eight samples around a place see the light.
    fn lights(&self, x: f64, z: f64) -> Option<LightsOfSheet> {
        let area = around(x, z);
        let facets = self.facets(area)?;
        let patch = fitted(&self.scene, &self.camera, area, &facets, &facets.all)?;
        let light = &self.scene.lights[0];
        light_of_sheet(&mut Candidates::new(&self.scene), &facets, &patch, light, &patch.ways_to(light))
    }
}

/// Eight by eight samples around a place.
fn around(x: f64, z: f64) -> Area {
    let [x0, y0] = [x, z].map(|place| (32.0 + 10.0 * place) as u32 - 4);
    Area { x0, y0, x1: x0 + 8, y1: y0 + 8 }
}

/// Does a model hold a value, at a place between −1 and 1?
fn holds(model: Taylor, [u, v]: [f64; 2], value: f64) -> bool {
    (model.c + model.u * u + model.v * v - value).abs() <= model.e
}

#[test]
fn one_plane_and_one_normal_stand_for_all_points_of_a_sheet() {
    let mut random = Random::new(1);
    let mut checked = 0;
    for _ in 0..60 {
        let k = random.magnitude(-4.0, -0.5) * if random.one_in(2) { 1.0 } else { -1.0 };
        let stage = Stage::of(scene_of(&bowl(k), vec3(0.0, 10.0, 0.0)));
        let area = around(random.between(-1.4, 1.4), random.between(-1.4, 1.4));
        let Some(facets) = stage.facets(area) else { continue };
        let patch = fitted(&stage.scene, &stage.camera, area, &facets, &facets.all).unwrap();
        let ([x, y], [half_x, half_y]) = (area.middle(), area.half_sides(&stage.camera.pattern));
        for sample in (area.y0..area.y1).flat_map(|y| (area.x0..area.x1).map(move |x| [x, y])) {
            let (id, t) = stage.shown(sample).unwrap();
            let met = Interaction::at(&stage.scene, &stage.camera.sample_ray(sample), id, t);
            let place = [(f64::from(sample[0]) - x) / half_x, (f64::from(sample[1]) - y) / half_y];
            let (point, normal) = (met.point, met.normal);
            let of = |p: Vec3| [p.x, p.y, p.z];
            let models =
                [patch.point.x, patch.point.y, patch.point.z, patch.normal.x, patch.normal.y, patch.normal.z];
            for (model, value) in models.into_iter().zip([of(point), of(normal)].concat()) {
                assert!(holds(model, place, value), "k = {k}: {model:?} at {place:?} is not {value}");
            }
            checked += 1;
        }
        // And not by being wide: heights bend by k/2 of a square within the block, and between corners by a step's. Weights
        // of corners round by some 10⁻⁸.
        assert!(patch.point.y.e <= k.abs() * (0.5 + STEP) * (0.5 + STEP) + 1e-9, "{k}: {:?}", patch.point.y);
        assert!(patch.normal.x.e <= 2.0 * k * k + 1e-7, "{k}: {:?}", patch.normal.x);
    }
    assert!(checked > 2000, "{checked}");
}

#[test]
fn triangles_that_are_seen_along_themselves_make_no_sheet() {
    let ramp = |slope: f64| move |x: f64, _: f64| (slope * x, vec3(-slope, 1.0, 0.0));
    let is_sheet = |slope: f64| {
        let stage = Stage::of(scene_of(&ramp(slope), vec3(0.0, 10.0, 0.0)));
        stage.facets(around(0.0, 0.0)).is_some()
    };
    assert!(is_sheet(0.9 / LEAST_RISE));
    assert!(!is_sheet(1.1 / LEAST_RISE));
    // Normals on the other side of some corners than of others are not what shades in between.
    let mut scene = scene_of(&bowl(0.1), vec3(0.0, 10.0, 0.0));
    let mut mesh = mesh_of(&bowl(0.1), 2.0);
    let middle = mesh.normals.len() / 2;
    mesh.normals[middle] = -mesh.normals[middle];
    scene.objects[0].shape = Shape::from(mesh);
    assert!(Stage::of(scene).facets(around(0.0, 0.0)).is_none());
}

#[test]
fn samples_are_filled_inside_of_a_triangle_but_not_at_its_edges() {
    let stage = Stage::of(scene_of(&bowl(0.1), vec3(0.0, 10.0, 0.0)));
    let facets = stage.facets(around(0.0, 0.0)).unwrap();
    for facet in &facets.all {
        let [a, b, c] = facet.triangle.corners;
        let is_met = |p: Vec3| {
            let ray = brt_geometry::Ray::new(p + vec3(0.0, 1.0, 0.0), vec3(0.0, -1.0, 0.0));
            facet.is_met_inside(&ray, facets.clearance)
        };
        let middle = (a + b + c) * (1.0 / 3.0);
        assert!(is_met(middle));
        for (from, to) in [(a, b), (b, c), (c, a)] {
            let edge = (from + to) * 0.5;
            let inwards = (middle - edge).normalize();
            assert!(is_met(edge + inwards * (3.0 * facets.clearance)));
            assert!(!is_met(edge + inwards * (0.2 * facets.clearance)));
            assert!(!is_met(edge - inwards * (3.0 * facets.clearance)));
        }
    }
}

#[test]
fn a_hill_sees_a_lamp_over_it_though_its_triangles_reach_into_each_others_shafts() {
    let stage = Stage::of(scene_of(&bowl(0.2), vec3(3.0, 6.0, 0.0)));
    assert_eq!(stage.lights(0.0, 0.0), Some(LightsOfSheet::Seen));
    assert_eq!(stage.lights(1.0, -1.0), Some(LightsOfSheet::Seen));
    // So does a hollow that is as flat.
    let stage = Stage::of(scene_of(&bowl(-0.2), vec3(3.0, 6.0, 0.0)));
    assert_eq!(stage.lights(0.0, 0.0), Some(LightsOfSheet::Seen));
}

#[test]
fn what_turns_away_from_a_lamp_does_not_see_it() {
    let stage = Stage::of(scene_of(&bowl(1.0), vec3(9.0, 0.0, 0.0)));
    assert_eq!(stage.lights(-1.4, 0.0), Some(LightsOfSheet::Hidden));
    assert_eq!(stage.lights(1.4, 0.0), Some(LightsOfSheet::Seen));
    // Next to the top some points see it and others do not.
    assert_eq!(stage.lights(0.0, 0.0), None);
}

/// A floor with a wall along x = 0.5, as high as one unit: light from beyond is hidden at its foot.
#[test]
fn the_shadow_of_a_step_in_a_sheet_ends_where_light_passes_over_it() {
    let step = |x: f64, _: f64| {
        let height = ((x - 0.5) / STEP).clamp(0.0, 1.0);
        (height, vec3(-0.1, 1.0, 0.0))
    };
    // Over the step's edge light falls 1 unit in 1: the shadow ends at x = −0.25, and from there on all is lit.
    let stage = Stage::of(scene_of(&step, vec3(10.75, 11.0, 0.0)));
    assert_eq!(stage.lights(-1.2, 0.0), Some(LightsOfSheet::Seen));
    assert_eq!(stage.lights(-0.25, 0.0), None);
    // A ball in the way leaves its shadow's border open, too.
    let mut scene = scene_of(&bowl(0.1), vec3(0.0, 10.0, 0.0));
    let earth = scene.objects[0].material;
    scene.add(Shape::Sphere { center: vec3(0.0, 9.0, 0.0), radius: 0.1 }, earth);
    let stage = Stage::of(scene);
    assert_eq!(stage.lights(1.0, 0.0), None);
    assert_eq!(stage.lights(-1.5, -1.5), Some(LightsOfSheet::Seen));
}
