//! Random scenes of what is as good as flat: thin boxes, slivers, quadrangles a little off their plane, with eyes, lights and
//! mirrors in or nearly in the same plane.

use brt_geometry::{Affine, Vec3, vec3};
use brt_image::rgb;
use brt_scene::{Camera, Light, MaterialId, Mesh, Object, Shape};
use proptest::prelude::*;

use super::scenes::{AnyScene, any_projection, dull_scene_of};
use super::{direction, point};

/// Scenes that are turned at random as a whole; up to there everything lies along the plane z = 0.
pub fn any_scene_of_slivers() -> impl Strategy<Value = AnyScene> {
    let parts = prop::collection::vec((any_part(), near_plane(1.0), 0_u32..3), 1..5);
    let floor = tiny().prop_map(|tilt| Shape::Plane { normal: vec3(tilt, 0.0, 1.0), distance: -0.3 * tilt });
    let floor = prop::option::of(floor);
    // Rows of pixels often lie in the plane.
    let camera = (near_plane(3.0), point(0.5), tiny(), any::<bool>(), any_projection());
    let lights = prop::collection::vec(near_plane(4.0), 0..2);
    (dull_scene_of(Just(Vec::new())), parts, floor, camera, lights, direction())
        .prop_map(
            |(
                AnyScene(mut scene),
                parts,
                floor,
                (eye, target, slope, is_level, projection),
                lights,
                axis,
            )| {
                let turn = turn_to(axis);
                let floor = floor.map(|floor| (floor, Vec3::ZERO, 0));
                scene.objects.extend(parts.into_iter().chain(floor).map(|(shape, offset, material)| {
                    Object::new(placed(shape, offset, &turn), MaterialId(material))
                }));
                let look_at = vec3(target.x, target.y, eye.z + slope);
                let up = if is_level { vec3(0.0, 0.0, 1.0) } else { vec3(0.3, 1.0, 0.7) };
                let [eye, look_at, up] = [eye, look_at, up].map(|p| turn.point(p));
                scene.camera = Camera { eye, look_at, up, projection };
                let color = rgb(0.8, 0.7, 0.6);
                let light = |position: Vec3| Light::Point { position: turn.point(position), color };
                scene.lights.extend(lights.into_iter().map(light));
                AnyScene(scene)
            },
        )
        .prop_filter("fit to be rendered", |scene| scene.0.check().is_empty())
}

/// 0, or of any small magnitude.
fn tiny() -> impl Strategy<Value = f64> {
    prop_oneof![
        1 => Just(0.0),
        2 => (-12.0..-2.0, any::<bool>()).prop_map(|(e, back)| {
            if back { -libm::pow(10.0, e) } else { libm::pow(10.0, e) }
        }),
    ]
}

fn near_plane(half: f64) -> impl Strategy<Value = Vec3> {
    (point(half), tiny()).prop_map(|(p, height)| vec3(p.x, p.y, height))
}

/// A thin box, a strip of slivers, or a bent quadrangle, around the origin.
fn any_part() -> impl Strategy<Value = Shape> {
    let side = || 0.1..1.5;
    prop_oneof![
        (side(), side(), -10.0..-3.0).prop_map(|(a, b, e)| thin_box(vec3(a, b, a * libm::pow(10.0, e)))),
        (side(), 1_u32..8, -9.0..-5.0, tiny())
            .prop_map(|(a, count, e, bend)| { strip(a, count, a * libm::pow(10.0, e), bend) }),
        (side(), side(), prop::array::uniform4(tiny())).prop_map(|(a, b, heights): (f64, f64, [f64; 4])| {
            let [p, q, r, s] = heights;
            let outline = [vec3(-a, -b, p), vec3(a, -b, q), vec3(a, b, r), vec3(-a, b, s)].to_vec();
            Shape::Polygon { outline, holes: Vec::new() }
        }),
    ]
}

fn thin_box(half: Vec3) -> Shape {
    let sign = |bit: bool| if bit { 1.0 } else { -1.0 };
    let positions = (0..8)
        .map(|i| vec3(sign(i & 1 > 0) * half.x, sign(i & 2 > 0) * half.y, sign(i & 4 > 0) * half.z))
        .collect();
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = faces.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    Shape::from(Mesh { positions, triangles, ..Mesh::default() })
}

/// Slivers side by side, of which every other edge is lifted.
fn strip(length: f64, count: u32, width: f64, lift: f64) -> Shape {
    let edge = |i: u32| {
        let (y, z) = (f64::from(i) * width, f64::from(i % 2) * lift * width);
        [vec3(-length, y, z), vec3(length, y, z)]
    };
    let triangles = |i: u32| [[2 * i, 2 * i + 1, 2 * i + 3], [2 * i, 2 * i + 3, 2 * i + 2]];
    Shape::from(Mesh {
        positions: (0..=count).flat_map(edge).collect(),
        triangles: (0..count).flat_map(triangles).collect(),
        ..Mesh::default()
    })
}

/// What turns z into this direction.
fn turn_to(axis: Vec3) -> Affine {
    let axis = axis.normalize();
    let (u, v) = axis.tangents();
    Affine { axes: [u, v, axis], offset: Vec3::ZERO }
}

fn placed(shape: Shape, offset: Vec3, turn: &Affine) -> Shape {
    let place = |p: &Vec3| turn.point(*p + offset);
    match shape {
        Shape::Plane { normal, distance } => Shape::Plane { normal: turn.point(normal), distance },
        Shape::Polygon { outline, holes } => {
            Shape::Polygon { outline: outline.iter().map(place).collect(), holes }
        }
        Shape::Mesh(mesh) => {
            let positions = mesh.positions.iter().map(place).collect();
            Shape::from(Mesh { positions, ..(*mesh).clone() })
        }
        other => other,
    }
}
