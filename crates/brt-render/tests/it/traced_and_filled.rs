//! Methods that fill: what they trace is exact, what they fill lies between, and the counts add up.

use brt_render::{
    BorderSettings, CheckedPixels, DifferenceDelta, HistoryKind, Layer, Method, PixelSelectedSettings, Run,
    SampleGrid, SampleState, Settings,
};
use brt_scene::Scene;
use brt_testkit::{
    AnyScene, Difference, Rendered, all_shapes, any_border, any_scene, render_with_layers, replay_hint,
    seed_scene, seeded,
};
use proptest::prelude::*;

fn any_pixel_selected() -> impl Strategy<Value = Method> {
    let delta = prop_oneof![Just(0.0), 0.0..130.0, Just(f64::INFINITY)];
    (1_u32..40, delta, any::<bool>()).prop_map(|(block, delta, central_point)| {
        Method::PixelSelected(PixelSelectedSettings { block, delta: DifferenceDelta(delta), central_point })
    })
}

fn any_filling_method() -> impl Strategy<Value = Method> {
    prop_oneof![2 => any_border().prop_map(Method::Border), 1 => any_pixel_selected()]
}

/// Everything that must hold of a picture with filled samples, one sample a pixel.
fn broken_promise(scene: &Scene, method: Method, size: [u32; 2], history: HistoryKind) -> Option<String> {
    let layers = vec![Layer::State, Layer::History];
    let settings = Settings { method, history, layers, checked: CheckedPixels::All, ..Settings::new(size) };
    let picture = render_with_layers(scene, &settings, &Run { threads: 1, ..Run::default() });
    let broken = traced_but_not_full(&picture).or_else(|| filled_beyond_traced(&picture));
    if let Some(difference) = broken {
        return Some(replay_hint(scene, &settings, &difference));
    }
    let (pixels, rays) = (picture.stats.pixels, picture.stats.rays);
    let count = |state| picture.state.iter().filter(|&&s| s == state).count() as u64;
    let promises = [
        (pixels.total == u64::from(size[0]) * u64::from(size[1]), "every pixel has a state"),
        (pixels.traced + pixels.shaded + pixels.filled == pixels.total, "every sample has one state"),
        (pixels.traced == count(SampleState::Traced), "traced samples are counted as the layer shows them"),
        (pixels.filled == count(SampleState::Filled), "filled samples are counted as the layer shows them"),
        (count(SampleState::Pending) == 0, "no sample is left"),
        (rays.camera == pixels.traced, "nothing is traced twice"),
    ];
    let failed = promises.iter().find(|promise| !promise.0)?;
    Some(format!("not so: {}; {:?} with {settings:?}", failed.1, picture.stats))
}

fn traced_but_not_full(picture: &Rendered) -> Option<Difference> {
    let bits = |c: [f32; 3]| c.map(f32::to_bits);
    let wrong = |i: &usize| {
        picture.state[*i] == SampleState::Traced && bits(picture.colors[*i]) != bits(picture.full[*i])
    };
    let i = (0..picture.state.len()).find(wrong)?;
    Some(difference_at(picture, i, format!("{:?} as by full", picture.full[i])))
}

/// A filled pixel whose colour is not between those of the traced pixels of its tile.
fn filled_beyond_traced(picture: &Rendered) -> Option<Difference> {
    let [width, height] = picture.size;
    let tile = SampleGrid::TILE;
    for (top, left) in (0..height)
        .step_by(tile as usize)
        .flat_map(|y| (0..width).step_by(tile as usize).map(move |x| (y, x)))
    {
        let rows = top..(top + tile).min(height);
        let pixels: Vec<usize> = rows
            .flat_map(|y| (left..(left + tile).min(width)).map(move |x| (x, y)))
            .map(|(x, y)| picture.index(x, y))
            .collect();
        let traced = || pixels.iter().filter(|&&i| picture.state[i] == SampleState::Traced);
        for c in 0..3 {
            let least = traced().map(|&i| picture.colors[i][c]).fold(f32::INFINITY, f32::min);
            let greatest = traced().map(|&i| picture.colors[i][c]).fold(f32::NEG_INFINITY, f32::max);
            // a + (b − a)·share rounds three times, each by at most half a unit of the greatest magnitude.
            let rounding = 1.5 * f32::EPSILON * least.abs().max(greatest.abs());
            let between = least - rounding..=greatest + rounding;
            if let Some(&i) = pixels.iter().find(|&&i| !between.contains(&picture.colors[i][c])) {
                return Some(difference_at(picture, i, format!("channel {c} in {between:?}")));
            }
        }
    }
    None
}

