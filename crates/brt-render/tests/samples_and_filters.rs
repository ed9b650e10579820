//! Several samples a pixel, and how they become one colour.

use brt_image::rgb;
use brt_render::{BorderSettings, Filter, Layer, Method, Run, Samples, Settings};
use brt_scene::Scene;
use brt_testkit::{all_shapes, first_difference, render_to_image, render_with_layers, seed_scene};

/// The mean of 2 × 2 samples, summed as the separable filter does: rows first, in f64.
fn mean_of_four(fine: &[[f32; 3]], width: usize, x: usize, y: usize) -> [f32; 3] {
    let at = |dx: usize, dy: usize, c: usize| f64::from(fine[(2 * y + dy) * 2 * width + 2 * x + dx][c]) * 0.5;
    std::array::from_fn(|c| {
        let (upper, lower) = (at(0, 0, c) + at(1, 0, c), at(0, 1, c) + at(1, 1, c));
        (upper * 0.5 + lower * 0.5) as f32
    })
}

#[test]
fn box_of_four_samples_is_the_mean_of_the_picture_of_twice_the_size() {
    // Tiles of 128 samples lie alike in both pictures, so even blocks and what is filled are the same.
    let size = [150, 75];
    for scene in [seed_scene("b"), all_shapes()] {
        for method in [Method::Full, Method::Border(BorderSettings::default())] {
            let settings = Settings { method, samples: Samples::Four, ..Settings::new(size) };
            let (coarse, coarse_stats) = render_to_image(&scene, &settings, &Run::default());
            let settings = Settings { samples: Samples::One, size: [300, 150], ..settings };
            let (fine, fine_stats) = render_to_image(&scene, &settings, &Run::default());
            let mean: Vec<[f32; 3]> = (0..size[0] as usize * size[1] as usize)
                .map(|i| mean_of_four(&fine, 150, i % 150, i / 150))
                .collect();
            let difference = first_difference(size, &mean, &coarse);
            assert!(
                difference.is_none(),
                "{method:?}: {}",
                difference.map(|d| d.to_string()).unwrap_or_default()
            );
            assert_eq!(coarse_stats.pixels, fine_stats.pixels);
            assert_eq!(coarse_stats.rays, fine_stats.rays);
        }
    }
}

fn empty_scene(background: brt_image::Rgb) -> Scene {
    let mut scene = all_shapes();
    scene.objects.clear();
    scene.background = background;
    scene
}

fn units_apart(a: f32, b: f32) -> u32 {
    a.to_bits().abs_diff(b.to_bits())
}

#[test]
fn one_colour_stays_that_colour_through_every_filter() {
    let color = [0.1, 0.7, 1.0 / 3.0];
    let scene = empty_scene(color.into());
    for samples in Samples::ALL {
        for filter in [Filter::Box, Filter::Gaussian] {
            for method in [Method::Full, Method::Border(BorderSettings::default())] {
                let settings = Settings { samples, filter, method, ..Settings::new([65, 40]) };
                let (colors, _) = render_to_image(&scene, &settings, &Run::default());
                let expected = color.map(|c| c as f32);
                let worst = colors.iter().flat_map(|p| (0..3).map(|c| units_apart(p[c], expected[c]))).max();
                assert!(worst <= Some(1), "{samples:?} {filter:?} {method:?}: {worst:?} units");
            }
        }
    }
}

#[test]
fn a_gaussian_stays_between_the_extremes_of_the_samples_and_blurs_across_tiles() {
    let scene = seed_scene("c");
    let size = [70, 66];
    let picture = |filter, samples| {
        let settings = Settings { filter, samples, ..Settings::new(size) };
        render_to_image(&scene, &settings, &Run::default()).0
    };
    let fine = Settings::new([280, 264]);
    let (all, _) = render_to_image(&scene, &fine, &Run::default());
    let blurred = picture(Filter::Gaussian, Samples::Sixteen);
    for y in 0..66_usize {
        for x in 0..70_usize {
            // Samples within one pixel of the middle: half a pixel beyond its own on each side.
            let (left, right) = ((4 * x).saturating_sub(2), (4 * x + 6).min(280));
            let (top, bottom) = ((4 * y).saturating_sub(2), (4 * y + 6).min(264));
            for c in 0..3 {
                let near = (top..bottom)
                    .flat_map(|v| (left..right).map(move |u| (u, v)))
                    .map(|(u, v)| all[v * 280 + u][c]);
                let (least, greatest) = near.fold((f32::INFINITY, 0.0_f32), |(a, b), v| (a.min(v), b.max(v)));
                let value = blurred[y * 70 + x][c];
                let rounding = 4.0 * f32::EPSILON * greatest;
                assert!(value >= least - rounding && value <= greatest + rounding, "{x},{y},{c}: {value}");
            }
        }
    }
    assert_ne!(blurred, picture(Filter::Box, Samples::Sixteen));
}

#[test]
fn layers_show_the_sample_next_to_the_middle_of_a_pixel() {
    let scene = all_shapes();
    let layers = vec![Layer::Surface, Layer::Depth];
    let settings = Settings { samples: Samples::Sixteen, layers, ..Settings::new([40, 30]) };
    let coarse = render_with_layers(&scene, &settings, &Run::default());
    let settings = Settings { samples: Samples::One, size: [160, 120], ..settings };
    let fine = render_with_layers(&scene, &settings, &Run::default());
    for (x, y) in (0..30).flat_map(|y| (0..40).map(move |x| (x, y))) {
        // Of samples 0 to 3 along a side, 2 begins at the middle.
        let (i, j) = (coarse.index(x, y), fine.index(4 * x + 2, 4 * y + 2));
        assert_eq!((coarse.surface[i], coarse.depth[i]), (fine.surface[j], fine.depth[j]));
    }
}

#[test]
fn white_background_is_white() {
    let scene = empty_scene(rgb(1.0, 1.0, 1.0));
    for samples in Samples::ALL {
        let settings = Settings { samples, ..Settings::new([9, 9]) };
        assert!(render_to_image(&scene, &settings, &Run::default()).0.iter().all(|c| *c == [1.0; 3]));
    }
}
