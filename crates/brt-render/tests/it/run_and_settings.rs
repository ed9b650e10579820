//! How a picture is rendered changes nothing in it; what cannot be rendered is an error.

use std::sync::atomic::{AtomicBool, Ordering};

use brt_image::Transfer;
use brt_render::{
    Accelerator, BorderSettings, CertifiedSettings, Filter, Layer, Method, PencilSettings,
    PixelSelectedSettings, Progress, RayOrder, RenderError, Renderer, Rows, Run, Samples, Settings, Sink,
    SinkError, Stats, TileOrder, Window, render,
};
use brt_scene::{Scene, Shape};
use brt_testkit::{
    Rendered, all_shapes, checked, first_difference, looking, render_to_image, render_with_layers, seed_scene,
};

fn counts(stats: &Stats) -> Stats {
    Stats { seconds: Default::default(), ..*stats }
}

fn assert_same_picture(a: &Rendered, b: &Rendered, what: &str) {
    let size = a.size;
    let differences = [
        first_difference(size, &a.colors, &b.colors),
        first_difference(size, &a.surface, &b.surface),
        first_difference(size, &a.depth, &b.depth),
        first_difference(size, &a.normal, &b.normal),
        first_difference(size, &a.history, &b.history),
        first_difference(size, &a.state, &b.state),
    ];
    let first = differences.into_iter().flatten().next();
    assert!(first.is_none(), "{what}: {}", first.map(|d| d.to_string()).unwrap_or_default());
    assert_eq!(counts(&a.stats), counts(&b.stats), "{what}");
}

/// Nodes that rays visit tell trees apart; a mesh of so many triangles is prepared in several portions.
#[test]
fn a_scene_is_prepared_the_same_on_any_number_of_threads() {
    let torus = brt_procedural::find("torus").unwrap().build(Some(20_000)).unwrap();
    let settings = Settings { method: Method::Full, ..Settings::new([160, 120]) };
    let on = |threads| render_with_layers(&torus, &settings, &Run { threads, ..Run::default() });
    let alone = on(1);
    assert!(alone.stats.nodes_visited > 10_000, "{}", alone.stats.nodes_visited);
    for threads in [2, 5] {
        assert_same_picture(&on(threads), &alone, &format!("{threads} threads"));
    }
}

#[test]
fn threads_and_tile_orders_change_no_byte_and_no_count() {
    let methods = [
        Method::Full,
        Method::PixelSelected(PixelSelectedSettings::default()),
        Method::Border(BorderSettings::default()),
        Method::Certified(CertifiedSettings::default()),
        Method::Pencil(PencilSettings::default()),
        Method::ItemBuffer,
    ];
    let scene = all_shapes();
    for (method, filter, samples) in methods
        .into_iter()
        .flat_map(|m| [(m, Filter::Box, Samples::One), (m, Filter::Gaussian, Samples::Four)])
    {
        let size = if samples == Samples::One { [331, 270] } else { [150, 140] };
        let layers = Layer::ALL.to_vec();
        let settings = Settings { method, filter, samples, layers, ..Settings::new(size) };
        let with =
            |threads, order| render_with_layers(&scene, &settings, &Run { threads, order, ..Run::default() });
        let plain = with(1, TileOrder::Sorted);
        for (threads, order) in [
            (2, TileOrder::Sorted),
            (7, TileOrder::Sorted),
            (1, TileOrder::Shuffled(5)),
            (7, TileOrder::Shuffled(99)),
        ] {
            let what = format!("{threads} threads, {order:?}, {method:?}, {filter:?}");
            assert_same_picture(&plain, &with(threads, order), &what);
        }
    }
}

/// Without layers more is left of the tile before: histories of samples that are filled.
#[test]
fn threads_change_no_byte_and_no_count_where_no_layer_is_asked_for() {
    let methods = [
        Method::PixelSelected(PixelSelectedSettings::default()),
        Method::Border(BorderSettings::default()),
        Method::Certified(CertifiedSettings::default()),
    ];
    let scenes = [all_shapes(), brt_procedural::find("torus").unwrap().build(Some(1000)).unwrap()];
    for (scene, method) in scenes.iter().flat_map(|scene| methods.map(|method| (scene, method))) {
        let settings = Settings { method, samples: Samples::Four, ..Settings::new([150, 140]) };
        let with = |threads, order| {
            let run = Run { threads, order, ..Run::default() };
            let (colors, stats) = render_to_image(scene, &settings, &run);
            (colors, counts(&stats))
        };
        let plain = with(1, TileOrder::Sorted);
        for (threads, order) in
            [(2, TileOrder::Sorted), (1, TileOrder::Shuffled(5)), (7, TileOrder::Shuffled(99))]
        {
            assert!(plain == with(threads, order), "{threads} threads, {order:?}, {method:?}");
        }
    }
}

