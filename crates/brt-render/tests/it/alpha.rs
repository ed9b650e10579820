//! A transparent backdrop: alpha is 1 less the share of the background that is seen straight, with every method.

use brt_geometry::vec3;
use brt_image::{Rgb, Transfer, rgb, straight};
use brt_render::{
    Backdrop, BorderSettings, CertifiedSettings, CheckedPixels, Filter, Layer, Method, PencilSettings,
    PixelSelectedSettings, RayOrder, Run, Samples, Settings, TileOrder,
};
use brt_scene::{Light, Material, Scene, Shape};
use brt_testkit::{
    AnyScene, Rendered, all_shapes, any_scene, first_difference, looking, render_at_levels,
    render_stored_at_levels, render_with_layers, replay_hint, seeded,
};
use proptest::prelude::*;

fn exactly() -> Method {
    Method::Certified(CertifiedSettings { tolerance: 0.0 })
}

/// All that trace every sample, or promise its bits.
fn exact_methods() -> [Method; 5] {
    [Method::Reference, Method::Full, Method::ItemBuffer, Method::ScanLine, exactly()]
}

fn all_methods() -> Vec<Method> {
    let others = [
        Method::Pencil(PencilSettings::default()),
        Method::PixelSelected(PixelSelectedSettings::default()),
        Method::Border(BorderSettings::default()),
        Method::Certified(CertifiedSettings::default()),
    ];
    exact_methods().into_iter().chain(others).collect()
}

fn transparent(size: [u32; 2], method: Method) -> Settings {
    Settings { method, backdrop: Backdrop::Transparent, ..Settings::new(size) }
}

fn rendered(scene: &Scene, settings: &Settings) -> Rendered {
    render_at_levels(scene, settings, &Run::default())
}

/// Where two pictures differ in a bit of a colour or alpha.
fn difference(scene: &Scene, settings: &Settings, expected: &Rendered, actual: &Rendered) -> Option<String> {
    let colors = first_difference(settings.size, &expected.colors, &actual.colors);
    let alpha = || first_difference(settings.size, &expected.alpha, &actual.alpha);
    colors.or_else(alpha).map(|difference| replay_hint(scene, settings, &difference))
}

/// What differs from the picture before the scene's background, once the transparent one is laid over it: the two share
/// no code for what is seen behind surfaces.
fn difference_over_background(scene: &Scene, settings: &Settings, picture: &Rendered) -> Option<String> {
    let before = rendered(scene, &Settings { backdrop: Backdrop::Scene, ..settings.clone() });
    let background = scene.background.to_f32();
    let is_same = |i: usize| {
        let open = 1.0 - picture.alpha[i];
        (0..3).all(|c| {
            let (laid, wanted) = (picture.colors[i][c] + open * background[c], before.colors[i][c]);
            (laid - wanted).abs() <= 1e-5 * wanted.abs().max(background[c]).max(1.0)
        })
    };
    let wrong = (0..before.colors.len()).find(|&i| !is_same(i))?;
    Some(format!("pixel {wrong} with {settings:?}"))
}

fn any_samples() -> impl Strategy<Value = (Samples, Filter)> {
    let samples = prop::sample::select(vec![Samples::One, Samples::Four, Samples::Sixteen]);
    (samples, prop_oneof![Just(Filter::Box), Just(Filter::Gaussian)])
}

proptest! {
    #![proptest_config(seeded(1984, 150))]

    #[test]
    fn exact_methods_have_one_alpha_and_it_is_the_share_of_the_background(
        AnyScene(scene) in any_scene(8),
        width in 1_u32..44,
        height in 1_u32..36,
        (samples, filter) in any_samples(),
    ) {
        let with = |method| Settings { samples, filter, ..transparent([width, height], method) };
        let reference = rendered(&scene, &with(Method::Reference));
        for method in exact_methods() {
            let settings = with(method);
            let wrong = difference(&scene, &settings, &reference, &rendered(&scene, &settings));
            prop_assert!(wrong.is_none(), "{}", wrong.unwrap());
        }
        let one_by_one = Run { rays: RayOrder::Single, ..Run::default() };
        let settings = with(Method::Full);
        let single = render_with_layers(&scene, &settings, &one_by_one);
        let wrong = difference(&scene, &settings, &reference, &single)
            .or_else(|| difference_over_background(&scene, &settings, &single));
        prop_assert!(wrong.is_none(), "{}", wrong.unwrap());
    }

    #[test]
    fn certified_keeps_its_promise_for_straight_colours_and_has_the_alpha_of_full(
        AnyScene(scene) in any_scene(8),
        width in 1_u32..100,
        height in 1_u32..80,
        tolerance in 0.01..3.0,
        transfer in prop_oneof![Just(Transfer::Linear), Just(Transfer::Srgb)],
        (samples, filter) in any_samples(),
    ) {
        let method = Method::Certified(CertifiedSettings { tolerance });
        let checked = CheckedPixels::All;
        let settings = Settings { samples, filter, checked, ..transparent([width, height], method) };
        let picture = render_stored_at_levels(&scene, &settings, &Run::default(), transfer);
        let alphas = first_difference(settings.size, &picture.full_alpha, &picture.alpha);
        prop_assert!(alphas.is_none(), "{}", replay_hint(&scene, &settings, &alphas.unwrap()));
        let stored = |color, alpha| straight(color, alpha).map(|c| 255.0 * transfer.encode(c.into()));
        for (i, &alpha) in picture.alpha.iter().enumerate() {
            let (ours, full) = (stored(picture.colors[i], alpha), stored(picture.full[i], alpha));
            let error = (0..3).map(|c| (ours[c] - full[c]).abs()).fold(0.0, f64::max);
            prop_assert!(error <= tolerance, "{error} at {i}");
        }
    }
}

