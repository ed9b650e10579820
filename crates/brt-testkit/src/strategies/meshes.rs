//! Random scenes of fine meshes: what is filled across the edges of triangles, and what lies in their shadow.

use brt_geometry::{Vec3, vec3};
use brt_scene::{Mesh, Shape};
use proptest::prelude::*;

use super::point;
use super::scenes::{AnyScene, dull_scene_of};

/// Scenes of a few fine meshes over a floor, of faces or smooth.
pub fn any_mesh_scene() -> impl Strategy<Value = AnyScene> {
    let mesh = any_mesh().prop_map(Shape::from);
    dull_scene_of(prop::collection::vec((mesh, 0_u32..3), 1..4))
}

/// A ball with bumps, closed or with an open rim, or a wavy square. Sometimes folded, cut short, or twice in one place.
fn any_mesh() -> impl Strategy<Value = Mesh> {
    let waves = (0.0..0.5, 0.0..9.0, 0.0..7.0);
    let flaws = (any::<bool>(), any::<bool>(), 0_u32..6, -0.3..0.3);
    (point(1.5), 0.3..1.5, 4_u32..40, 3_u32..24, waves, any::<bool>(), flaws).prop_map(
        |(center, size, columns, rows, waves, is_ball, (is_smooth, faces_inward, flaw, bend))| {
            let mut mesh = Mesh::default();
            for row in 0..=rows {
                for column in 0..=columns {
                    let at = [f64::from(column) / f64::from(columns), f64::from(row) / f64::from(rows)];
                    let offset = if is_ball { on_ball(at, waves) } else { on_square(at, waves) };
                    mesh.positions.push(center + offset * size);
                }
            }
            let next = columns + 1;
            for row in 0..rows {
                for column in 0..columns {
                    let a = row * next + column;
                    let faces = [[a, a + next, a + 1], [a + 1, a + next, a + next + 1]];
                    mesh.triangles
                        .extend(faces.map(|[a, b, c]| if faces_inward { [a, c, b] } else { [a, b, c] }));
                }
            }
            if is_smooth {
                mesh.normals = smooth_normals(&mesh, bend);
            }
            let count = mesh.triangles.len();
            match flaw {
                0 => mesh.triangles.truncate(count * 2 / 3),
                1 => mesh.triangles.extend_from_within(..count / 2),
                _ => {}
            }
            mesh
        },
    )
}

fn on_ball([u, v]: [f64; 2], (depth, across, along): (f64, f64, f64)) -> Vec3 {
    let (angle, tilt) = (std::f64::consts::TAU * u, std::f64::consts::PI * v);
    let radius = 1.0 + depth * libm::sin(across.round() * angle) * libm::cos(along * tilt);
    vec3(libm::sin(tilt) * libm::cos(angle), libm::cos(tilt), libm::sin(tilt) * libm::sin(angle)) * radius
}

fn on_square([u, v]: [f64; 2], (depth, across, along): (f64, f64, f64)) -> Vec3 {
    vec3(2.0 * u - 1.0, depth * libm::sin(across * u) * libm::cos(along * v), 2.0 * v - 1.0)
}

/// Means of the faces' normals at each point, bent away by a share.
fn smooth_normals(mesh: &Mesh, bend: f64) -> Vec<Vec3> {
    let mut normals = vec![Vec3::ZERO; mesh.positions.len()];
    for triangle in &mesh.triangles {
        let [a, b, c] = triangle.map(|i| mesh.positions[i as usize]);
        let normal = (b - a).cross(c - a);
        for &i in triangle {
            normals[i as usize] = normals[i as usize] + normal;
        }
    }
    let bent = |n: Vec3| n.try_normalize().unwrap_or(vec3(0.0, 1.0, 0.0)) + vec3(bend, 0.0, bend * bend);
    normals.into_iter().map(bent).collect()
}