#[test]
fn a_thousand_by_777_pixels_come_in_order_and_completely() {
    let scene = seed_scene("a");
    let settings =
        Settings { method: Method::Border(BorderSettings::default()), ..Settings::new([1000, 777]) };
    let heard = Heard::default();
    // The helper asserts that rows are in order, none twice, none missing.
    let picture = render_with_layers(&scene, &settings, &Run { progress: Some(&heard), ..Run::default() });
    assert_eq!(picture.colors.len(), 777_000);
    assert_eq!(heard.0.load(Ordering::Relaxed), 777);
    assert_eq!(picture.stats.pixels.total, 777_000);
    assert!(picture.colors.iter().flatten().all(|v| v.is_finite() && *v >= 0.0));
}

#[derive(Default)]
struct Heard(std::sync::atomic::AtomicU32);

impl Progress for Heard {
    fn advance(&self, rows: u32) {
        self.0.fetch_add(rows, Ordering::Relaxed);
    }
}

#[test]
fn a_set_cancel_flag_ends_in_cancelled_without_rows() {
    let cancel = AtomicBool::new(true);
    let mut rows: Vec<Rows> = Vec::new();
    let run = Run { cancel: Some(&cancel), ..Run::default() };
    let result = render(&checked(&all_shapes()), &Settings::new([64, 64]), &run, &mut rows);
    assert!(matches!(result, Err(RenderError::Cancelled)), "{result:?}");
    assert!(rows.is_empty());
}

#[test]
fn preparing_is_cancelled_too_and_tried_again_when_asked_again() {
    let renderer = Renderer::new(checked(&all_shapes()));
    let (cancel, camera) = (AtomicBool::new(true), renderer.scene().camera.clone());
    let settings = Settings { accelerator: Accelerator::Grid, ..Settings::new([16, 16]) };
    let mut rows: Vec<Rows> = Vec::new();
    let mut render = |cancel: Option<&AtomicBool>| {
        let run = Run { cancel, ..Run::default() };
        renderer.render(&camera, Window::pixel(3, 4), &settings, &run, &mut rows)
    };
    let result = render(Some(&cancel));
    assert!(matches!(result, Err(RenderError::Cancelled)), "{result:?}");
    assert!(render(None).is_ok());
}

/// Takes one portion of rows, then fails or asks to stop.
struct OnePortion<'a> {
    taken: u32,
    cancel: Option<&'a AtomicBool>,
}

impl Sink for OnePortion<'_> {
    fn transfer(&self) -> Transfer {
        Transfer::Srgb
    }

    fn take(&mut self, rows: &Rows) -> Result<(), SinkError> {
        if self.taken > 0 {
            return Err("the disc is full".into());
        }
        self.taken += rows.count();
        if let Some(flag) = self.cancel {
            flag.store(true, Ordering::Relaxed);
        }
        Ok(())
    }
}

#[test]
fn an_error_of_the_sink_comes_back_and_ends_the_rendering() {
    let mut sink = OnePortion { taken: 0, cancel: None };
    let result = render(&checked(&seed_scene("a")), &Settings::new([16, 4000]), &Run::default(), &mut sink);
    let Err(RenderError::Sink(error)) = result else { panic!("{result:?}") };
    assert_eq!(error.to_string(), "the disc is full");
    assert!((1..4000).contains(&sink.taken));
}

#[test]
fn a_flag_set_in_the_middle_cancels_between_groups_of_bands() {
    let cancel = AtomicBool::new(false);
    let mut sink = OnePortion { taken: 0, cancel: Some(&cancel) };
    let run = Run { threads: 1, cancel: Some(&cancel), ..Run::default() };
    // With 16 tiles side by side each band is a group.
    let result = render(&checked(&seed_scene("a")), &Settings::new([2000, 128 * 3]), &run, &mut sink);
    assert!(matches!(result, Err(RenderError::Cancelled)), "{result:?}");
    assert_eq!(sink.taken, 128);
}

