//! Random scenes of fine meshes: what is filled across the edges of triangles, and what lies in their shadow.

use brt_geometry::{Vec3, vec3};
use brt_scene::{Camera, Material, MaterialId, Mesh, Object, Scene, Shape};
use proptest::prelude::*;

use super::materials::{any_color, any_material};
use super::scenes::{AnyScene, any_light, any_projection, named};
use super::{direction, point};

/// Scenes of a few fine meshes over a floor, of faces or smooth.
pub fn any_mesh_scene() -> impl Strategy<Value = AnyScene> {
    let meshes = prop::collection::vec((any_mesh(), 0_u32..3), 1..4);
    // No glass: between hundreds of faces its rays would never end.
    let dull = any_material().prop_map(|material| Material { transmission: 0.0, opacity: 1.0, ..material });
    let materials = prop::collection::vec(dull, 3);
    let lights = prop::collection::vec(any_light(), 1..4);
    let camera = (point(4.0), point(1.0), direction(), any_projection())
        .prop_map(|(eye, look_at, up, projection)| Camera { eye, look_at, up, projection });
    (meshes, materials, lights, camera, any_color(), any::<bool>())
        .prop_map(|(meshes, materials, lights, camera, background, has_floor)| {
            let mut scene = Scene {
                background,
                max_depth: 2,
                lights,
                objects: meshes
                    .into_iter()
                    .map(|(mesh, material)| Object::new(Shape::from(mesh), MaterialId(material)))
                    .collect(),
                materials: materials.into_iter().zip(0..).map(named).collect(),
                ..Scene::new(camera)
            };
            if has_floor {
                let floor = Shape::Plane { normal: vec3(0.0, 1.0, 0.0), distance: -1.5 };
                scene.objects.push(Object::new(floor, MaterialId(0)));
            }
            AnyScene(scene)
        })
        .prop_filter("fit to be rendered", |scene| scene.0.check().is_empty())
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
    let radius = 1.0 + depth * (across.round() * angle).sin() * (along * tilt).cos();
    vec3(tilt.sin() * angle.cos(), tilt.cos(), tilt.sin() * angle.sin()) * radius
}

fn on_square([u, v]: [f64; 2], (depth, across, along): (f64, f64, f64)) -> Vec3 {
    vec3(2.0 * u - 1.0, depth * (across * u).sin() * (along * v).cos(), 2.0 * v - 1.0)
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
