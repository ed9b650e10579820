//! Small things seen from far away: straight, in a mirror, or by the shadow they throw.

use brt_geometry::{Vec3, vec3};
use brt_image::{Rgb, rgb};
use brt_scene::{Camera, Light, Projection, Scene, Shape};

use super::{Choices, add, materials, things};

/// A ball that the picture shows, from where the eye stands.
struct Target {
    center: Vec3,
    radius: f64,
}

/// From `eye` at a target, which is as large as the picture or a few times smaller, and off its middle.
fn aim(choices: &mut Choices, eye: Vec3, target: &Target) -> Camera {
    let distance = (target.center - eye).length();
    let width = target.radius * choices.pick(&[4.0, 2.0, 10.0, 40.0, 0.5]);
    let look_at = target.center + choices.point(0.5 * width);
    let projection = if choices.one_in(8) {
        Projection::Orthographic { extent: width }
    } else {
        Projection::Perspective { fov_deg: 2.0 * libm::atan(0.5 * width / distance).to_degrees() }
    };
    let up = choices.pick(&[vec3(0.3, 0.5, 0.8), vec3(0.0, 1.0, 0.0), vec3(0.0, 0.0, 1.0)]);
    Camera { eye, look_at, up, projection }
}

/// How far away: near, or up to a million units.
fn distance(choices: &mut Choices) -> f64 {
    if choices.one_in(4) { choices.magnitude(0.0, 1.0) } else { choices.magnitude(1.0, 6.0) }
}

/// A size for something that is looked at over a distance: down to a billionth of it.
fn size(choices: &mut Choices, distance: f64) -> f64 {
    distance * choices.magnitude(-9.0, -1.0)
}

/// Some more things, about one unit large, around the origin; none half of the time.
fn add_company(choices: &mut Choices, scene: &mut Scene) {
    for _ in 0..choices.pick(&[0, 0, 1, 4]) {
        let (center, radius) = (choices.point(1.0), choices.pick(&[0.01, 0.1, 0.5]));
        let (shape, material) = (things::any(choices, center, radius), materials::any(choices));
        add(scene, shape, material);
    }
}

/// Something small seen straight.
pub(super) fn tiny(choices: &mut Choices) -> Scene {
    let distance = distance(choices);
    let target = Target { center: choices.point(1.0), radius: size(choices, distance) };
    let eye = choices.direction() * distance + choices.point(1.0);
    let mut scene = Scene::new(aim(choices, eye, &target));
    if choices.one_in(3) {
        // A veil before the eye: rays go on from there, and lose what they know of the distance.
        let normal = (eye - target.center).try_normalize().unwrap_or(vec3(0.0, 1.0, 0.0));
        let plane = Shape::Plane { normal, distance: normal.dot(eye) - 0.001 * distance };
        let veil = brt_scene::Material { opacity: 0.2, ..materials::plain(Rgb::BLACK) };
        add(&mut scene, plane, veil);
    }
    let (shape, material) = (things::any(choices, target.center, target.radius), materials::any(choices));
    add(&mut scene, shape, material);
    add_company(choices, &mut scene);
    add_light(choices, &mut scene);
    scene
}

/// Something small and far away seen in a flat mirror through the origin, across y.
pub(super) fn mirrored(choices: &mut Choices) -> Scene {
    let towards =
        vec3(choices.coordinate(1.0), choices.pick(&[0.8, 0.1, 2.0, 1e-3]), choices.coordinate(1.0));
    let towards = towards.normalize();
    let (seen_from, distance) = (distance(choices), distance(choices));
    let target = Target { center: towards * distance, radius: size(choices, seen_from + distance) };
    let eye = vec3(-towards.x, towards.y, -towards.z) * seen_from.min(1e3);
    let image = Target { center: vec3(target.center.x, -target.center.y, target.center.z), ..target };
    let mut scene = Scene::new(aim(choices, eye, &image));
    let normal = vec3(0.0, 1.0, 0.0);
    let mirror = match choices.below(3) {
        0 => Shape::Plane { normal, distance: 0.0 },
        1 => Shape::Disc { center: Vec3::ZERO, normal, radius: 1.0 },
        _ => {
            let corner = |x: f64, z: f64| vec3(x, 0.0, z);
            let outline = vec![corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0), corner(-1.0, -1.0)];
            Shape::Polygon { outline, holes: Vec::new() }
        }
    };
    let material = materials::mirror(choices);
    add(&mut scene, mirror, material);
    let (shape, material) = (things::any(choices, target.center, target.radius), materials::any(choices));
    add(&mut scene, shape, material);
    add_company(choices, &mut scene);
    add_light(choices, &mut scene);
    scene
}

/// A shadow of something small on a floor through the origin, across y.
pub(super) fn shadow(choices: &mut Choices) -> Scene {
    let towards = vec3(choices.coordinate(1.0), choices.pick(&[0.8, 0.1, 2.0]), choices.coordinate(1.0));
    let towards = towards.normalize();
    let distance = distance(choices);
    let radius = size(choices, distance);
    let color = choices.pick(&[Rgb::WHITE, rgb(0.5, 0.4, 0.2)]);
    let position = towards * (distance * choices.pick(&[2.0, 1.001, 100.0]));
    let light = match choices.below(3) {
        0 => Light::Directional { direction: -towards, color },
        1 => Light::Point { position, color },
        _ => {
            let outer_deg = choices.pick(&[20.0, 1.0, 170.0]);
            Light::Spot { position, direction: -towards, color, inner_deg: 0.5 * outer_deg, outer_deg }
        }
    };
    let eye = choices.point(1.0) + vec3(0.3, 1.2, 0.1) * choices.magnitude(0.0, 2.0);
    let mut scene = Scene::new(aim(choices, eye, &Target { center: Vec3::ZERO, radius }));
    scene.lights.push(light);
    let floor = match choices.below(3) {
        0 => Shape::Plane { normal: vec3(0.0, 1.0, 0.0), distance: 0.0 },
        1 => Shape::Disc { center: Vec3::ZERO, normal: vec3(0.0, 1.0, 0.0), radius: 3.0 },
        _ => Shape::Sphere { center: vec3(0.0, -3.0, 0.0), radius: 3.0 },
    };
    let material = materials::opaque(choices);
    add(&mut scene, floor, material);
    let shape = things::any(choices, towards * distance, radius);
    let material = materials::any(choices);
    add(&mut scene, shape, material);
    add_company(choices, &mut scene);
    scene
}

/// A light up to a million units away, or none.
pub(super) fn add_light(choices: &mut Choices, scene: &mut Scene) {
    let towards = choices.direction();
    let color = choices.pick(&[Rgb::WHITE, rgb(0.6, 0.5, 0.4)]);
    let light = match choices.below(4) {
        0 => return,
        1 => Light::Directional { direction: -towards, color },
        2 => Light::Point { position: towards * distance(choices), color },
        _ => {
            let position = towards * distance(choices);
            Light::Spot { position, direction: -towards, color, inner_deg: 1.0, outer_deg: 30.0 }
        }
    };
    scene.lights.push(light);
}