#[test]
fn sizes_and_blocks_out_of_range_are_errors_that_name_them() {
    let message = |settings: &Settings| {
        let mut rows: Vec<Rows> = Vec::new();
        match render(&checked(&all_shapes()), settings, &Run::default(), &mut rows) {
            Err(RenderError::Settings(message)) => message,
            other => panic!("{other:?}"),
        }
    };
    for size in [[0, 5], [5, 0], [(1 << 24) + 1, 1], [1, u32::MAX]] {
        assert!(message(&Settings::new(size)).contains(&format!("{}×{}", size[0], size[1])));
    }
    for block in [0, 129, u32::MAX] {
        let border = BorderSettings { block, ..BorderSettings::default() };
        let selected = PixelSelectedSettings { block, ..PixelSelectedSettings::default() };
        for method in [Method::Border(border), Method::PixelSelected(selected)] {
            let settings = Settings { method, ..Settings::new([8, 8]) };
            assert!(message(&settings).contains(&format!("blocks of {block} samples")));
        }
    }
}

/// One flat surface that fills the picture, without lights and mirrors: the colour is known with the first hit.
fn flat_scene() -> Scene {
    let mut scene = all_shapes();
    scene.lights.clear();
    scene.camera = looking([0.0, 0.0, 5.0], [0.0, 0.0, 0.0], 60.0);
    scene.objects.truncate(1);
    let outline = [[-50.0, -50.0], [50.0, -50.0], [50.0, 50.0], [-50.0, 50.0]];
    let outline = outline.map(|[x, y]| brt_geometry::vec3(x, y, -1.0)).to_vec();
    scene.objects[0].shape = Shape::Polygon { outline, holes: Vec::new() };
    scene
}

/// Paper: P3, P4 (3).
#[test]
fn the_perspective_image_is_made_without_rays_and_spares_the_first_search() {
    let mut scene = flat_scene();
    scene.materials[0].checker = None;
    let size = [130, 70];
    for block in [1, 16] {
        let method = Method::Border(BorderSettings { block, ..BorderSettings::default() });
        let settings = Settings { method, max_depth: Some(0), ..Settings::new(size) };
        let stats = render_with_layers(&scene, &settings, &Run::default()).stats;
        assert_eq!(stats.nodes_visited, 0);
        assert_eq!(stats.rays.total(), stats.pixels.traced);
        assert_eq!(stats.primitive_tests, stats.pixels.traced, "one test for the known first hit");
    }
    let settings = Settings { max_depth: Some(0), ..Settings::new(size) };
    let mut crowded = scene.clone();
    (0..20).for_each(|i| {
        let center = brt_geometry::vec3(f64::from(i), 0.0, -3.0);
        crowded.add(Shape::Sphere { center, radius: 0.4 }, scene.objects[0].material);
    });
    let single = Run { rays: RayOrder::Single, ..Run::default() };
    let full = render_with_layers(&crowded, &settings, &single).stats;
    assert!(full.nodes_visited >= full.pixels.total, "{full:?}");
    assert_eq!(full.rays.total(), full.pixels.total);
    let bundled = render_with_layers(&crowded, &settings, &Run::default()).stats;
    assert!(bundled.nodes_visited * 10 < full.nodes_visited && bundled.rays == full.rays, "{bundled:?}");
}

#[test]
fn layers_alone_cost_no_rays() {
    let scene = all_shapes();
    let stats = |layers| {
        let settings = Settings { layers, ..Settings::new([64, 48]) };
        counts(
            &render_with_layers(&scene, &settings, &Run { rays: RayOrder::Single, ..Run::default() }).stats,
        )
    };
    assert_eq!(stats(Vec::new()), stats(Layer::ALL.to_vec()));
}

/// Whenever it comes: while outlines are painted, too, of which those that are left show nothing of sense.
#[test]
fn a_rendering_that_is_cancelled_ends_without_a_panic_whenever_that_is() {
    let torus = checked(&brt_procedural::find("torus").unwrap().build(Some(2000)).unwrap());
    let certified = Method::Certified(CertifiedSettings::default());
    let settings = Settings { method: certified, ..Settings::new([128, 128]) };
    let renderer = Renderer::new(torus);
    let (camera, window) = (renderer.scene().camera.clone(), settings.whole().unwrap());
    let time = std::time::Instant::now();
    renderer.render(&camera, window, &settings, &Run::default(), &mut Vec::new()).unwrap();
    let whole = time.elapsed();
    let mut cancelled = 0;
    for moment in 0..200 {
        let flag = AtomicBool::new(false);
        std::thread::scope(|scope| {
            scope.spawn(|| {
                std::thread::sleep(whole.mul_f64(f64::from(moment) / 150.0));
                flag.store(true, Ordering::Relaxed);
            });
            let run = Run { threads: 1, cancel: Some(&flag), ..Run::default() };
            let ended = renderer.render(&camera, window, &settings, &run, &mut Vec::new());
            cancelled += u32::from(matches!(ended, Err(RenderError::Cancelled)));
        });
    }
    assert!(cancelled > 20, "{cancelled}");
}
