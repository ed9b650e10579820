//! Methods that trace every sample give the same bits, whatever saves their work.

use brt_geometry::{Vec3, vec3};
use brt_image::{Rgb, rgb};
use brt_render::{
    Accelerator, BorderSettings, DeviationDelta, DifferenceDelta, HistoryKind, Judge, Layer, Method, Regions,
    Run, Samples, Settings, VarianceDelta,
};
use brt_scene::{Light, Material, Scene, Shape};
use brt_testkit::{
    AnyScene, Rendered, all_shapes, any_scene, any_scene_of_slivers, first_difference, looking,
    render_at_levels, replay_hint, scaled, seed_scene, seeded, shifted,
};
use proptest::prelude::*;

/// Border ray tracing that fills nothing: blocks without samples between their corners. Paper: P4 (3).
fn border_of_single_samples(judge: Judge, regions: Regions) -> Method {
    Method::Border(BorderSettings { block: 1, judge, regions })
}

const JUDGES: [Judge; 3] = [
    Judge::Variance(VarianceDelta(0.0)),
    Judge::Deviation(DeviationDelta(0.0)),
    Judge::Difference(DifferenceDelta(0.0)),
];

fn rendered(scene: &Scene, settings: &Settings) -> Rendered {
    render_at_levels(scene, settings, &Run { threads: 1, ..Run::default() })
}

/// Where a method's colours or ray histories are not those of `full`.
fn difference_to(full: &Rendered, scene: &Scene, settings: &Settings) -> Option<String> {
    let test = rendered(scene, settings);
    let colors = first_difference(settings.size, &full.colors, &test.colors);
    let histories = match settings.method {
        Method::Reference => None,
        _ => first_difference(settings.size, &full.history, &test.history),
    };
    colors.or(histories).map(|difference| replay_hint(scene, settings, &difference))
}

/// All ways to trace every sample, each compared with `full`.
fn differences(scene: &Scene, settings: &Settings) -> Vec<String> {
    let settings = Settings { layers: vec![Layer::History], ..settings.clone() };
    let full = rendered(scene, &settings);
    let with = |method: Method, accelerator| Settings { method, accelerator, ..settings.clone() };
    let mut ways = vec![
        with(Method::Reference, Accelerator::Bvh),
        with(Method::Full, Accelerator::None),
        with(Method::Full, Accelerator::Extents),
        with(Method::Full, Accelerator::Grid),
        with(Method::ItemBuffer, Accelerator::Bvh),
        with(Method::ScanLine, Accelerator::Bvh),
    ];
    for (judge, regions) in JUDGES.into_iter().zip([Regions::Separate, Regions::Together, Regions::Separate])
    {
        ways.push(with(border_of_single_samples(judge, regions), Accelerator::Bvh));
    }
    // Without histories, samples are traced in bundles.
    for accelerator in [Accelerator::Bvh, Accelerator::None] {
        let bare = Settings { layers: Vec::new(), ..with(Method::Full, accelerator) };
        let colors = first_difference(settings.size, &full.colors, &rendered(scene, &bare).colors);
        if let Some(difference) = colors {
            return vec![replay_hint(scene, &bare, &difference)];
        }
    }
    ways.iter().filter_map(|way| difference_to(&full, scene, way)).collect()
}

fn assert_same(scene: &Scene, size: [u32; 2]) {
    let differences = differences(scene, &Settings { history: HistoryKind::Shadower, ..Settings::new(size) });
    assert!(differences.is_empty(), "{}", differences[0]);
}

proptest! {
    #![proptest_config(seeded(1987, 800))]

    /// Paper: P1, P3, P10.
    #[test]
    fn all_ways_to_trace_every_sample_agree_bit_for_bit(
        AnyScene(scene) in any_scene(8),
        width in 1_u32..44,
        height in 1_u32..36,
        samples in prop_oneof![3 => Just(Samples::One), 1 => Just(Samples::Four), 1 => Just(Samples::Sixteen)],
        shadower in any::<bool>(),
    ) {
        let history = if shadower { HistoryKind::Shadower } else { HistoryKind::Lit };
        let differences = differences(&scene, &Settings { samples, history, ..Settings::new([width, height]) });
        prop_assert!(differences.is_empty(), "{}", differences[0]);
    }
}

