//! Scenes at the limits of what can be computed: the exact methods agree bit for bit, and `certified` keeps its promise,
//! with every accelerator. Longer: `cargo xtask certify-views --kind all`, and the fuzz target `render_tiny`.

use std::fs;
use std::path::Path;

use brt_geometry::SimdLevel;
use brt_image::Transfer;
use brt_render::{Accelerator, CertifiedSettings, Method, Run, Settings};
use brt_testkit::{
    AnyScene, HardKind, Trial, any_doubled_scene, any_hard_scene, broken_promise, first_difference,
    render_to_image, replay_hint, seeded, tiny_trial,
};
use proptest::prelude::*;

fn any_trial() -> impl Strategy<Value = Trial> {
    let tolerance = prop_oneof![Just(1.0), 0.05..3.0];
    let transfer = prop::sample::select(vec![Transfer::Linear, Transfer::Srgb]);
    let accelerator = prop::sample::select(Accelerator::ALL.to_vec());
    let simd = prop::sample::select(SimdLevel::ALL.to_vec());
    (8_u32..80, 8_u32..60, accelerator, simd, tolerance, transfer).prop_map(
        |(width, height, accelerator, simd, tolerance, transfer)| Trial {
            size: [width, height],
            accelerator,
            simd,
            certified: CertifiedSettings { tolerance },
            transfer,
        },
    )
}

macro_rules! promises_hold_for {
    ($($name:ident: $kind:ident,)*) => {$(
        proptest! {
            #![proptest_config(seeded(1987, 400))]

            #[test]
            fn $name(AnyScene(scene) in any_hard_scene(HardKind::$kind), trial in any_trial()) {
                let broken = broken_promise(&scene, &trial);
                prop_assert!(broken.is_none(), "{}", broken.unwrap_or_default());
            }
        }
    )*};
}

promises_hold_for! {
    of_tiny_things_seen_from_far_away: Tiny,
    of_tiny_things_seen_in_mirrors: Mirrored,
    of_tiny_things_that_throw_shadows: Shadow,
    of_things_that_coincide_or_touch: Coincident,
    of_scenes_far_from_the_origin: Offset,
    of_needles: Long,
    of_faces_that_are_nearly_one_far_away: Gaps,
    of_anything_at_any_scale: Mixed,
}

proptest! {
    #![proptest_config(seeded(1989, 400))]

    /// Faces that are given twice neither shade each other nor flicker.
    #[test]
    fn what_is_there_twice_looks_as_if_it_were_there_once(
        [AnyScene(once), AnyScene(twice)] in any_doubled_scene(),
        accelerator in prop::sample::select(Accelerator::ALL.to_vec()),
    ) {
        let settings = Settings { accelerator, ..Settings::new([40, 30]) };
        for method in [Method::Reference, Method::Full] {
            let settings = Settings { method, ..settings.clone() };
            let run = Run { threads: 1, ..Run::default() };
            let [once, twice_seen] = [&once, &twice].map(|scene| render_to_image(scene, &settings, &run).0);
            let difference = first_difference(settings.size, &once, &twice_seen);
            let hint = difference.map(|difference| replay_hint(&twice, &settings, &difference));
            prop_assert!(hint.is_none(), "{}", hint.unwrap_or_default());
        }
    }
}

/// What the fuzzer found worth keeping: bytes that reach much of the code.
#[test]
fn promises_hold_for_the_corpus_of_the_fuzzer() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/corpus/render_tiny");
    let mut tried = 0;
    for file in fs::read_dir(folder).unwrap() {
        let path = file.unwrap().path();
        let (scene, trial) = tiny_trial(&fs::read(&path).unwrap()).unwrap();
        let broken = broken_promise(&scene, &trial);
        assert!(broken.is_none(), "{}: {}", path.display(), broken.unwrap_or_default());
        tried += 1;
    }
    assert!(tried > 50, "{tried} files");
}
