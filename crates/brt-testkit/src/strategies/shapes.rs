//! Random shapes, a few units large and around the origin.

use std::f64::consts::TAU;

use brt_geometry::Vec3;
use brt_image::rgb;
use brt_scene::{Mesh, Shape};
use proptest::prelude::*;

use super::{coordinate, direction, point};

/// Any shape.
pub fn any_shape() -> impl Strategy<Value = Shape> {
    prop_oneof![
        3 => (point(3.0), 0.05..1.5).prop_map(|(center, radius)| Shape::Sphere { center, radius }),
        1 => (direction(), coordinate(4.0)).prop_map(|(normal, distance)| Shape::Plane { normal, distance }),
        2 => convex_polygon(),
        2 => star_polygon(),
        1 => (point(3.0), direction(), 0.1..2.0)
            .prop_map(|(center, normal, radius)| Shape::Disc { center, normal, radius }),
        2 => cylinder(),
        2 => cone(),
        2 => height_field(),
        1 => tetrahedron(),
    ]
}

fn axis() -> impl Strategy<Value = (Vec3, Vec3)> {
    (point(3.0), direction(), 0.2..2.0).prop_map(|(base, along, length)| (base, base + along * length))
}

fn cylinder() -> impl Strategy<Value = Shape> {
    (axis(), 0.05..1.0, any::<bool>()).prop_map(|((base, top), radius, capped)| Shape::Cylinder {
        base,
        top,
        radius,
        capped,
    })
}

fn cone() -> impl Strategy<Value = Shape> {
    let top_radius = prop_oneof![Just(0.0), 0.05..1.0];
    (axis(), 0.05..1.0, top_radius, any::<bool>(), any::<bool>()).prop_map(
        |((base, top), wide, narrow, capped, turned)| {
            let (base_radius, top_radius) = if turned { (narrow, wide) } else { (wide, narrow) };
            Shape::Cone { base, base_radius, top, top_radius, capped }
        },
    )
}

/// Points around a centre in a plane; `radius` says how far out the one at this share of the turn lies.
fn ring(center: Vec3, normal: Vec3, count: usize, radius: impl Fn(usize) -> f64) -> Vec<Vec3> {
    let (u, v) = normal.try_normalize().unwrap_or_default().tangents();
    let corner = |i: usize| {
        let angle = TAU * i as f64 / count as f64;
        center + (u * libm::cos(angle) + v * libm::sin(angle)) * radius(i)
    };
    (0..count).map(corner).collect()
}

fn convex_polygon() -> impl Strategy<Value = Shape> {
    (point(3.0), direction(), 3_usize..8, 0.1..2.0).prop_map(|(center, normal, count, radius)| {
        Shape::Polygon { outline: ring(center, normal, count, |_| radius), holes: Vec::new() }
    })
}

/// A star with three to seven points, concave, with or without a hole.
fn star_polygon() -> impl Strategy<Value = Shape> {
    (point(3.0), direction(), 3_usize..8, 0.3..2.0, 0.35..0.9, any::<bool>()).prop_map(
        |(center, normal, points, radius, dent, has_hole)| {
            let reach = |i: usize| if i.is_multiple_of(2) { radius } else { radius * dent };
            let outline = ring(center, normal, 2 * points, reach);
            let holes = if has_hole { vec![ring(center, normal, 4, |_| 0.1 * radius)] } else { Vec::new() };
            Shape::Polygon { outline, holes }
        },
    )
}

/// A bumpy square of triangles, smooth or flat, with or without colours of its points, with some triangles that have no area.
fn height_field() -> impl Strategy<Value = Shape> {
    (point(2.5), direction(), 1_u32..5, prop::collection::vec(-0.4..0.4, 25), any::<[bool; 3]>()).prop_map(
        |(center, normal, cells, heights, [is_smooth, is_colored, is_textured])| {
            let up = normal.try_normalize().unwrap_or_default();
            let (u, v) = up.tangents();
            let side = cells + 1;
            let at = |i: u32| {
                let (x, y) = (f64::from(i % side), f64::from(i / side));
                center + u * (0.5 * x) + v * (0.5 * y) + up * heights[i as usize]
            };
            let positions: Vec<Vec3> = (0..side * side).map(at).collect();
            let normals = if is_smooth {
                (0..side * side).map(|i| up + u * heights[i as usize] - v * heights[i as usize]).collect()
            } else {
                Vec::new()
            };
            let cell = |i: u32| {
                let a = i / cells * side + i % cells;
                [[a, a + 1, a + side], [a + 1, a + side + 1, a + side]]
            };
            let mut triangles: Vec<[u32; 3]> = (0..cells * cells).flat_map(cell).collect();
            triangles.push([0, 1, 0]);
            let color = |i: u32| rgb(0.5 + heights[i as usize], 0.5 - heights[i as usize], 0.7);
            let colors = if is_colored { (0..side * side).map(color).collect() } else { Vec::new() };
            let texcoords = if is_textured {
                (0..side * side).map(|i| [f64::from(i % side) * 0.4, heights[i as usize]]).collect()
            } else {
                Vec::new()
            };
            Shape::from(Mesh { positions, normals, colors, texcoords, triangles })
        },
    )
}

/// A closed mesh with flat faces.
fn tetrahedron() -> impl Strategy<Value = Shape> {
    (point(2.5), prop::array::uniform3(0.2..2.0)).prop_map(|(corner, [x, y, z])| {
        let offsets = [[0.0; 3], [x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]];
        Shape::from(Mesh {
            positions: offsets.map(|o| corner + Vec3::from(o)).to_vec(),
            normals: Vec::new(),
            triangles: vec![[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]],
            ..Mesh::default()
        })
    })
}