fn difference_at(picture: &Rendered, index: usize, expected: String) -> Difference {
    let width = picture.size[0];
    let pixel = [index as u32 % width, index as u32 / width];
    Difference { pixel, expected, actual: format!("{:?}", picture.colors[index]), count: 1 }
}

proptest! {
    #![proptest_config(seeded(16, 1500))]

    #[test]
    fn traced_pixels_equal_full_at_any_delta_and_filled_ones_lie_between(
        AnyScene(scene) in any_scene(7),
        method in any_filling_method(),
        width in 1_u32..70,
        height in 1_u32..50,
        shadower in any::<bool>(),
    ) {
        let history = if shadower { HistoryKind::Shadower } else { HistoryKind::Lit };
        let broken = broken_promise(&scene, method, [width, height], history);
        prop_assert!(broken.is_none(), "{}", broken.unwrap_or_default());
    }
}

proptest! {
    #![proptest_config(seeded(17, 24))]

    #[test]
    fn the_same_holds_over_several_tiles(
        method in any_filling_method(),
        which in 0_usize..4,
        width in 129_u32..300,
        height in 129_u32..200,
    ) {
        let scene = if which == 3 { all_shapes() } else { seed_scene(["a", "b", "c"][which]) };
        let broken = broken_promise(&scene, method, [width, height], HistoryKind::Lit);
        prop_assert!(broken.is_none(), "{}", broken.unwrap_or_default());
    }
}

#[test]
fn a_picture_in_one_colour_is_filled_from_few_traced_samples() {
    let mut scene = all_shapes();
    scene.objects.clear();
    let settings = Settings { method: Method::Border(Default::default()), ..Settings::new([256, 128]) };
    let picture = render_with_layers(&scene, &settings, &Run::default());
    // Two tiles of 8 × 8 blocks, whose corners are 9 × 9 samples.
    assert_eq!(picture.stats.pixels.traced, 2 * 81);
    assert_eq!(picture.stats.blocks.filled, 2 * 64);
    assert_eq!(picture.stats.blocks.divided, 0);
}

#[test]
fn samples_of_every_state_add_up_with_several_samples_a_pixel() {
    for scene in [seed_scene("b"), all_shapes()] {
        for samples in brt_render::Samples::ALL {
            let method = Method::Border(Default::default());
            let settings = Settings { method, samples, ..Settings::new([37, 21]) };
            let stats = render_with_layers(&scene, &settings, &Run::default()).stats;
            assert_eq!(stats.pixels.total, 37 * 21 * u64::from(samples.per_pixel()));
            assert_eq!(stats.pixels.traced + stats.pixels.filled, stats.pixels.total);
            assert_eq!(stats.pixels.traced, stats.rays.camera);
        }
    }
}

/// The share of samples that a method traces of the paper's scenes, at a width.
fn traced_share(name: &str, method: Method, side: u32) -> f64 {
    let settings = Settings { method, ..Settings::new([side, side]) };
    let pixels = render_with_layers(&seed_scene(name), &settings, &Run::default()).stats.pixels;
    pixels.traced as f64 / pixels.total as f64
}

/// Paper: P2, P9.
#[test]
fn border_traces_fewer_samples_than_pixel_selected_and_fewer_of_larger_pictures() {
    let border = Method::Border(BorderSettings::default());
    let pixel_selected = Method::PixelSelected(PixelSelectedSettings::default());
    for name in ["a", "b", "c"] {
        let [small, large] = [128, 256].map(|side| traced_share(name, border, side));
        assert!(large < 0.85 * small, "{name}: {large} of 256², {small} of 128²");
        let selected = traced_share(name, pixel_selected, 256);
        assert!(large < 0.85 * selected, "{name}: {large} by border, {selected} by pixel-selected");
    }
}
