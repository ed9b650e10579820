//! Things that lie upon each other: twice the same, touching, or overlapping in one plane.

use brt_geometry::{Vec3, vec3};
use brt_scene::{Camera, Mesh, Object, Projection, Scene, Shape};

use super::{Choices, add, far, materials, things};

/// A few things and what coincides with each.
pub(super) fn coincident(choices: &mut Choices) -> Scene {
    let mut scene = viewed(choices);
    for _ in 0..=choices.below(3) {
        let material = materials::any(choices);
        let (shapes, count) = (touching(choices), scene.objects.len());
        for shape in shapes {
            let material =
                if scene.objects.len() > count { materials::any(choices) } else { material.clone() };
            add(&mut scene, shape, material);
        }
    }
    for _ in 0..=choices.below(2) {
        far::add_light(choices, &mut scene);
    }
    scene
}

/// Opaque things, and the same scene with some of their faces given once more at the end, of either sense.
pub(super) fn doubled(choices: &mut Choices) -> [Scene; 2] {
    let mut once = viewed(choices);
    for _ in 0..=choices.below(3) {
        let material = materials::opaque(choices);
        let shape = if choices.one_in(4) { cornered(choices) } else { anywhere(choices) };
        add(&mut once, shape, material);
    }
    far::add_light(choices, &mut once);
    let mut twice = once.clone();
    let count = once.objects.len();
    for _ in 0..=choices.below(2) {
        let object = &once.objects[choices.below(count)];
        twice.objects.push(Object::new(again(choices, &object.shape), object.material));
    }
    [once, twice]
}

fn anywhere(choices: &mut Choices) -> Shape {
    let center = choices.point(1.0);
    things::any(choices, center, 0.7)
}

/// A box that has a corner at the origin, as many programs make them.
fn cornered(choices: &mut Choices) -> Shape {
    let half = vec3(0.5, choices.pick(&[0.5, 0.3, 0.01]), 0.25);
    things::cuboid(half, half)
}

/// Seen from a few units away.
fn viewed(choices: &mut Choices) -> Scene {
    let eye = choices.direction() * 4.0 + choices.point(1.0);
    let projection = Projection::Perspective { fov_deg: choices.pick(&[40.0, 90.0, 5.0]) };
    let up = vec3(0.3, 0.5, 0.8);
    Scene::new(Camera { eye, look_at: choices.point(0.5), up, projection })
}

/// The same points once more: as they are, or facing the other way.
fn again(choices: &mut Choices, shape: &Shape) -> Shape {
    let mut shape = shape.clone();
    let is_turned = choices.one_in(2);
    match &mut shape {
        Shape::Polygon { outline, holes } => {
            let first = choices.below(outline.len());
            outline.rotate_left(first);
            if is_turned {
                outline.reverse();
                holes.iter_mut().for_each(|hole| hole.reverse());
            }
        }
        Shape::Disc { normal, .. } if is_turned => *normal = -*normal,
        Shape::Plane { normal, distance } if is_turned => (*normal, *distance) = (-*normal, -*distance),
        Shape::Mesh(mesh) if is_turned => {
            let mesh: &mut Mesh = std::sync::Arc::make_mut(mesh);
            mesh.triangles.iter_mut().for_each(|triangle| triangle.swap(1, 2));
            mesh.normals.iter_mut().for_each(|normal| *normal = -*normal);
        }
        Shape::Cylinder { base, top, .. } if is_turned => std::mem::swap(base, top),
        Shape::Cone { base, base_radius, top, top_radius, .. } if is_turned => {
            std::mem::swap(base, top);
            std::mem::swap(base_radius, top_radius);
        }
        _ => {}
    }
    shape
}

/// Shapes that have points of their surfaces in common.
fn touching(choices: &mut Choices) -> Vec<Shape> {
    let center = choices.point(1.0);
    let step = choices.pick(&[0.5, 1.0, 0.25]);
    let along = vec3(choices.pick(&[1.0, 0.0, 0.5]), choices.pick(&[0.0, 1.0]), 0.0) * step;
    let pair = |shape: fn(Vec3) -> Shape| vec![shape(center), shape(center + along)];
    match choices.below(11) {
        // The same once more.
        0 => {
            let shape = things::any(choices, center, 0.7);
            vec![again(choices, &shape), shape]
        }
        // Boxes side by side or through each other.
        1 => pair(|center| things::cuboid(center, Vec3::splat(0.5))),
        // One inside of the other, on one floor.
        2 => {
            let small = things::cuboid(center + vec3(0.25, -0.25, 0.0), Vec3::splat(0.25));
            vec![things::cuboid(center, Vec3::splat(0.5)), small]
        }
        // Faces and discs in one plane.
        3 => pair(square),
        4 => pair(|center| Shape::Disc { center, normal: vec3(0.0, 1.0, 0.0), radius: 0.6 }),
        // A box on a plane that is given twice.
        5 => {
            let (normal, distance) = (vec3(0.0, 1.0, 0.0), center.y - 0.5);
            let turned = Shape::Plane { normal: -normal * 2.0, distance: -distance * 2.0 };
            vec![Shape::Plane { normal, distance }, turned, things::cuboid(center, Vec3::splat(0.5))]
        }
        // Balls that touch, or overlap.
        6 => pair(|center| Shape::Sphere { center, radius: 0.5 }),
        // Cylinders end to end, the upper one at times narrower.
        7 => {
            let radius = choices.pick(&[0.4, 0.3]);
            let (base, top) = (center - vec3(0.0, 0.6, 0.0), center + vec3(0.0, 0.6, 0.0));
            vec![
                Shape::Cylinder { base, top: center, radius: 0.4, capped: true },
                Shape::Cylinder { base: center, top, radius, capped: true },
            ]
        }
        // Boxes with corners at the origin, the one on the other.
        8 => {
            let (below, above) = (cornered(choices), cornered(choices));
            vec![below, above]
        }
        // Two solids that touch, in one mesh.
        9 => vec![joined(&[center, center + along].map(|center| things::cuboid(center, Vec3::splat(0.5))))],
        // A lens: a ball cut by a box's face, and a disc where they meet.
        _ => {
            let disc = Shape::Disc { center, normal: choices.direction(), radius: 0.5 };
            vec![Shape::Sphere { center, radius: 0.5 }, disc]
        }
    }
}

/// Meshes as one.
fn joined(shapes: &[Shape]) -> Shape {
    let mut all = Mesh::default();
    for shape in shapes {
        let Shape::Mesh(mesh) = shape else { continue };
        let first = all.positions.len() as u32;
        all.positions.extend(&mesh.positions);
        all.triangles.extend(mesh.triangles.iter().map(|corners| corners.map(|i| first + i)));
    }
    Shape::from(all)
}

fn square(center: Vec3) -> Shape {
    let corner = |x: f64, z: f64| center + vec3(x, 0.0, z);
    let outline = vec![corner(-0.5, 0.5), corner(0.5, 0.5), corner(0.5, -0.5), corner(-0.5, -0.5)];
    Shape::Polygon { outline, holes: Vec::new() }
}
