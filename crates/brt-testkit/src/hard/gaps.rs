//! Faces a billionth of the scene apart, where coordinates are as coarse: some become one, some do not, and others pass between
//! them.

use brt_geometry::{Vec3, vec3};
use brt_image::Rgb;
use brt_scene::{Camera, Light, Mesh, Projection, Scene, Shape};

use super::{Choices, add, materials};

/// How far away faces as far apart as these begin to be one: lengths in sizes of the scene.
pub(super) const OFFSETS: [f64; 2] = [5.5, 7.5];

/// A large face, a small one in the middle just off its plane, and some that lean through the gap; seen from above.
pub(super) fn gaps(choices: &mut Choices) -> Scene {
    let gap = choices.magnitude(-9.0, -7.0);
    let width = if choices.one_in(4) { choices.magnitude(-4.0, 0.5) } else { choices.magnitude(-6.0, -4.0) };
    let mut scene = seen_from_above(choices, width);
    let large = corner_points(2.0).map(|p| p + vec3(choices.pick(&[-3.0, 0.0]), 0.0, 0.0));
    add_face(choices, &mut scene, large);
    let size = choices.magnitude(-4.0, 0.0);
    let side = choices.pick(&[1.0, -1.0, 0.0]);
    add_face(choices, &mut scene, corner_points(size).map(|p| p + vec3(0.0, side * gap, 0.0)));
    for _ in 0..=choices.below(2) {
        // Through the gap, or falling from the small one's edge.
        let (falls, slope, size) =
            (choices.one_in(2), gap / width * choices.magnitude(-1.0, 1.0), choices.magnitude(-2.0, 0.5));
        let middle = if falls { side * gap } else { gap * choices.between(-1.0, 1.0) };
        let from = if falls { size } else { 0.5 * size };
        let leaning = corner_points(size).map(|p| vec3(p.x + from, middle - slope * p.x, p.z));
        add_face(choices, &mut scene, leaning);
    }
    scene
}

fn corner_points(size: f64) -> [Vec3; 3] {
    [vec3(0.0, 0.0, -size), vec3(-size, 0.0, 0.0), vec3(0.0, 0.0, size)]
}

/// A triangle, half of the time smooth.
fn add_face(choices: &mut Choices, scene: &mut Scene, corners: [Vec3; 3]) {
    let mut material = materials::opaque(choices);
    material.casts_shadow &= !choices.one_in(3);
    let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).try_normalize();
    let normals = normal.filter(|_| choices.one_in(2)).map_or_else(Vec::new, |n| vec![n; 3]);
    let mesh = Mesh { positions: corners.to_vec(), normals, triangles: vec![[0, 1, 2]], ..Mesh::default() };
    add(scene, Shape::from(mesh), material);
}

/// From far above or right above, a gap or a unit wide; lit from above, or from the side.
fn seen_from_above(choices: &mut Choices, width: f64) -> Scene {
    let height = if choices.one_in(2) { choices.magnitude(-3.0, -2.0) } else { choices.magnitude(-2.0, 0.7) };
    let projection = if choices.one_in(2) {
        Projection::Orthographic { extent: width }
    } else {
        Projection::Perspective { fov_deg: 2.0 * libm::atan(0.5 * width / height).to_degrees() }
    };
    let look_at = vec3(choices.coordinate(0.3 * width), 0.0, choices.coordinate(0.3 * width));
    let camera =
        Camera { eye: look_at + vec3(0.0, height, 0.0), look_at, up: vec3(0.3, 0.0, 0.8), projection };
    let mut scene = Scene::new(camera);
    let direction = vec3(-1.0, -choices.magnitude(-2.0, 2.0), choices.coordinate(0.1));
    scene.lights.push(Light::Directional { direction, color: Rgb::WHITE * choices.pick(&[1.0, 20.0]) });
    scene
}
