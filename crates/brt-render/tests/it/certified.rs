//! Certified ray tracing keeps its promise: every pixel within the tolerance, with the bits of full ray tracing at 0.

use brt_image::Transfer;
use brt_procedural as procedural;
use brt_render::{
    BorderSettings, CertifiedSettings, CheckedPixels, Filter, Layer, Method, Run, SampleState, Samples,
    Settings, TileOrder,
};
use brt_scene::Scene;
use brt_testkit::{
    AnyScene, Difference, Rendered, any_mesh_scene, any_scene, any_scene_of_slivers, any_scene_of_solids,
    render_stored_at_levels, render_with_layers, replay_hint, scaled, seed_scene, seeded, shifted,
};
use proptest::prelude::*;

/// How far from full ray tracing a picture may be, and how it is stored.
#[derive(Clone, Copy)]
pub(crate) struct Promise {
    pub(crate) tolerance: f64,
    pub(crate) transfer: Transfer,
}

impl Default for Promise {
    fn default() -> Self {
        Self { tolerance: 1.0, transfer: Transfer::Srgb }
    }
}

/// The greatest difference of any channel of a pixel in levels of 255 of stored values.
fn error(picture: &Rendered, transfer: Transfer, i: usize) -> f64 {
    let (ours, full) = (picture.colors[i], picture.full[i]);
    if ours == full {
        return 0.0;
    }
    let stored = |x: f32| 255.0 * transfer.encode(f64::from(x));
    (0..3).map(|c| (stored(ours[c]) - stored(full[c])).abs()).fold(0.0, f64::max)
}

fn is_kept(picture: &Rendered, certified: Promise, settings: &Settings, i: usize) -> bool {
    let is_one_sample = (settings.samples, settings.filter) == (Samples::One, Filter::Box);
    let is_exact = is_one_sample && picture.state[i] != SampleState::Filled;
    let Promise { tolerance, transfer } = certified;
    if is_exact || tolerance == 0.0 {
        return picture.colors[i] == picture.full[i];
    }
    error(picture, transfer, i) <= tolerance
}

/// Renders a scene and checks every pixel.
pub(crate) fn checked(scene: &Scene, certified: Promise, settings: &Settings) -> Result<Rendered, String> {
    let settings = Settings {
        method: Method::Certified(CertifiedSettings { tolerance: certified.tolerance }),
        layers: vec![Layer::State, Layer::Certificates],
        checked: CheckedPixels::All,
        ..settings.clone()
    };
    let picture = render_stored_at_levels(scene, &settings, &Run::default(), certified.transfer);
    let broken = |&i: &usize| !is_kept(&picture, certified, &settings, i);
    let Some(i) = (0..picture.colors.len()).find(broken) else { return Ok(picture) };
    let width = settings.size[0];
    let difference = Difference {
        pixel: [i as u64 % width, i as u64 / width].map(|place| place as u32),
        expected: format!("{:?} within {}", picture.full[i], certified.tolerance),
        actual: format!("{:?} {:?}", picture.state[i], picture.colors[i]),
        count: (0..picture.colors.len()).filter(broken).count(),
    };
    Err(replay_hint(scene, &settings, &difference))
}

fn filled_share(picture: &Rendered) -> f64 {
    picture.stats.pixels.filled as f64 / picture.stats.pixels.total as f64
}

fn named(name: &str) -> Scene {
    procedural::find(name).unwrap().build(None).unwrap()
}

proptest! {
    #![proptest_config(seeded(1987, 500))]

    #[test]
    fn every_pixel_of_random_scenes_is_within_the_tolerance(
        AnyScene(scene) in any_scene(8),
        width in 1_u32..100,
        height in 1_u32..80,
        tolerance in prop_oneof![Just(0.0), 0.01..3.0],
        transfer in prop_oneof![Just(Transfer::Linear), Just(Transfer::Srgb)],
        samples in prop_oneof![3 => Just(Samples::One), 1 => Just(Samples::Four), 1 => Just(Samples::Sixteen)],
        filter in prop_oneof![Just(Filter::Box), Just(Filter::Gaussian)],
    ) {
        let settings = Settings { samples, filter, ..Settings::new([width, height]) };
        let checked = checked(&scene, Promise { tolerance, transfer }, &settings);
        prop_assert!(checked.is_ok(), "{}", checked.unwrap_err());
    }
}

proptest! {
    #![proptest_config(seeded(1991, 200))]

    #[test]
    fn every_pixel_of_random_meshes_is_within_the_tolerance(
        AnyScene(scene) in any_mesh_scene(),
        width in 100_u32..400,
        tolerance in 0.05..3.0,
        transfer in prop_oneof![Just(Transfer::Linear), Just(Transfer::Srgb)],
    ) {
        let checked = checked(&scene, Promise { tolerance, transfer }, &Settings::new([width, 150]));
        prop_assert!(checked.is_ok(), "{}", checked.unwrap_err());
    }
}

