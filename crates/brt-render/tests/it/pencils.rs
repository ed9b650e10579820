//! Pencil tracing: what is not split to rays is within the stated tolerance.

use brt_render::{CheckedPixels, Layer, Method, PencilSettings, Run, SampleState, Settings};
use brt_scene::Scene;
use brt_testkit::{
    AnyScene, Difference, Rendered, all_shapes, any_scene, render_with_layers, replay_hint, scaled,
    seed_scene, seeded, shifted,
};
use proptest::prelude::*;

/// Colours are stored in `f32`: what that rounds, in levels, for a colour of this size.
fn rounding(value: f32) -> f64 {
    255.0 * f64::from(f32::EPSILON) * f64::from(value.abs())
}

fn broken(picture: &Rendered, tolerance: f64) -> Option<usize> {
    (0..picture.state.len()).find(|&i| {
        (0..3).any(|c| {
            let (ours, full) = (picture.colors[i][c], picture.full[i][c]);
            match picture.state[i] {
                SampleState::Traced => ours.to_bits() != full.to_bits(),
                _ => 255.0 * (f64::from(ours) - f64::from(full)).abs() > tolerance + 2.0 * rounding(full),
            }
        })
    })
}

/// Checks a scene; returns the share of samples that were not split to rays.
fn filled_share(scene: &Scene, size: [u32; 2], pencil: PencilSettings) -> Result<f64, String> {
    let layers = vec![Layer::State];
    let method = Method::Pencil(pencil);
    let settings = Settings { method, layers, checked: CheckedPixels::All, ..Settings::new(size) };
    let picture = render_with_layers(scene, &settings, &Run::default());
    if let Some(i) = broken(&picture, pencil.tolerance) {
        let difference = Difference {
            pixel: [i as u32 % size[0], i as u32 / size[0]],
            expected: format!("{:?}", picture.full[i]),
            actual: format!("{:?} {:?}", picture.state[i], picture.colors[i]),
            count: 1,
        };
        return Err(replay_hint(scene, &settings, &difference));
    }
    Ok(picture.stats.pixels.filled as f64 / picture.stats.pixels.total as f64)
}

proptest! {
    #![proptest_config(seeded(1986, 400))]

    #[test]
    fn filled_samples_are_within_the_tolerance_on_random_scenes(
        AnyScene(scene) in any_scene(8),
        width in 1_u32..90,
        height in 1_u32..70,
        block in 1_u32..128,
        tolerance in prop_oneof![Just(0.0), 0.01..3.0],
    ) {
        let checked = filled_share(&scene, [width, height], PencilSettings { block, tolerance });
        prop_assert!(checked.is_ok(), "{}", checked.unwrap_err());
    }
}

#[test]
fn most_of_the_seed_scenes_is_filled_within_the_tolerance_wherever_they_stand() {
    for (name, least) in [("a", 0.6), ("b", 0.4), ("c", 0.7)] {
        let scene = seed_scene(name);
        let moved = [
            scene.clone(),
            scaled(&scene, 1e6),
            scaled(&scene, 1e-6),
            shifted(&scene, brt_geometry::vec3(1e3, -1e3, 1e3)),
        ];
        for scene in moved {
            let share = filled_share(&scene, [300, 300], PencilSettings::default()).unwrap();
            assert!(share >= least, "{name}: {share}");
        }
    }
}

#[test]
fn all_shapes_are_within_a_quarter_of_a_level() {
    let pencil = PencilSettings { tolerance: 0.25, ..PencilSettings::default() };
    assert!(filled_share(&all_shapes(), [200, 150], pencil).unwrap() > 0.1);
}
