//! Failures that are known, asserted as such, so that the day they are gone is noticed.
//!
//! They come from rounding where a primitive is not met where it is: the plain search over all primitives believes such
//! hits, boxes do not. No picture that is looked at shows them.

mod common;

use brt_geometry::vec3;
use brt_image::rgb;
use brt_render::Method;
use brt_scene::{Material, Scene, Shape};
use brt_testkit::looking;
use common::{differing, rendered};

/// Balls seen along an axis from a million times their distance from each other: discriminants round by more than the
/// boxes' margin, and the tree's own rounding does not help across an axis.
#[test]
fn balls_a_million_scene_sizes_away_lose_their_rims_in_the_tree() {
    let mut scene = Scene::new(looking([1e6, 0.45, 0.45], [0.0, 0.45, 0.45], 0.000_1));
    let material = Material { ambient: 1.0, ..Material::matte("m", rgb(1.0, 1.0, 1.0)) };
    let material = scene.add_material(material);
    for i in 0..64 {
        let center = vec3(f64::from(i % 4), f64::from(i / 4 % 4), f64::from(i / 16)) * 0.3;
        scene.add(Shape::Sphere { center, radius: 0.05 }, material);
    }
    let size = [400, 400];
    let (full, reference) = (rendered(&scene, Method::Full, size), rendered(&scene, Method::Reference, size));
    let lost = differing(&full, &reference);
    assert!((1..2000).contains(&lost), "{lost} pixels");
}