proptest! {
    #![proptest_config(seeded(1993, 300))]

    #[test]
    fn every_pixel_of_random_solids_is_within_the_tolerance(
        AnyScene(scene) in any_scene_of_solids(),
        width in 100_u32..400,
        tolerance in 0.05..3.0,
        samples in prop_oneof![4 => Just(Samples::One), 1 => Just(Samples::Four)],
    ) {
        let settings = Settings { samples, ..Settings::new([width, 150]) };
        let transfer = Transfer::Linear;
        let checked = checked(&scene, Promise { tolerance, transfer }, &settings);
        prop_assert!(checked.is_ok(), "{}", checked.unwrap_err());
    }
}

proptest! {
    #![proptest_config(seeded(1997, 500))]

    #[test]
    fn every_pixel_of_slivers_is_within_the_tolerance(
        AnyScene(scene) in any_scene_of_slivers(),
        width in 20_u32..150,
        tolerance in prop_oneof![Just(0.0), 0.05..3.0],
    ) {
        let transfer = Transfer::Linear;
        let settings = Settings::new([2 * width + 1, 121]);
        let checked = checked(&scene, Promise { tolerance, transfer }, &settings);
        prop_assert!(checked.is_ok(), "{}", checked.unwrap_err());
    }
}

/// Blocks at the edges of faces are filled, too, though bounds reach beyond the edges.
#[test]
fn faces_are_filled_up_to_their_edges() {
    let scene = named("blocks");
    let picture = checked(&scene, Promise::default(), &Settings::new([1024, 1024])).unwrap();
    assert!(filled_share(&picture) > 0.7, "{}", filled_share(&picture));
}

/// Triangles are smaller than the blocks that are filled.
#[test]
fn smooth_meshes_are_filled_across_their_triangles() {
    let scene = named("torus");
    let picture = checked(&scene, Promise::default(), &Settings::new([1500, 1500])).unwrap();
    assert!(filled_share(&picture) > 0.7, "{}", filled_share(&picture));
}

#[test]
fn seed_scenes_are_filled_within_the_tolerance_wherever_they_stand() {
    for (name, least) in [("a", 0.4), ("b", 0.25), ("c", 0.4)] {
        let scene = seed_scene(name);
        let far = brt_geometry::vec3(1e3, -1e3, 1e3);
        for moved in [scaled(&scene, 1e6), scaled(&scene, 1e-6), shifted(&scene, far), scene] {
            let picture = checked(&moved, Promise::default(), &Settings::new([300, 300])).unwrap();
            assert!(filled_share(&picture) >= least, "{name}: {}", filled_share(&picture));
        }
    }
}

#[test]
fn named_scenes_are_within_the_tolerance() {
    for name in ["blocks", "torus", "mirror-torus", "adversary", "balls", "tree", "rings"] {
        let scene = named(name);
        for (tolerance, transfer) in [(1.0, Transfer::Srgb), (0.25, Transfer::Linear), (0.0, Transfer::Srgb)]
        {
            let certified = Promise { tolerance, transfer };
            checked(&scene, certified, &Settings::new([160, 120])).unwrap();
        }
    }
}

/// Paper: P17, P19, P20.
#[test]
fn adversary_has_no_pixel_above_the_tolerance_and_border_has_thousands() {
    let scene = named("adversary");
    let settings = || Settings { checked: CheckedPixels::All, ..Settings::new([512, 512]) };
    let linear = Promise { tolerance: 1.0, transfer: Transfer::Linear };
    let picture = checked(&scene, linear, &settings()).unwrap();
    assert!(filled_share(&picture) > 0.4, "{}", filled_share(&picture));
    let method = Method::Border(BorderSettings::default());
    let border = render_with_layers(&scene, &Settings { method, ..settings() }, &Run::default());
    let far_off = (0..border.colors.len()).filter(|&i| error(&border, Transfer::Linear, i) > 16.0);
    assert!(far_off.count() > 3000);
}

#[test]
fn means_of_sixteen_samples_keep_the_tolerance() {
    for filter in [Filter::Box, Filter::Gaussian] {
        let settings = Settings { samples: Samples::Sixteen, filter, ..Settings::new([64, 48]) };
        checked(&seed_scene("b"), Promise::default(), &settings).unwrap();
    }
}

#[test]
fn threads_and_the_order_of_tiles_change_nothing() {
    let scene = seed_scene("b");
    let method = Method::Certified(CertifiedSettings::default());
    let settings = Settings { method, ..Settings::new([300, 200]) };
    let runs = [
        Run { threads: 1, ..Run::default() },
        Run { threads: 2, ..Run::default() },
        Run { threads: 2, order: TileOrder::Shuffled(5), ..Run::default() },
    ];
    let [first, others @ ..] = runs.map(|run| render_with_layers(&scene, &settings, &run).colors);
    assert!(others.iter().all(|other| *other == first));
}

#[test]
fn histories_are_those_of_full_ray_tracing() {
    for name in ["a", "c"] {
        let scene = seed_scene(name);
        let layers = vec![Layer::History];
        let by = |method| {
            let settings = Settings { method, layers: layers.clone(), ..Settings::new([200, 150]) };
            render_with_layers(&scene, &settings, &Run::default()).history
        };
        let certified = by(Method::Certified(CertifiedSettings::default()));
        assert!(certified == by(Method::Full), "{name}");
    }
}
