//! An opened watch movement on a dark mirror: gold wheels between a blackened plate and polished bridges.
//!
//! z points up; lengths are millimetres of a large pocket watch. Parts keep a distance from each other or meet in
//! borders, so that no two faces lie in the same place.

mod balance;
mod bridges;
mod fittings;
mod metals;
mod outline;
mod rounding;
mod table;
mod train;
mod wheel;
mod workshop;

use brt_geometry::vec3;
use brt_image::rgb;
use brt_scene::{Camera, Light, Projection, Scene};
use metals::Metals;
use train::Train;
use workshop::Workshop;

/// The still life; round outlines have so many segments.
pub(super) fn build(segments: u32) -> Scene {
    let mut scene = stage();
    let metals = Metals::add_to(&mut scene);
    let mut workshop = Workshop { scene, metals, segments: segments.next_multiple_of(4) };
    let train = Train::new();
    workshop.surroundings();
    workshop.main_plate();
    workshop.moon();
    workshop.train(&train);
    let top = workshop.barrel_bridge(&train);
    workshop.winding(&train, top);
    workshop.fingers(&train);
    workshop.balance(&train);
    workshop.crown();
    workshop.loose_parts();
    workshop.loupe(-62.0, 4.0);
    rounding::rounded(workshop.scene)
}

/// Camera and lights: a warm key from the left, a cool one from the right, a lamp at the backdrop.
fn stage() -> Scene {
    let mut scene = Scene::new(Camera {
        eye: vec3(-7.0, -40.0, 33.0),
        look_at: vec3(-1.6, -4.3, 2.5),
        up: vec3(0.0, 0.0, 1.0),
        projection: Projection::Perspective { fov_deg: 34.0 },
    });
    scene.size = Some([1600, 1000]);
    scene.background = rgb(0.002, 0.003, 0.008);
    for (position, color) in [
        (vec3(-38.0, -22.0, 52.0), rgb(0.85, 0.74, 0.6)),
        (vec3(42.0, 8.0, 38.0), rgb(0.3, 0.38, 0.5)),
        (vec3(3.0, 34.0, 96.0), rgb(0.26, 0.4, 0.75)),
    ] {
        scene.lights.push(Light::Point { position, color });
    }
    scene
}

#[cfg(test)]
mod tests {
    use super::*;
    use brt_scene::Shape;

    #[test]
    fn default_has_moderately_many_primitives() {
        let scene = build(96);
        let primitives: usize = scene
            .objects
            .iter()
            .map(|object| match &object.shape {
                Shape::Mesh(mesh) => mesh.triangles.len(),
                _ => 1,
            })
            .sum();
        assert!((10_000..=30_000).contains(&primitives), "{primitives}");
    }

    #[test]
    fn everything_stands_above_the_mirror() {
        for object in build(48).objects {
            if let Some([lo, _]) = object.shape.bounds()
                && !matches!(object.shape, Shape::Disc { .. } | Shape::Cylinder { .. } | Shape::Cone { .. })
            {
                assert!(lo.z > 0.0, "{object:?}");
            }
        }
    }
}