proptest! {
    #![proptest_config(seeded(6, 200))]

    #[test]
    fn they_agree_a_million_times_larger_smaller_and_farther_away(
        AnyScene(scene) in any_scene(6),
        shift in prop::sample::select(vec![vec3(1e6, 0.0, 0.0), vec3(-1e6, 1e6, 1e6)]),
    ) {
        for moved in [scaled(&scene, 1e6), scaled(&scene, 1e-6), shifted(&scene, shift)] {
            prop_assume!(moved.check().is_empty());
            let differences = differences(&moved, &Settings::new([24, 18]));
            prop_assert!(differences.is_empty(), "{}", differences[0]);
        }
    }
}

proptest! {
    #![proptest_config(seeded(7, 1500))]

    /// Trees leave out what is far from a ray, so nothing may be met far from where it is.
    #[test]
    fn they_agree_on_slivers_seen_and_lit_along_themselves(
        AnyScene(scene) in any_scene_of_slivers(),
        width in 1_u32..60,
        height in 1_u32..30,
    ) {
        let differences = differences(&scene, &Settings::new([2 * width + 1, 2 * height + 1]));
        prop_assert!(differences.is_empty(), "{}", differences[0]);
    }
}

#[test]
fn they_agree_on_the_seed_scenes_and_on_all_shapes() {
    for scene in [seed_scene("a"), seed_scene("b"), seed_scene("c"), all_shapes()] {
        assert_same(&scene, [150, 133]);
    }
}

#[test]
fn they_agree_on_the_seed_scenes_scaled_and_shifted() {
    for scene in ["a", "b", "c"].map(seed_scene) {
        for moved in [scaled(&scene, 1e6), scaled(&scene, 1e-6), shifted(&scene, Vec3::splat(1e6))] {
            assert_same(&moved, [64, 48]);
        }
    }
}

#[test]
fn they_agree_on_one_pixel_and_on_one_column() {
    let scene = all_shapes();
    assert_same(&scene, [1, 1]);
    assert_same(&scene, [1, 777]);
    assert_same(&scene, [777, 1]);
}

#[test]
fn they_agree_on_a_scene_without_anything() {
    let mut scene = all_shapes();
    scene.objects.clear();
    assert_same(&scene, [30, 20]);
    scene.lights.clear();
    assert_same(&scene, [3, 2]);
}

/// Discs and a plane in one plane, seen directly, in a mirror, and in the way of light.
#[test]
fn they_agree_where_several_surfaces_are_met_at_one_distance() {
    let mut scene = Scene::new(looking([0.3, 0.2, 5.0], [0.0, 0.0, 0.0], 50.0));
    scene.lights.push(Light::Point { position: vec3(1.0, 2.0, -6.0), color: Rgb::WHITE });
    let normal = vec3(0.0, 0.0, 1.0);
    for (name, x, hue) in [("first", -0.5, 0.2), ("second", 0.1, 0.5), ("third", 0.8, 0.8)] {
        let color = rgb(hue, 1.0 - hue, 0.5);
        let material = scene.add_material(Material { ambient: 1.0, ..Material::matte(name, color) });
        scene.add(Shape::Disc { center: vec3(x, 0.0, 0.25), normal, radius: 1.0 }, material);
    }
    let mirror = Material { reflection: 0.5, ..Material::matte("mirror", Rgb::WHITE) };
    let mirror = scene.add_material(mirror);
    scene.add(Shape::Plane { normal, distance: -3.0 }, mirror);
    assert_same(&scene, [60, 40]);
    // The middle of the picture lies on all three discs: the earliest is seen.
    let picture = rendered(&scene, &Settings::new([61, 41]));
    assert_eq!(picture.colors[picture.index(30, 20)], [0.2, 0.8, 0.5]);
}
