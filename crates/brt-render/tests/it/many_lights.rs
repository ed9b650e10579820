//! However many lights a scene has, blocks are proven and filled.

use std::f64::consts::TAU;

use brt_geometry::{Vec3, vec3};
use brt_image::{Rgb, Transfer, rgb};
use brt_render::Settings;
use brt_scene::{Light, Material, Scene, Shape};
use brt_testkit::{AnyScene, any_scene, looking, seeded};
use proptest::prelude::*;

use crate::certified::{Promise, checked};

const SRGB: Promise = Promise { tolerance: 1.0, transfer: Transfer::Srgb };

/// A ball on a floor under a ring of equal lights.
fn under_lights(count: u32) -> Scene {
    let mut scene = Scene::new(looking([0.5, 3.5, 9.0], [0.0, 0.6, 0.0], 42.0));
    scene.lights = (0..count)
        .map(|i| {
            let (sin, cos) = libm::sincos(TAU * f64::from(i) / f64::from(count));
            let color = Rgb::WHITE * (0.9 / f64::from(count));
            Light::Point { position: vec3(1.5 * cos, 9.0, 1.5 * sin), color }
        })
        .collect();
    let material = scene.add_material(Material::matte("clay", rgb(0.8, 0.75, 0.7)));
    scene.add(Shape::Plane { normal: vec3(0.0, 1.0, 0.0), distance: 0.0 }, material);
    scene.add(Shape::Sphere { center: vec3(0.0, 1.0, 0.0), radius: 1.0 }, material);
    scene
}

fn traced_share(lights: u32) -> f64 {
    let picture = checked(&under_lights(lights), SRGB, &Settings::new([512, 512])).unwrap();
    picture.stats.pixels.traced as f64 / picture.stats.pixels.total as f64
}

#[test]
fn many_lights_leave_little_more_to_trace_than_eight() {
    let of_eight = traced_share(8);
    for lights in [9, 27, 100] {
        let share = traced_share(lights);
        assert!(share <= 1.5 * of_eight, "{lights} lights: {share:.4} traced, {of_eight:.4} with 8");
    }
}

fn any_light() -> impl Strategy<Value = Light> {
    let place = prop::array::uniform3(-6.0..6.0_f64).prop_map(|[x, y, z]| vec3(x, y, z));
    (any::<bool>(), place, 0.0..0.3_f32).prop_map(|(is_point, place, level)| {
        let color = Rgb::WHITE * f64::from(level);
        if is_point || place.length() < 0.1 {
            Light::Point { position: place, color }
        } else {
            Light::Directional { direction: Vec3::ZERO - place, color }
        }
    })
}

proptest! {
    #![proptest_config(seeded(2009, 100))]

    #[test]
    fn every_pixel_under_many_lights_is_within_the_tolerance(
        AnyScene(mut scene) in any_scene(5),
        lights in prop::collection::vec(any_light(), 9..40),
        tolerance in prop_oneof![Just(0.0), 0.1..3.0],
    ) {
        scene.lights.extend(lights);
        let promise = Promise { tolerance, ..SRGB };
        let checked = checked(&scene, promise, &Settings::new([90, 70]));
        prop_assert!(checked.is_ok(), "{}", checked.unwrap_err());
    }
}
