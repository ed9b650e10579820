//! What all methods promise of any scene, tried on one: the same bits, or within the tolerance.

use brt_geometry::SimdLevel;
use brt_image::Transfer;
use brt_render::{Accelerator, CertifiedSettings, Layer, Method, RayOrder, Run, SampleState, Settings};
use brt_scene::Scene;

use crate::pictures::{Difference, Rendered, render_stored, replay_hint};

/// How a scene is tried.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trial {
    /// Width and height.
    pub size: [u32; 2],
    /// What saves tests of primitives.
    pub accelerator: Accelerator,
    /// Which vector instructions are used.
    pub simd: SimdLevel,
    /// How far filled pixels may be off.
    pub certified: CertifiedSettings,
    /// How the picture is stored: what the tolerance is measured by.
    pub transfer: Transfer,
}

/// What a scene that is fit to be rendered breaks, in words, with the scene itself; `None` if nothing:
///
/// * `full`, ray by ray and in bundles, gives the bits of `reference`;
/// * `certified` is within its tolerance of `full`, and gives its bits where it fills nothing;
/// * with tolerance 0 it gives its bits everywhere.
pub fn broken_promise(scene: &Scene, trial: &Trial) -> Option<String> {
    let settings = |method| Settings { method, accelerator: trial.accelerator, ..Settings::new(trial.size) };
    let rendered = |settings: &Settings, rays| {
        let run = Run { threads: 1, rays, simd: trial.simd, ..Run::default() };
        render_stored(scene, settings, &run, trial.transfer)
    };
    let reference = rendered(&settings(Method::Reference), RayOrder::Single).colors;
    let check = |what: &str, settings: &Settings, colors: &[[f32; 3]], is_kept: &dyn Fn(usize) -> bool| {
        let broken = || (0..colors.len()).filter(|&i| !is_kept(i));
        let first = broken().next()?;
        let width = settings.size[0];
        let difference = Difference {
            pixel: [first as u64 % width, first as u64 / width].map(|place| place as u32),
            expected: format!("{:?}", reference[first]),
            actual: format!("{:?}", colors[first]),
            count: broken().count(),
        };
        Some(format!("{what}: {}", replay_hint(scene, settings, &difference)))
    };
    for rays in [RayOrder::Single, RayOrder::Bundled] {
        let settings = settings(Method::Full);
        let colors = rendered(&settings, rays).colors;
        let name = format!("{rays:?} full");
        let is_same = |i: usize| same_color(colors[i], reference[i]);
        if let broken @ Some(_) = check(&name, &settings, &colors, &is_same) {
            return broken;
        }
    }
    [trial.certified, CertifiedSettings { tolerance: 0.0 }].into_iter().find_map(|certified| {
        let settings = Settings { layers: vec![Layer::State], ..settings(Method::Certified(certified)) };
        let picture = rendered(&settings, RayOrder::Single);
        let is_kept = |i: usize| is_kept(trial.transfer, certified, &picture, &reference, i);
        check("certified", &settings, &picture.colors, &is_kept)
    })
}

fn is_kept(
    transfer: Transfer,
    certified: CertifiedSettings,
    picture: &Rendered,
    exact: &[[f32; 3]],
    i: usize,
) -> bool {
    let CertifiedSettings { tolerance } = certified;
    let (ours, exact) = (picture.colors[i], exact[i]);
    let is_filled = picture.state[i] == SampleState::Filled;
    same_color(ours, exact)
        || is_filled && tolerance > 0.0 && greatest_error(transfer, ours, exact) <= tolerance
}

/// The greatest difference of any channel of two linear colours in levels of 255 of the stored values, before rounding.
pub fn greatest_error(transfer: Transfer, a: [f32; 3], b: [f32; 3]) -> f64 {
    let stored = |x: f32| 255.0 * transfer.encode(f64::from(x));
    let channel = |i: usize| if a[i] == b[i] { 0.0 } else { (stored(a[i]) - stored(b[i])).abs() };
    (0..3).map(channel).fold(0.0, f64::max)
}

/// The same bits, or no number in both: infinitely bright scenes are no picture, but none may be more wrong than another.
fn same_color(a: [f32; 3], b: [f32; 3]) -> bool {
    (0..3).all(|i| a[i].to_bits() == b[i].to_bits() || a[i].is_nan() && b[i].is_nan())
}
