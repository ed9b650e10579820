//! A window has the bits of the whole picture, however little of it is rendered and however large it is.

use std::sync::atomic::{AtomicU64, Ordering};

use brt_render::{
    Accelerator, Backdrop, BorderSettings, CertifiedSettings, CheckedPixels, Filter, Layer, Method,
    PencilSettings, PixelSelectedSettings, RenderError, Renderer, Rows, Run, Samples, Settings, Window,
    thread_pool,
};
use brt_scene::Scene;
use brt_testkit::{
    all_shapes, any_mesh_scene, any_scene, checked, render_window, render_with_layers, seed_scene, seeded,
};
use proptest::prelude::*;
use rayon::prelude::*;

fn any_method() -> impl Strategy<Value = Method> {
    let border = Method::Border(BorderSettings::default());
    prop_oneof![
        6 => Just(Method::Certified(CertifiedSettings::default())),
        1 => Just(Method::Reference),
        2 => Just(Method::Full),
        1 => Just(Method::ItemBuffer),
        1 => Just(Method::ScanLine),
        1 => Just(Method::Pencil(PencilSettings::default())),
        1 => Just(Method::PixelSelected(PixelSelectedSettings::default())),
        2 => Just(border),
    ]
}

prop_compose! {
    fn any_settings()(
        method in any_method(),
        samples in prop::sample::select(vec![Samples::One, Samples::Four, Samples::Sixteen]),
        filter in prop::sample::select(vec![Filter::Box, Filter::Gaussian]),
        accelerator in prop::sample::select(Accelerator::ALL.to_vec()),
        backdrop in prop::sample::select(vec![Backdrop::Scene, Backdrop::Transparent]),
        width in 1_u32..300,
        height in 1_u32..300,
    ) -> Settings {
        // As many samples whatever there are in a pixel, and several tiles.
        let side = |pixels: u32| (pixels / samples.per_side()).max(1);
        Settings {
            method,
            samples,
            filter,
            accelerator,
            backdrop,
            layers: Layer::ALL.to_vec(),
            ..Settings::new([side(width), side(height)])
        }
    }
}

/// A window by its place and size as shares of the picture's.
fn window_of([width, height]: [u64; 2], [x, y, w, h]: [f64; 4]) -> Window {
    let span = |side: u64, first: f64, share: f64| {
        let first = (first * side as f64) as u64;
        (first, 1 + (share * (side - first - 1) as f64) as u32)
    };
    let ((x, width), (y, height)) = (span(width, x, w), span(height, y, h));
    Window { x, y, width, height }
}

fn assert_crop(scene: &Scene, settings: &Settings, shares: [f64; 4]) {
    let run = Run { threads: 1, ..Run::default() };
    let window = window_of(settings.size, shares);
    let part = render_window(&Renderer::new(checked(scene)), window, settings, &run);
    let whole = render_with_layers(scene, settings, &run);
    let expected = whole.cropped(window.x as u32, window.y as u32, [window.width, window.height]);
    if let Some(difference) = expected.first_difference(&part) {
        panic!("{window}: {difference}\nwith {settings:?}");
    }
}

proptest! {
    #![proptest_config(seeded(1, 60))]

    #[test]
    fn any_window_is_the_crop_of_the_whole(
        scene in prop_oneof![3 => any_scene(5), 1 => any_mesh_scene()],
        settings in any_settings(),
        shares in prop::array::uniform4(0.0..1.0),
    ) {
        assert_crop(&scene.0, &settings, shares);
    }
}

/// Pixels in the first row of every 16 of the window are checked, wherever it lies.
#[test]
fn rows_of_a_window_are_checked_as_those_of_a_picture() {
    let renderer = Renderer::new(checked(&seed_scene("a")));
    let method = Method::Certified(CertifiedSettings::default());
    let settings = Settings { method, checked: CheckedPixels::Rows, ..Settings::new([200, 200]) };
    let window = Window { x: 37, y: 101, width: 90, height: 40 };
    let run = Run::default();
    let checked = render_window(&renderer, window, &settings, &run);
    let full = render_window(&renderer, window, &Settings { method: Method::Full, ..settings.clone() }, &run);
    for row in [0, 16, 32] {
        let row = checked.index(0, row)..checked.index(0, row) + 90;
        assert_eq!(checked.full[row.clone()], full.colors[row]);
    }
}

/// Positions of samples in a picture of 10⁶ × 10⁶ pixels and more are exact, and as they are in any window.
#[test]
fn windows_of_a_vast_picture_are_parts_of_each_other() {
    let renderer = Renderer::new(checked(&seed_scene("c")));
    for (side, samples) in [(1_000_000, Samples::Four), (1 << 40, Samples::Sixteen)] {
        let method = Method::Certified(CertifiedSettings::default());
        let layers = Layer::ALL.to_vec();
        let settings = Settings { method, samples, layers, ..Settings::of_virtual([side; 2]) };
        let (x, y) = (side / 2 + 77, side / 5 * 3 + 13);
        let large = Window { x, y, width: 100, height: 70 };
        let whole = render_window(&renderer, large, &settings, &Run::default());
        for [left, down, width, height] in [[0, 0, 1, 1], [99, 69, 1, 1], [31, 5, 40, 65], [3, 60, 90, 9]] {
            let window = Window { x: x + u64::from(left), y: y + u64::from(down), width, height };
            let part = render_window(&renderer, window, &settings, &Run::default());
            let expected = whole.cropped(left, down, [width, height]);
            assert_eq!(expected.first_difference(&part), None, "{window} of {side}²");
        }
    }
}

