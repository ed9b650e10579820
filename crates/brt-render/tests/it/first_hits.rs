//! The perspective image shows on every sample what a ray would meet first. Paper: P3.
//!
//! Here first hits are found by plain search over primitives built by hand, so that neither the renderer's flattening
//! nor its tracer takes part. That histories of known and of searched first hits agree on random scenes is asserted in
//! `exact_methods.rs`.

use brt_geometry::{Disc, Plane, Primitive, Sphere, Start, Triangle, Vec3, vec3};
use brt_image::Rgb;
use brt_render::{Layer, PreparedCamera, Run, SampleGrid, Samples, Settings};
use brt_scene::{Camera, Material, Mesh, Projection, Scene, Shape};
use brt_testkit::{Random, first_difference, looking, render_at_levels};

/// A scene and the primitive of each object.
struct Hand {
    scene: Scene,
    primitives: Vec<Primitive>,
}

impl Hand {
    fn new(camera: Camera) -> Self {
        let mut scene = Scene::new(camera);
        scene.add_material(Material::matte("m", Rgb::WHITE));
        Self { scene, primitives: Vec::new() }
    }

    fn add(&mut self, shape: Shape, primitive: Primitive) {
        self.scene.add(shape, brt_scene::MaterialId(0));
        self.primitives.push(primitive);
    }

    fn add_random(&mut self, random: &mut Random) {
        let center = random.point(3.0);
        match random.below(4) {
            0 => self.add_sphere(center, random.magnitude(-3.0, 0.2)),
            1 => {
                let (normal, radius) = (random.direction(), random.between(0.1, 1.5));
                let disc = Disc::new(center, normal, radius);
                self.add(Shape::Disc { center, normal, radius }, Primitive::Disc(disc));
            }
            2 => {
                let (normal, distance) = (random.direction(), random.between(-6.0, -2.0));
                let plane = Plane::new(normal, distance);
                self.add(Shape::Plane { normal, distance }, Primitive::Plane(plane));
            }
            _ => {
                let corners = [center, center + random.point(1.0), center + random.point(1.0)];
                let mesh =
                    Mesh { positions: corners.to_vec(), triangles: vec![[0, 1, 2]], ..Mesh::default() };
                if let Some(triangle) = Triangle::new(corners) {
                    self.add(Shape::from(mesh), Primitive::Triangle(triangle));
                }
            }
        }
    }

    fn add_sphere(&mut self, center: Vec3, radius: f64) {
        self.add(Shape::Sphere { center, radius }, Primitive::Sphere(Sphere { center, radius }));
    }

    fn first_hit(&self, camera: &PreparedCamera, x: u32, y: u32) -> (u32, f32) {
        let ray = camera.ray(f64::from(x), f64::from(y));
        let mut nearest = (u32::MAX, f64::INFINITY);
        for (id, primitive) in (0..).zip(&self.primitives) {
            let hit = primitive.first_hit(&ray, Start::Elsewhere);
            if hit.found && hit.t < nearest.1 {
                nearest = (id, hit.t);
            }
        }
        (nearest.0, nearest.1 as f32)
    }

    fn assert_image_is_right(&self, size: [u32; 2], what: &str) {
        assert_eq!(self.scene.check(), [], "{what}");
        let layers = vec![Layer::Surface, Layer::Depth];
        let settings = Settings { layers, max_depth: Some(0), ..Settings::new(size) };
        let picture = render_at_levels(&self.scene, &settings, &Run { threads: 1, ..Run::default() });
        let camera =
            PreparedCamera::new(&self.scene.camera, Vec3::ZERO, &SampleGrid::new(size, Samples::One));
        let all = (0..size[0] * size[1]).map(|i| self.first_hit(&camera, i % size[0], i / size[0]));
        let (surface, depth): (Vec<u32>, Vec<f32>) = all.unzip();
        let difference = first_difference(size, &surface, &picture.surface)
            .or_else(|| first_difference(size, &depth, &picture.depth));
        assert!(difference.is_none(), "{what}: {}", difference.map(|d| d.to_string()).unwrap_or_default());
    }
}

fn any_camera(random: &mut Random) -> Camera {
    let projection = if random.one_in(4) {
        Projection::Orthographic { extent: random.between(0.5, 9.0) }
    } else {
        Projection::Perspective { fov_deg: random.between(5.0, 150.0) }
    };
    Camera { eye: random.point(6.0), look_at: random.point(1.0), up: vec3(0.1, 1.0, 0.2), projection }
}

