//! The scenes of the paper are there, with its counts.

use crate::common::project_file;
use brt_formats::{Limits, load};
use brt_scene::{Scene, Shape};

fn seed(name: &str) -> Scene {
    let path = project_file(&format!("scenes/seed/{name}.toml"));
    let loaded = load(&path, &Limits::default()).unwrap_or_else(|error| panic!("{error}"));
    assert!(loaded.report.diagnostics.is_empty());
    loaded.scene.into_inner()
}

fn mirrors(scene: &Scene, kind: &str) -> usize {
    let is_mirror = |material: brt_scene::MaterialId| scene.materials[material.0 as usize].reflection > 0.0;
    scene.objects.iter().filter(|o| o.shape.kind() == kind && is_mirror(o.material)).count()
}

/// Paper: P7.
#[test]
fn a_has_two_mirror_planes_and_a_mirror_ball_of_four() {
    let a = seed("a");
    assert_eq!(a.objects.len(), 4);
    assert_eq!((mirrors(&a, "plane"), mirrors(&a, "sphere")), (2, 1));
    assert_eq!((a.max_depth, a.size), (5, None));
}

#[test]
fn b_has_49_mirror_balls_of_fifty() {
    let b = seed("b");
    assert_eq!(b.objects.len(), 50);
    assert_eq!(mirrors(&b, "sphere"), 49);
}

#[test]
fn c_has_57_mirror_polygons_of_71() {
    let c = seed("c");
    assert_eq!(c.objects.len(), 71);
    assert!(c.objects.iter().all(|o| matches!(o.shape, Shape::Polygon { .. })));
    assert_eq!(mirrors(&c, "polygon"), 57);
}
