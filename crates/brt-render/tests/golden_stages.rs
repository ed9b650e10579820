//! Every product of the steps as a picture that must not change by a code.
//!
//! The first stage that differs is reported. `UPDATE_GOLDEN=1` writes new images; look at them before committing.

use std::path::Path;

use brt_render::{BorderSettings, Layer, Method, Run, Settings};
use brt_scene::Scene;
use brt_testkit::{Golden, Stage, all_shapes, render_with_layers, seed_scene, stage_colors};

const SIZE: [u32; 2] = [96, 64];

fn check_stages(name: &str, scene: &Scene) {
    let golden = Golden::new(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden"));
    let method = Method::Border(BorderSettings::default());
    let settings = Settings { method, layers: Layer::ALL.to_vec(), ..Settings::new(SIZE) };
    let rendered = render_with_layers(scene, &settings, &Run::default());
    for stage in Stage::ALL {
        let file = format!("{name}.{}", stage.name());
        if let Err(error) = golden.check(&file, SIZE, &stage_colors(&rendered, stage)) {
            panic!(
                "{error}\nThe first stage that differs is {}; later ones are not looked at.",
                stage.name()
            );
        }
    }
}

#[test]
fn seed_a_looks_as_it_did() {
    check_stages("seed-a", &seed_scene("a"));
}

#[test]
fn seed_b_looks_as_it_did() {
    check_stages("seed-b", &seed_scene("b"));
}

#[test]
fn seed_c_looks_as_it_did() {
    check_stages("seed-c", &seed_scene("c"));
}

#[test]
fn all_shapes_look_as_they_did() {
    check_stages("all-shapes", &all_shapes());
}