#[test]
fn every_sample_shows_the_first_hit_of_its_ray() {
    let mut random = Random::new(3);
    for case in 0..400 {
        let mut hand = Hand::new(any_camera(&mut random));
        (0..=random.below(25)).for_each(|_| hand.add_random(&mut random));
        let size = [1 + random.below(60), 1 + random.below(60)];
        hand.assert_image_is_right(size, &format!("case {case}"));
    }
}

#[test]
fn hundreds_of_balls_smaller_than_a_sample_are_where_rays_meet_them() {
    let mut random = Random::new(4);
    let mut hand = Hand::new(looking([0.0, 0.0, 8.0], [0.0, 0.0, 0.0], 50.0));
    (0..3000).for_each(|_| hand.add_sphere(random.point(3.0), random.magnitude(-3.0, -1.0)));
    hand.assert_image_is_right([300, 260], "balls");
}

#[test]
fn of_two_surfaces_at_one_distance_the_earlier_object_is_seen() {
    let mut hand = Hand::new(looking([0.3, 0.2, 5.0], [0.0, 0.0, 0.0], 40.0));
    let normal = vec3(0.0, 0.0, 1.0);
    for (x, radius) in [(0.0, 1.0), (0.7, 1.0), (-0.5, 1.5)] {
        let center = vec3(x, 0.0, 0.25);
        hand.add(Shape::Disc { center, normal, radius }, Primitive::Disc(Disc::new(center, normal, radius)));
    }
    let plane = Plane::new(normal, 0.25);
    hand.add(Shape::Plane { normal, distance: 0.25 }, Primitive::Plane(plane));
    hand.assert_image_is_right([97, 64], "discs in one plane");
}

#[test]
fn the_eye_inside_and_on_balls_sees_what_its_rays_meet() {
    for offset in [0.0, 0.5, 0.999_999, 1.0, 1.000_001] {
        let mut hand = Hand::new(looking([offset, 0.0, 0.0], [2.0, 0.3, 0.1], 120.0));
        hand.add_sphere(Vec3::ZERO, 1.0);
        hand.add_sphere(vec3(3.0, 0.0, 0.0), 1.2);
        hand.assert_image_is_right([75, 60], &format!("eye {offset} from the middle"));
    }
}

/// Edges, common edges and depths so that forms of whole tiles cannot decide, and rays must.
#[test]
fn edges_and_equal_depths_through_the_middles_of_samples_are_decided_as_by_rays() {
    const SIDE: u32 = 64;
    let mut hand = Hand::new(looking([0.0, 0.0, 0.0], [0.0, 0.0, -1.0], 90.0));
    // Samples lie at odd coordinates on the plane at this depth.
    let depth = -f64::from(SIDE);
    let mut add = |corners: [[f64; 2]; 3], z: f64| {
        let corners = corners.map(|[x, y]| vec3(x, y, z));
        let mesh = Mesh { positions: corners.to_vec(), triangles: vec![[0, 1, 2]], ..Mesh::default() };
        let triangle = Triangle::new(corners).unwrap();
        hand.add(Shape::from(mesh), Primitive::Triangle(triangle));
    };
    for cell in 0..9 {
        let [x, y] = [cell % 3, cell / 3].map(|i| f64::from(20 * i - 31));
        // Two halves of a square whose sides and diagonal go through samples, and both once more.
        for _ in 0..2 {
            add([[x, y], [x + 20.0, y], [x + 20.0, y + 20.0]], depth);
            add([[x, y], [x + 20.0, y + 20.0], [x, y + 20.0]], depth);
        }
    }
    // One that cuts through them along a column of samples.
    let corners =
        [vec3(1.0, -90.0, 0.0), vec3(1.0, 90.0, 0.0), vec3(0.0, 0.0, 2.0)].map(|c| c + vec3(0.0, 0.0, depth));
    let mesh = Mesh { positions: corners.to_vec(), triangles: vec![[0, 1, 2]], ..Mesh::default() };
    hand.add(Shape::from(mesh), Primitive::Triangle(Triangle::new(corners).unwrap()));
    // And a ball that touches the plane in the middle of a sample.
    hand.add_sphere(vec3(-11.0, -11.0, depth - 4.0), 4.0);
    hand.assert_image_is_right([SIDE, SIDE], "edges through samples");
}