/// Two discs that are a quarter there, the left one alone, before a blue background; further right a mirror and glass.
fn veils() -> Scene {
    let mut scene = Scene::new(looking([0.0, 0.0, 10.0], [0.0, 0.0, 0.0], 40.0));
    scene.background = rgb(0.0, 0.0, 1.0);
    scene.lights.push(Light::Directional { direction: vec3(0.0, 0.0, -1.0), color: Rgb::WHITE });
    let black = Material { ambient: 0.0, diffuse: 0.0, ..Material::matte("veil", Rgb::BLACK) };
    let red = rgb(1.0, 0.0, 0.0);
    let veil = scene.add_material(Material { opacity: 0.25, emission: red, ..black.clone() });
    let mirror = Material { name: "mirror".into(), reflection: 1.0, ..black.clone() };
    let mirror = scene.add_material(mirror);
    let glass = Material { name: "glass".into(), transmission: 1.0, index_of_refraction: 1.0, ..black };
    let glass = scene.add_material(glass);
    let normal = vec3(0.0, 0.0, 1.0);
    for (x, z, material) in
        [(-2.4, 0.0, veil), (-0.8, 0.0, veil), (-0.8, -0.5, veil), (0.8, 0.0, mirror), (2.4, 0.0, glass)]
    {
        scene.add(Shape::Disc { center: vec3(x, 0.0, z), normal, radius: 0.6 }, material);
    }
    scene
}

#[test]
fn alpha_is_0_1_or_a_fraction_where_it_must_be() {
    let scene = veils();
    let size = [180, 60];
    for method in all_methods() {
        let picture = rendered(&scene, &transparent(size, method));
        let at = |x: f64| {
            // The view is 40° wide at a distance of 10 in the picture's smaller side.
            let scale = 60.0 / (20.0 * libm::tan(20_f64.to_radians()));
            let i = picture.index((90.0 + x * scale) as u32, 30);
            (picture.colors[i], picture.alpha[i])
        };
        // One veil; two: 1 − 0.75², and 0.25 + 0.75 · 0.25 of red; the mirror and glass show the background.
        let expected = [
            (-2.4, [0.25, 0.0, 0.0], 0.25),
            (-0.8, [0.4375, 0.0, 0.0], 0.4375),
            (0.8, [0.0, 0.0, 1.0], 1.0),
            (2.4, [0.0, 0.0, 1.0], 1.0),
            (-1.6, [0.0; 3], 0.0),
            (0.0, [0.0; 3], 0.0),
        ];
        for (x, color, alpha) in expected {
            assert_eq!(at(x), (color, alpha), "{x} by {method:?}");
        }
    }
}

/// Border ray tracing knows exactly what is seen first, but not what is seen through that.
#[test]
fn methods_that_fill_have_the_alpha_of_full() {
    let mut shapes = all_shapes();
    shapes.objects.retain(|object| !matches!(object.shape, Shape::Plane { .. }));
    let (border, pencil) = (BorderSettings::default(), PencilSettings::default());
    let size = [150, 133];
    for (scene, method) in [
        (&shapes, Method::Border(border)),
        (&shapes, Method::Pencil(pencil)),
        (&veils(), Method::Pencil(pencil)),
    ] {
        let full = rendered(scene, &transparent(size, Method::Full));
        let settings = transparent(size, method);
        let test = rendered(scene, &settings);
        assert!(test.stats.pixels.filled > 5_000, "{method:?}");
        let alphas = first_difference(size, &full.alpha, &test.alpha);
        assert!(alphas.is_none(), "{}", replay_hint(scene, &settings, &alphas.unwrap()));
    }
}

#[test]
fn threads_tile_orders_and_layers_change_no_bit_of_alpha() {
    let scene = all_shapes();
    for method in all_methods() {
        for (filter, samples) in [(Filter::Box, Samples::One), (Filter::Gaussian, Samples::Four)] {
            let settings = Settings { filter, samples, ..transparent([150, 140], method) };
            let plain = render_with_layers(&scene, &settings, &Run { threads: 1, ..Run::default() });
            let runs = [
                (2, TileOrder::Sorted, Vec::new()),
                (3, TileOrder::Shuffled(5), Vec::new()),
                (2, TileOrder::Sorted, Layer::ALL.to_vec()),
            ];
            for (threads, order, layers) in runs {
                let settings = Settings { layers, ..settings.clone() };
                let run = Run { threads, order, ..Run::default() };
                let test = render_with_layers(&scene, &settings, &run);
                let wrong = difference(&scene, &settings, &plain, &test);
                assert!(wrong.is_none(), "{threads} threads: {}", wrong.unwrap());
            }
        }
    }
}

#[test]
fn pictures_with_a_background_have_no_alpha() {
    let settings = Settings { checked: CheckedPixels::All, ..Settings::new([20, 10]) };
    let picture = rendered(&all_shapes(), &settings);
    assert!(picture.alpha.is_empty() && picture.full_alpha.is_empty());
}
