//! What probing overlooks: tiny highlights, tiny mirrors, things seen only in a mirror, things seen only as shadows.

use brt_geometry::{Vec3, vec3};
use brt_image::rgb;
use brt_scene::{Camera, Light, Material, Projection, Scene, Shape};

use super::random::Random;

const EYE: Vec3 = vec3(0.0, 3.0, 9.0);
const LOOK_AT: Vec3 = vec3(0.0, 1.6, -6.0);
const FOV_DEG: f64 = 42.0;
const LIGHTS: [Vec3; 2] = [vec3(-7.0, 10.0, 3.0), vec3(6.0, 9.0, 7.0)];
/// The mirror wall: its depth, half its width, its height.
const WALL: (f64, f64, f64) = (-6.0, 4.0, 4.5);
/// Random places tried for a ball before a fixed one is taken, so that no search can go on for ever.
const TRIES: u32 = 1_000;

/// `count` tiny shiny balls, a fifth as many tiny mirrors, a third as many balls in each of the two hiding places.
pub(super) fn build(count: u32) -> Scene {
    let mut scene = room();
    let shiny = Material { specular: 0.9, exponent: 256.0, ..Material::matte("shiny", rgb(0.25, 0.3, 0.45)) };
    let mirror = Material {
        diffuse: 0.1,
        specular: 0.6,
        exponent: 256.0,
        reflection: 0.8,
        ..Material::matte("mirror ball", rgb(0.7, 0.7, 0.7))
    };
    let kinds: [(Material, u32, (f64, f64), Place); 4] = [
        (shiny, count, (0.015, 0.05), in_view),
        (mirror, count.div_ceil(5), (0.03, 0.07), in_view),
        (Material::matte("mirrored", rgb(0.9, 0.55, 0.15)), (count * 8).div_ceil(25), (0.1, 0.2), behind_eye),
        (Material::matte("hidden", rgb(0.7, 0.7, 0.7)), (count * 8).div_ceil(25), (0.05, 0.12), above_view),
    ];
    let mut random = Random::new(256);
    for (material, number, (least, greatest), place) in kinds {
        let id = scene.add_material(material);
        for _ in 0..number {
            let radius = random.between(least, greatest);
            let center = place(&mut random, radius);
            scene.add(Shape::Sphere { center, radius }, id);
        }
    }
    scene
}

type Place = fn(&mut Random, f64) -> Vec3;

fn room() -> Scene {
    let mut scene = Scene::new(Camera {
        eye: EYE,
        look_at: LOOK_AT,
        up: vec3(0.0, 1.0, 0.0),
        projection: Projection::Perspective { fov_deg: FOV_DEG },
    });
    scene.size = Some([1024, 1024]);
    scene.background = rgb(0.03, 0.04, 0.07);
    for (position, color) in LIGHTS.into_iter().zip([rgb(0.6, 0.57, 0.5), rgb(0.4, 0.43, 0.5)]) {
        scene.lights.push(Light::Point { position, color });
    }
    let floor = scene.add_material(Material::matte("floor", rgb(0.65, 0.65, 0.62)));
    let wall = scene.add_material(Material {
        ambient: 0.0,
        diffuse: 0.05,
        reflection: 0.85,
        ..Material::matte("mirror wall", rgb(0.5, 0.6, 0.7))
    });
    scene.add(Shape::Plane { normal: vec3(0.0, 1.0, 0.0), distance: 0.0 }, floor);
    let (depth, half, height) = WALL;
    let outline = vec![
        vec3(-half, 0.0, depth),
        vec3(half, 0.0, depth),
        vec3(half, height, depth),
        vec3(-half, height, depth),
    ];
    scene.add(Shape::Polygon { outline, holes: Vec::new() }, wall);
    scene
}

/// Floating between the eye and the mirror wall.
fn in_view(random: &mut Random, radius: f64) -> Vec3 {
    vec3(random.between(-3.5, 3.5), random.between(radius, 3.0), random.between(-5.5, 3.0))
}

/// Behind the eye, where only the mirror wall shows it.
fn behind_eye(random: &mut Random, radius: f64) -> Vec3 {
    let place = |random: &mut Random| {
        vec3(random.between(-8.0, 8.0), random.between(radius, 7.0), random.between(11.0, 18.0))
    };
    (0..TRIES).map(|_| place(random)).find(|&p| mirrored_in_wall(p, -0.1)).unwrap_or(vec3(0.0, 4.0, 14.0))
}

/// On the way from a light to a visible place of the floor, above the picture, and not seen in the mirror wall.
fn above_view(random: &mut Random, radius: f64) -> Vec3 {
    let place = |random: &mut Random| {
        let floor = vec3(random.between(-3.0, 3.0), 0.0, random.between(-4.5, 2.0));
        let light = LIGHTS[usize::from(random.unit() < 0.5)];
        floor + (light - floor) * random.between(0.3, 0.9)
    };
    let margin = 0.02 + radius / 4.0;
    (0..TRIES)
        .map(|_| place(random))
        .find(|&p| !in_frame(p, margin) && !mirrored_in_wall(p, margin))
        .unwrap_or(vec3(0.0, 8.0, 5.0))
}

/// Is this point inside the picture, or outside by less than a margin (in halves of the picture's side)?
fn in_frame(p: Vec3, margin: f64) -> bool {
    let forward = (LOOK_AT - EYE).normalize();
    let right = forward.cross(vec3(0.0, 1.0, 0.0)).normalize();
    let to = p - EYE;
    let reach = to.dot(forward) * libm::tan(FOV_DEG.to_radians() / 2.0) * (1.0 + margin);
    to.dot(right).abs() < reach && to.dot(right.cross(forward)).abs() < reach
}

/// Does the mirror wall show this point inside the picture?
fn mirrored_in_wall(p: Vec3, margin: f64) -> bool {
    let (depth, half, height) = WALL;
    let image = vec3(p.x, p.y, 2.0 * depth - p.z);
    let share = (depth - EYE.z) / (image.z - EYE.z);
    let seen_at = EYE + (image - EYE) * share;
    let inside = seen_at.x.abs() < half + margin && seen_at.y > -margin && seen_at.y < height + margin;
    inside && in_frame(image, margin)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn balls(scene: &Scene, material: &str) -> Vec<Vec3> {
        let id = scene.materials.iter().position(|m| m.name == material).unwrap();
        let centers = scene.objects.iter().filter(|o| o.material.0 as usize == id);
        centers
            .filter_map(|o| match o.shape {
                Shape::Sphere { center, .. } => Some(center),
                _ => None,
            })
            .collect()
    }

    #[test]
    fn default_has_the_balls_of_the_measured_scene() {
        let scene = build(250);
        let counts = ["shiny", "mirror ball", "mirrored", "hidden"].map(|name| balls(&scene, name).len());
        assert_eq!(counts, [250, 50, 80, 80]);
    }

    #[test]
    fn hidden_things_are_hidden_and_mirrored_things_are_mirrored() {
        let scene = build(250);
        for p in balls(&scene, "mirrored") {
            assert!(!in_frame(p, 0.0) && mirrored_in_wall(p, 0.0), "{p:?}");
        }
        for p in balls(&scene, "hidden") {
            assert!(!in_frame(p, 0.0) && !mirrored_in_wall(p, 0.0), "{p:?}");
        }
    }
}
