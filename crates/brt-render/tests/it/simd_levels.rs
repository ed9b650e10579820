//! Vector instructions change no bit, whatever is rendered with them.

use brt_geometry::SimdLevel;
use brt_image::Transfer;
use brt_render::{
    Accelerator, Backdrop, BorderSettings, CertifiedSettings, Filter, Layer, Method, PencilSettings,
    PixelSelectedSettings, RayOrder, Run, Samples, Settings,
};
use brt_scene::Scene;
use brt_testkit::{
    AnyScene, all_shapes, any_mesh_scene, any_scene, any_scene_of_solids, first_difference,
    render_at_every_level, render_stored_at_every_level, render_with_layers, replay_hint, seed_scene, seeded,
};
use proptest::prelude::*;

const ACCELERATORS: [Accelerator; 4] =
    [Accelerator::None, Accelerator::Extents, Accelerator::Grid, Accelerator::Bvh];

fn certified(tolerance: f64) -> Method {
    Method::Certified(CertifiedSettings { tolerance })
}

/// Compares `certified` with `full` for every accelerator at every level: the same bits without tolerance, within it else.
fn broken_promise(scene: &Scene, settings: &Settings, tolerance: f64) -> Option<String> {
    let full = Settings { method: Method::Full, ..settings.clone() };
    let full = render_with_layers(scene, &full, &Run { simd: SimdLevel::Baseline, ..Run::default() });
    for accelerator in ACCELERATORS {
        let settings = Settings { method: certified(tolerance), accelerator, ..settings.clone() };
        let picture = render_stored_at_every_level(scene, &settings, &Run::default(), Transfer::Linear);
        let allowed = tolerance / 255.0;
        let is_kept = |a: f32, b: f32| a == b || (f64::from(a) - f64::from(b)).abs() <= allowed;
        let kept: Vec<_> = picture
            .colors
            .iter()
            .zip(&full.colors)
            .map(|(ours, full)| if (0..3).all(|c| is_kept(ours[c], full[c])) { *full } else { *ours })
            .collect();
        if let Some(difference) = first_difference(settings.size, &full.colors, &kept) {
            return Some(replay_hint(scene, &settings, &difference));
        }
    }
    None
}

proptest! {
    #![proptest_config(seeded(2013, 300))]

    #[test]
    fn certified_keeps_its_promise_with_every_accelerator_at_every_level(
        AnyScene(scene) in prop_oneof![any_scene(8), any_scene_of_solids(), any_mesh_scene()],
        width in 8_u32..60,
        height in 8_u32..40,
        tolerance in prop_oneof![1 => Just(0.0), 3 => 0.05..3.0],
        samples in prop_oneof![4 => Just(Samples::One), 1 => Just(Samples::Four)],
    ) {
        let settings = Settings { samples, ..Settings::new([width, height]) };
        let broken = broken_promise(&scene, &settings, tolerance);
        prop_assert!(broken.is_none(), "{}", broken.unwrap());
    }
}

/// All methods, filters and orders of rays: whatever is computed in lanes takes part.
#[test]
fn every_method_gives_the_same_bits_at_every_level() {
    let methods = [
        Method::Reference,
        Method::Full,
        Method::ItemBuffer,
        Method::ScanLine,
        Method::Pencil(PencilSettings::default()),
        Method::PixelSelected(PixelSelectedSettings::default()),
        Method::Border(BorderSettings::default()),
        certified(1.0),
    ];
    for scene in [seed_scene("a"), seed_scene("b"), seed_scene("c"), all_shapes()] {
        for method in methods {
            let settings = Settings { method, ..Settings::new([75, 66]) };
            render_at_every_level(&scene, &settings, &Run::default());
        }
    }
}

#[test]
fn filters_layers_and_alpha_have_the_same_bits_at_every_level() {
    let scene = all_shapes();
    for filter in [Filter::Box, Filter::Gaussian] {
        for rays in [RayOrder::Bundled, RayOrder::Single] {
            let settings = Settings {
                method: certified(1.0),
                samples: Samples::Four,
                filter,
                layers: Layer::ALL.to_vec(),
                backdrop: Backdrop::Transparent,
                ..Settings::new([50, 40])
            };
            render_at_every_level(&scene, &settings, &Run { rays, ..Run::default() });
        }
    }
}