/// The middle of a vast picture shows what a small one shows there.
#[test]
fn a_vast_picture_shows_the_same_scene() {
    let renderer = Renderer::new(checked(&seed_scene("c")));
    let small = render_with_layers(renderer.scene(), &Settings::new([101, 101]), &Run::default());
    // The middle pixel of 10001 × 10001 that lie in each pixel of the small picture.
    let vast = Settings::of_virtual([101 * 10_001; 2]);
    for [x, y] in [[50, 50], [20, 70], [3, 99]] {
        let middle = |pixel: u64| pixel * 10_001 + 5_000;
        let window = Window::pixel(middle(x), middle(y));
        let pixel = render_window(&renderer, window, &vast, &Run::default()).colors[0];
        let expected = small.colors[small.index(x as u32, y as u32)];
        let differs = pixel.iter().zip(expected).any(|(a, b)| (a - b).abs() > 1e-5);
        assert!(!differs, "{x},{y}: {pixel:?} instead of {expected:?}");
    }
}

#[test]
fn a_scene_is_prepared_once_for_all_windows() {
    let renderer = Renderer::new(checked(&all_shapes()));
    let copy = renderer.clone();
    let prepared = |renderer: &Renderer| {
        std::ptr::from_ref(renderer.prepared(Accelerator::Bvh, &Run::default()).unwrap())
    };
    assert_eq!(prepared(&renderer), prepared(&copy));
}

#[test]
fn threads_that_are_lent_render_the_same_picture() {
    let scene = all_shapes();
    let settings = Settings::new([150, 140]);
    let pool = thread_pool(2).unwrap();
    let own = render_with_layers(&scene, &settings, &Run::default());
    let lent = render_with_layers(&scene, &settings, &Run { pool: Some(&pool), ..Run::default() });
    assert_eq!(own.first_difference(&lent), None);
}

#[test]
fn windows_and_cameras_that_cannot_be_are_refused() {
    let scene = checked(&all_shapes());
    let mut camera = scene.camera.clone();
    let renderer = Renderer::new(scene);
    let settings = Settings::new([100, 80]);
    let mut rows: Vec<Rows> = Vec::new();
    for window in [
        Window { x: 0, y: 0, width: 0, height: 5 },
        Window { x: 99, y: 0, width: 2, height: 5 },
        Window { x: 0, y: u64::MAX, width: 1, height: 1 },
    ] {
        let refused = renderer.render(&camera, window, &settings, &Run::default(), &mut rows);
        let Err(RenderError::Settings(message)) = refused else { panic!("{window}: {refused:?}") };
        assert!(message.contains("100×80"), "{message}");
    }
    camera.look_at = camera.eye;
    let refused = renderer.render(&camera, Window::pixel(0, 0), &settings, &Run::default(), &mut rows);
    assert!(matches!(refused, Err(RenderError::Camera(_))), "{refused:?}");
    assert!(rows.is_empty());
}

/// Counts rows as a command shows them.
struct Count(AtomicU64);

impl brt_render::Progress for Count {
    fn advance(&self, rows: u32) {
        self.0.fetch_add(u64::from(rows), Ordering::Relaxed);
    }
}

#[test]
fn progress_is_of_the_windows_rows() {
    let renderer = Renderer::new(checked(&all_shapes()));
    let count = Count(AtomicU64::new(0));
    let window = Window { x: 10, y: 120, width: 30, height: 20 };
    render_window(
        &renderer,
        window,
        &Settings::new([300, 300]),
        &Run { progress: Some(&count), ..Run::default() },
    );
    assert_eq!(count.0.into_inner(), 20);
}

/// A thread of a pool that waits for the threads that prepare a scene must not take up the next window meanwhile.
#[test]
fn windows_may_be_rendered_from_any_pool() {
    let torus = brt_procedural::find("torus").unwrap().build(Some(20_000)).unwrap();
    let torus = checked(&torus);
    let (done, ended) = std::sync::mpsc::channel();
    std::thread::spawn(move || {
        let callers = thread_pool(3).unwrap();
        for lent in [None, Some(&callers)] {
            let renderer = Renderer::new(torus.clone());
            let run = Run { threads: 2, pool: lent, ..Run::default() };
            let settings = Settings::new([64, 64]);
            callers.install(|| {
                (0..64_u64).into_par_iter().for_each(|i| {
                    render_window(&renderer, Window::pixel(i, i), &settings, &run);
                });
            });
        }
        done.send(()).unwrap();
    });
    let minutes = std::time::Duration::from_secs(240);
    assert!(ended.recv_timeout(minutes).is_ok(), "it waits for itself");
}
