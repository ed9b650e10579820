//! A bent torus: one smooth mesh with exact normals over a floor.

use brt_geometry::{Vec3, vec3};
use brt_image::rgb;
use brt_scene::{Camera, Light, Material, Mesh, Projection, Scene, Shape};

/// The torus, matte with a highlight.
pub(super) fn matte(triangles: u32) -> Scene {
    let material =
        Material { specular: 0.5, exponent: 40.0, ..Material::matte("torus", rgb(0.85, 0.45, 0.2)) };
    build(triangles, material)
}

/// The torus as a mirror.
pub(super) fn mirror(triangles: u32) -> Scene {
    let material = Material {
        diffuse: 0.4,
        specular: 0.5,
        exponent: 80.0,
        reflection: 0.4,
        ..Material::matte("torus", rgb(0.75, 0.7, 0.6))
    };
    build(triangles, material)
}

fn build(triangles: u32, material: Material) -> Scene {
    let mut scene = Scene::new(Camera {
        eye: vec3(0.6, 2.3, 3.6),
        look_at: vec3(0.0, 0.7, 0.0),
        up: vec3(0.0, 1.0, 0.0),
        projection: Projection::Perspective { fov_deg: 50.0 },
    });
    scene.size = Some([1024, 1024]);
    scene.background = rgb(0.06, 0.08, 0.12);
    for (position, color) in
        [(vec3(-4.0, 6.0, 4.0), rgb(0.75, 0.72, 0.65)), (vec3(5.0, 5.0, 1.0), rgb(0.3, 0.35, 0.45))]
    {
        scene.lights.push(Light::Point { position, color });
    }
    let floor = scene.add_material(Material::matte("floor", rgb(0.5, 0.52, 0.5)));
    let torus = scene.add_material(material);
    scene.add(Shape::Plane { normal: vec3(0.0, 1.0, 0.0), distance: 0.0 }, floor);
    scene.add(Shape::from(mesh(triangles)), torus);
    scene
}

/// Rows around the ring and around the tube: quads that are nearly square.
fn mesh(triangles: u32) -> Mesh {
    let quads = f64::from(triangles) / 2.0;
    let tube = libm::round(libm::sqrt(quads / 2.5)).max(3.0) as u32;
    let ring = libm::round(quads / f64::from(tube)).max(3.0) as u32;
    let mut mesh = Mesh::default();
    for i in 0..ring {
        for j in 0..tube {
            let turn = |k: u32, n: u32| core::f64::consts::TAU * f64::from(k) / f64::from(n);
            let (position, normal) = point(turn(i, ring), turn(j, tube));
            mesh.positions.push(position);
            mesh.normals.push(normal);
            let at = |i: u32, j: u32| (i % ring) * tube + j % tube;
            let [a, b, c, d] = [at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)];
            mesh.triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    mesh
}

/// A wave `1 + depth·sin(count·angle)` and its derivative by the angle.
fn wave(depth: f64, count: f64, angle: f64) -> (f64, f64) {
    (1.0 + depth * libm::sin(count * angle), depth * count * libm::cos(count * angle))
}

/// Point and outward normal at the angle `u` around the ring and `v` around the tube.
///
/// The centre line `r(u)·e(u) + h(u)·y` is a wavy circle; the tube's radius is a product of a wave along and one
/// across it. The normal is the vector product of the two derivatives.
fn point(u: f64, v: f64) -> (Vec3, Vec3) {
    let (out, around) = (vec3(libm::cos(u), 0.0, libm::sin(u)), vec3(-libm::sin(u), 0.0, libm::cos(u)));
    let up = vec3(0.0, 1.0, 0.0);
    let (r, r_u) = wave(0.1, 3.0, u);
    let (h, h_u) = wave(0.28, 2.0, u);
    let (along, along_u) = wave(0.16, 5.0, u);
    let (across, across_v) = wave(0.12, 4.0, v);
    const TUBE: f64 = 0.36;
    let (s, s_u, s_v) = (TUBE * along * across, TUBE * along_u * across, TUBE * along * across_v);

    let (sin, cos) = (libm::sin(v), libm::cos(v));
    let spoke = out * cos + up * sin;
    let position = out * r + up * (h * 0.8) + spoke * s;
    let by_u = out * r_u + around * r + up * (h_u * 0.8) + spoke * s_u + around * (s * cos);
    let by_v = spoke * s_v + (up * cos - out * sin) * s;
    (position, by_v.cross(by_u).normalize())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mesh_has_about_as_many_triangles_as_asked_for() {
        for asked in [100, 5_000, 100_000] {
            let made = mesh(asked).triangles.len() as f64;
            assert!((made / f64::from(asked) - 1.0).abs() < 0.1, "{made} for {asked}");
        }
    }

    #[test]
    fn normals_agree_with_differences_and_look_outwards() {
        for (u, v) in [(0.3, 0.2), (1.7, 3.0), (4.4, 5.5)] {
            let (p, n) = point(u, v);
            let step = 1.0 / 65536.0;
            // A chord over a step deviates from the tangent by half the step times the curvature, here below 20.
            for q in [point(u + step, v).0, point(u, v + step).0] {
                assert!((q - p).normalize().dot(n).abs() < 20.0 * step);
            }
            let (opposite, _) = point(u, v + core::f64::consts::PI);
            assert!(n.dot(p - opposite) > 0.0);
        }
    }

    #[test]
    fn triangles_face_the_way_of_their_normals_and_stay_above_the_floor() {
        let mesh = mesh(20_000);
        for &[a, b, c] in &mesh.triangles {
            let [p, q, r] = [a, b, c].map(|i| mesh.positions[i as usize]);
            assert!((q - p).cross(r - p).dot(mesh.normals[a as usize]) > 0.0);
        }
        assert!(mesh.positions.iter().all(|p| p.y > 0.0));
    }
}
