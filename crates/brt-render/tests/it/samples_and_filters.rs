//! Several samples a pixel, and how they become one colour.

use brt_image::rgb;
use brt_render::{BorderSettings, CertifiedSettings, Filter, Layer, Method, Run, Samples, Settings};
use brt_scene::Scene;
use brt_testkit::{all_shapes, first_difference, render_to_image, render_with_layers, seed_scene};

/// How many times as wide the picture is whose single samples are those of four or sixteen to a pixel, among others: a
/// pixel's samples stand in as many different columns and rows as there are samples.
const FOUR: usize = 4;
const SIXTEEN: usize = 16;

/// Column and row in that picture of a sample in column `i` and row `j` of `n` × `n`: the next row's samples are one to
/// the right of those above them, the next column's one higher.
fn place_of(n: usize, i: usize, j: usize) -> [usize; 2] {
    [n * i + j, n * j + n - 1 - i]
}

/// The mean of a pixel's 2 × 2 samples, summed as the filter does: in f64, columns first.
fn mean_of_four(fine: &[[f32; 3]], width: usize, x: usize, y: usize) -> [f32; 3] {
    let at = |i: usize, j: usize, c: usize| {
        let [right, down] = place_of(2, i, j);
        f64::from(fine[(FOUR * y + down) * FOUR * width + FOUR * x + right][c])
    };
    std::array::from_fn(|c| {
        let (left, right) = (at(0, 0, c) + at(0, 1, c), at(1, 0, c) + at(1, 1, c));
        ((left + right) * 0.25) as f32
    })
}

#[test]
fn box_of_four_samples_is_the_mean_of_samples_that_share_no_column_and_no_row() {
    let size = [150, 75];
    for scene in [seed_scene("b"), all_shapes()] {
        let fine = Settings::new(size.map(|side| FOUR as u32 * side));
        let (fine, _) = render_to_image(&scene, &fine, &Run::default());
        let mean: Vec<[f32; 3]> = (0..size[0] as usize * size[1] as usize)
            .map(|i| mean_of_four(&fine, 150, i % 150, i / 150))
            .collect();
        let exact = CertifiedSettings { tolerance: 0.0 };
        for method in [Method::Full, Method::ScanLine, Method::Certified(exact)] {
            let settings = Settings { method, samples: Samples::Four, ..Settings::new(size) };
            let (coarse, _) = render_to_image(&scene, &settings, &Run::default());
            let difference = first_difference(size, &mean, &coarse);
            assert!(
                difference.is_none(),
                "{method:?}: {}",
                difference.map(|d| d.to_string()).unwrap_or_default()
            );
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
    let wide = SIXTEEN * 70;
    let fine = Settings::new(size.map(|side| SIXTEEN as u32 * side));
    let (all, _) = render_to_image(&scene, &fine, &Run::default());
    let blurred = picture(Filter::Gaussian, Samples::Sixteen);
    for y in 0..66_usize {
        for x in 0..70_usize {
            // Samples within one pixel of the middle: half a pixel beyond its own on each side, and their shift.
            let reach = |i: usize, end: usize| {
                (SIXTEEN * i).saturating_sub(10)..(SIXTEEN * i + 26).min(SIXTEEN * end)
            };
            let (columns, rows) = (reach(x, 70), reach(y, 66));
            for c in 0..3 {
                let near = rows
                    .clone()
                    .flat_map(|v| columns.clone().map(move |u| (u, v)))
                    .map(|(u, v)| all[v * wide + u][c]);
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
    let settings = Settings { samples: Samples::One, size: [640, 480], ..settings };
    let fine = render_with_layers(&scene, &settings, &Run::default());
    for (x, y) in (0..30).flat_map(|y| (0..40).map(move |x| (x, y))) {
        // Of samples 0 to 3 along a side, 2 begins at the middle.
        let [right, down] = place_of(4, 2, 2).map(|i| i as u32);
        let (i, j) = (coarse.index(x, y), fine.index(16 * x + right, 16 * y + down));
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
