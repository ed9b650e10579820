//! Shapes of any kind that fill a ball around a point.

use std::f64::consts::TAU;

use brt_geometry::Vec3;
use brt_image::rgb;
use brt_scene::{Mesh, Shape};

use super::Choices;

/// Any bounded shape around `center`, about `radius` large.
pub(super) fn any(choices: &mut Choices, center: Vec3, radius: f64) -> Shape {
    match choices.below(10) {
        0 | 1 => Shape::Sphere { center, radius },
        2 => Shape::Disc { center, normal: choices.direction(), radius },
        3 => polygon(choices, center, radius),
        4 => star(choices, center, radius),
        5 | 6 => round(choices, center, radius),
        7 => cuboid(center, Vec3::splat(0.6 * radius)),
        8 => slab(choices, center, radius),
        _ => sheet(choices, center, radius),
    }
}

/// Corners around a centre.
fn ring(center: Vec3, normal: Vec3, count: usize, reach: impl Fn(usize) -> f64) -> Vec<Vec3> {
    let (u, v) = normal.tangents();
    let corner = |i: usize| {
        let (sin, cos) = libm::sincos(TAU * i as f64 / count as f64);
        center + (u * cos + v * sin) * reach(i)
    };
    (0..count).map(corner).collect()
}

/// A convex polygon.
pub(super) fn polygon(choices: &mut Choices, center: Vec3, radius: f64) -> Shape {
    let count = 3 + choices.below(4);
    Shape::Polygon { outline: ring(center, choices.direction(), count, |_| radius), holes: Vec::new() }
}

/// A star, with or without a hole.
fn star(choices: &mut Choices, center: Vec3, radius: f64) -> Shape {
    let normal = choices.direction();
    let outline = ring(center, normal, 8, |i| if i % 2 == 0 { radius } else { 0.5 * radius });
    let holes = if choices.one_in(2) { vec![ring(center, normal, 3, |_| 0.2 * radius)] } else { Vec::new() };
    Shape::Polygon { outline, holes }
}

/// A cylinder, a cone or a stump.
pub(super) fn round(choices: &mut Choices, center: Vec3, radius: f64) -> Shape {
    let half = choices.direction() * (radius * choices.pick(&[0.7, 0.01, 1.0]));
    let (base, top) = (center - half, center + half);
    let [radius, narrow] = [0.7 * radius, radius * choices.pick(&[0.7, 0.0, 0.3, 0.699_999])];
    let capped = choices.one_in(2);
    if narrow == radius {
        Shape::Cylinder { base, top, radius, capped }
    } else {
        Shape::Cone { base, base_radius: radius, top, top_radius: narrow, capped }
    }
}

/// A box along the axes, as a mesh.
pub(super) fn cuboid(center: Vec3, half: Vec3) -> Shape {
    let sign = |i: usize, bit: usize| if i & bit > 0 { 1.0 } else { -1.0 };
    let corner =
        |i: usize| center + Vec3 { x: sign(i, 1) * half.x, y: sign(i, 2) * half.y, z: sign(i, 4) * half.z };
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = faces.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    Shape::from(Mesh { positions: (0..8).map(corner).collect(), triangles, ..Mesh::default() })
}

/// A box that is thin in one direction.
fn slab(choices: &mut Choices, center: Vec3, radius: f64) -> Shape {
    let mut half = Vec3::splat(0.6 * radius);
    half[choices.below(3)] *= choices.magnitude(-9.0, 0.0);
    cuboid(center, half)
}

/// Two triangles that share an edge: smooth or flat, coloured, with texture coordinates or none of it.
fn sheet(choices: &mut Choices, center: Vec3, radius: f64) -> Shape {
    let normal = choices.direction();
    let mut positions = ring(center, normal, 4, |_| radius);
    positions[2] = positions[2] + normal * (radius * choices.coordinate(0.5));
    let normals = match choices.below(3) {
        0 => Vec::new(),
        _ => positions.iter().map(|&p| normal + (p - center) * (0.4 / radius)).collect(),
    };
    let colors = if choices.one_in(3) {
        vec![rgb(1.0, 0.5, 0.2), rgb(0.2, 0.9, 0.4), rgb(0.3, 0.3, 1.0), rgb(1.0, 1.0, 1.0)]
    } else {
        Vec::new()
    };
    let texcoords = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    Shape::from(Mesh { positions, normals, colors, texcoords, triangles: vec![[0, 1, 2], [0, 2, 3]] })
}
