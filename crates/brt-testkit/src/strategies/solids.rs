//! Random scenes of solids made of flat faces that share edges, stand on a floor and touch each other.

use brt_geometry::{Vec3, vec3};
use brt_scene::Shape;
use proptest::prelude::*;

use super::coordinate;
use super::scenes::{AnyScene, dull_scene_of};

/// Scenes of a few boxes, wedges, stumps and upturned ones, of which some touch, cut each other or lack a face.
pub fn any_scene_of_solids() -> impl Strategy<Value = AnyScene> {
    dull_scene_of(prop::collection::vec(any_solid(), 1..6).prop_map(|solids| solids.concat()))
}

/// The faces of a solid between two parallel quadrangles, and the number of its material.
fn any_solid() -> impl Strategy<Value = Vec<(Shape, u32)>> {
    let place = (coordinate(2.0), prop_oneof![3 => Just(-1.5), 1 => coordinate(1.0)], coordinate(2.0));
    let size = (coordinate(1.5), coordinate(1.5), coordinate(1.5));
    let turn = prop_oneof![Just(0.0), Just(0.0), 0.0..1.6];
    // Straight, as good as straight, leaning in or out, to a point.
    let taper = prop_oneof![3 => Just(1.0), 1 => Just(1.0 + 1e-9), 1 => Just(1.0 - 1e-5), 2 => 0.0..3.0, 1 => Just(0.0)];
    let lean = prop_oneof![2 => Just(0.0), 1 => -1.0..1.0];
    (place, size, turn, taper, lean, 0_u32..3, 0_usize..12).prop_map(
        |((x, y, z), (wide, tall, deep), turn, taper, lean, material, missing)| {
            let [wide, tall, deep] = [wide, tall, deep].map(|side| side.abs() + 0.05);
            let (sin, cos) = libm::sincos(turn);
            let at = |u: f64, up: f64, v: f64| {
                let scale = 1.0 + up * (taper - 1.0);
                let (u, v) = (u * wide * scale + up * lean, v * deep * scale);
                vec3(x + cos * u + sin * v, y + up * tall, z + cos * v - sin * u)
            };
            let quadrangle =
                |up: f64| [at(-1.0, up, 1.0), at(1.0, up, 1.0), at(1.0, up, -1.0), at(-1.0, up, -1.0)];
            let faces = faces_between(quadrangle(0.0), quadrangle(1.0));
            let is_there = |(i, face): (usize, Vec<Vec3>)| (i != missing).then_some(face);
            let shapes = faces.into_iter().enumerate().filter_map(is_there).filter_map(polygon);
            shapes.map(|shape| (shape, material)).collect()
        },
    )
}

/// The top, the sides and the bottom.
fn faces_between([a, b, c, d]: [Vec3; 4], [e, f, g, h]: [Vec3; 4]) -> [Vec<Vec3>; 6] {
    [
        vec![e, f, g, h],
        vec![a, b, f, e],
        vec![b, c, g, f],
        vec![c, d, h, g],
        vec![d, a, e, h],
        vec![d, c, b, a],
    ]
}

/// Without corners that coincide; `None` where fewer than three are left.
fn polygon(mut outline: Vec<Vec3>) -> Option<Shape> {
    outline.dedup();
    if outline.first() == outline.last() {
        outline.pop();
    }
    (outline.len() > 2).then_some(Shape::Polygon { outline, holes: Vec::new() })
}
