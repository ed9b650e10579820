//! Pictures and layers that must not change by a code, painted as `--layers` paints them.
//!
//! The first product that differs is reported. `UPDATE_GOLDEN=1 cargo test -p brt-render --test it -- golden counters`
//! writes new images and counts; look at them before committing.

use std::path::Path;

use brt_image::Transfer;
use brt_procedural as procedural;
use brt_render::{
    BorderSettings, CertifiedSettings, Layer, LayerPainter, Method, Rows, Run, Settings, render,
};
use brt_scene::Scene;
use brt_testkit::{Golden, all_shapes, checked, seed_scene};

/// Holds the layers, in this order, and then the picture against golden images.
fn check(name: &str, scene: &Scene, settings: &Settings) {
    let golden = Golden::new(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden"));
    let mut rows: Vec<Rows> = Vec::new();
    render(&checked(scene), settings, &Run::default(), &mut rows).unwrap();
    let painter = LayerPainter::new(scene);
    let layers = settings.layers.iter().enumerate().map(|(i, layer)| {
        let colors = rows.iter().flat_map(|rows| painter.colors(&rows.layers[i])).collect();
        (layer.name(), layer.transfer(), colors)
    });
    let picture = || rows.iter().flat_map(|rows| rows.colors.iter().copied()).collect();
    let products = layers.chain(std::iter::once_with(|| ("picture", Transfer::Srgb, picture())));
    for (product, transfer, colors) in products {
        let colors: Vec<[f32; 3]> = colors;
        if let Err(error) = golden.check(&format!("{name}.{product}"), settings.size, &colors, transfer) {
            panic!("{error}\nThe first product that differs is {product}; later ones are not looked at.");
        }
    }
}

/// Every step of `border`.
fn check_border(name: &str, scene: &Scene) {
    let method = Method::Border(BorderSettings::default());
    let layers = vec![Layer::Surface, Layer::Depth, Layer::Normal, Layer::State, Layer::History];
    check(name, scene, &Settings { method, layers, ..Settings::new([96, 64]) });
}

/// What `certified` proves, and its picture.
fn check_certified(name: &str, scene: &Scene) {
    let method = Method::Certified(CertifiedSettings::default());
    let settings = Settings { method, layers: vec![Layer::Certificates], ..Settings::new([160, 160]) };
    check(&format!("certified-{name}"), scene, &settings);
}

fn named(name: &str) -> Scene {
    procedural::find(name).unwrap().build(None).unwrap()
}

#[test]
fn seed_a_looks_as_it_did() {
    check_border("seed-a", &seed_scene("a"));
    check_certified("seed-a", &seed_scene("a"));
}

#[test]
fn seed_b_looks_as_it_did() {
    check_border("seed-b", &seed_scene("b"));
    check_certified("seed-b", &seed_scene("b"));
}

#[test]
fn seed_c_looks_as_it_did() {
    check_border("seed-c", &seed_scene("c"));
    check_certified("seed-c", &seed_scene("c"));
}

#[test]
fn all_shapes_look_as_they_did() {
    check_border("all-shapes", &all_shapes());
    check_certified("all-shapes", &all_shapes());
}

#[test]
fn blocks_look_as_they_did() {
    check_certified("blocks", &named("blocks"));
}

#[test]
fn the_torus_looks_as_it_did() {
    check_certified("torus", &named("torus"));
}

#[test]
fn the_adversary_looks_as_it_did() {
    check_certified("adversary", &named("adversary"));
}
