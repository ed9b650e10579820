//! Cones and cylinders up to a million times as long as they are wide, whole or in sections, seen from near one of their ends.

use brt_geometry::{Vec3, vec3};
use brt_scene::{Camera, Projection, Scene, Shape};

use super::{Choices, add, far, materials, things};

/// A few of them on one axis or near it, which ends about the origin.
pub(super) fn long(choices: &mut Choices) -> Scene {
    let (axis, length) = (choices.direction(), choices.magnitude(0.0, 6.0));
    let distance = length * choices.magnitude(-7.0, 0.5);
    let eye = choices.direction() * distance;
    let look_at = if choices.one_in(2) { Vec3::ZERO } else { choices.direction() * (0.05 * distance) };
    let projection = Projection::Perspective { fov_deg: choices.pick(&[1.0, 40.0, 5.0, 0.1]) };
    let mut scene = Scene::new(Camera { eye, look_at, up: vec3(0.31, 0.5, 0.77), projection });
    for _ in 0..=choices.below(3) {
        let shape = match choices.below(5) {
            0..=2 => section(choices, axis * -length),
            3 => {
                Shape::Plane { normal: choices.direction(), distance: -length * choices.magnitude(-3.0, 0.0) }
            }
            _ => {
                let radius = distance * choices.magnitude(-2.0, 0.0);
                things::any(choices, Vec3::ZERO, radius)
            }
        };
        let material = materials::any(choices);
        add(&mut scene, shape, material);
    }
    for _ in 0..=choices.below(2) {
        far::add_light(choices, &mut scene);
    }
    scene
}

/// A part of a needle from a far end to the origin.
fn section(choices: &mut Choices, far_end: Vec3) -> Shape {
    let radius = far_end.length() * choices.magnitude(-9.0, -1.0);
    let begin = choices.pick(&[0.0, 0.5, 0.9, 0.999, 1.0 - 1e-6]);
    let end = choices.pick(&[1.0, 1.0, 1.0, 0.999_999_9]);
    let at = |share: f64| far_end * (1.0 - share);
    let (base, top, capped) = (at(begin), at(end), choices.one_in(2));
    if choices.one_in(3) {
        return Shape::Cylinder { base, top, radius, capped };
    }
    let tip = choices.pick(&[0.0, 0.0, 0.3]);
    let [base_radius, top_radius] = [begin, end].map(|share| radius * (1.0 - share + share * tip));
    Shape::Cone { base, base_radius, top, top_radius, capped }
}
