//! Pictures at every SIMD level: their bits are the same.

use brt_geometry::SimdLevel;
use brt_image::Transfer;
use brt_render::{Run, Seconds, Settings, Stats};
use brt_scene::Scene;

use crate::pictures::{Difference, Rendered, render_stored, replay_hint};

/// Pictures of no more samples are rendered at every level.
const SMALL: u64 = 1024;

/// Renders a picture with its layers: a small one at every SIMD level, others at one of them, which size, method and
/// accelerator pick. So a suite of random scenes meets every level and compares them, and takes hardly longer.
///
/// # Panics
/// If the levels differ, or [`render_stored`] panics.
pub fn render_at_levels(scene: &Scene, settings: &Settings, run: &Run) -> Rendered {
    render_stored_at_levels(scene, settings, run, Transfer::Srgb)
}

/// Like [`render_at_levels`], for a picture that is stored with a transfer function.
///
/// # Panics
/// If the levels differ, or [`render_stored`] panics.
pub fn render_stored_at_levels(
    scene: &Scene,
    settings: &Settings,
    run: &Run,
    transfer: Transfer,
) -> Rendered {
    let [width, height] = settings.size;
    let samples = width * height * u64::from(settings.samples.per_pixel());
    if samples <= SMALL {
        return render_stored_at_every_level(scene, settings, run, transfer);
    }
    let picks = (width + height) as usize + settings.method.name().len() + settings.accelerator as usize;
    let simd = SimdLevel::ALL[picks % SimdLevel::ALL.len()];
    render_stored(scene, settings, &Run { simd, ..*run }, transfer)
}

/// Renders a picture with its layers at every SIMD level.
///
/// # Panics
/// If the levels differ, or [`render_stored`] panics.
pub fn render_at_every_level(scene: &Scene, settings: &Settings, run: &Run) -> Rendered {
    render_stored_at_every_level(scene, settings, run, Transfer::Srgb)
}

/// Like [`render_at_every_level`], for a picture that is stored with a transfer function.
///
/// # Panics
/// If the levels differ, or [`render_stored`] panics.
pub fn render_stored_at_every_level(
    scene: &Scene,
    settings: &Settings,
    run: &Run,
    transfer: Transfer,
) -> Rendered {
    let [first, others @ ..] = SimdLevel::ALL;
    let expected = render_stored(scene, settings, &Run { simd: first, ..*run }, transfer);
    for simd in others {
        let actual = render_stored(scene, settings, &Run { simd, ..*run }, transfer);
        if let Some(difference) = any_difference(&expected, &actual) {
            panic!("{first} and {simd} differ: {}", replay_hint(scene, settings, &difference));
        }
    }
    expected
}

/// Where two renderings of one picture differ in any of their bits or counts.
fn any_difference(expected: &Rendered, actual: &Rendered) -> Option<Difference> {
    let counts = |picture: &Rendered| Stats { seconds: Seconds::default(), ..picture.stats };
    expected.first_difference(actual).or_else(|| {
        let (expected, actual) = (counts(expected), counts(actual));
        (expected != actual).then(|| {
            let [expected, actual] = [expected, actual].map(|counts| format!("{counts:?}"));
            Difference { pixel: [0, 0], expected, actual, count: 0 }
        })
    })
}
