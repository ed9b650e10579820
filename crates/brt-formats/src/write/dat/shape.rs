//! Shapes of Tachyon.

use std::f64::consts::TAU;

use brt_geometry::{Vec3, polygon_plane, triangulate};
use brt_scene::{Mesh, Object, Scene, Shape};

use super::{Writer, number, vector};

/// Facets of a cone.
const FACETS: u32 = 96;

impl Writer {
    pub(super) fn object(&mut self, object: &Object, scene: &Scene) {
        let material = format!("M{}", object.material.0);
        match &object.shape {
            Shape::Sphere { center, radius } => self.line(format_args!(
                "SPHERE CENTER {} RAD {} {material}",
                vector(*center),
                number(*radius)
            )),
            Shape::Plane { normal, distance } => {
                let foot = *normal * (distance / normal.dot(*normal));
                self.line(format_args!(
                    "PLANE CENTER {} NORMAL {} {material}",
                    vector(foot),
                    vector(*normal)
                ));
            }
            Shape::Polygon { outline, holes } => self.polygon(outline, holes, &material),
            Shape::Disc { center, normal, radius } => self.disc(*center, *normal, *radius, &material),
            Shape::Cylinder { base, top, radius, capped } => {
                self.line(format_args!(
                    "FCYLINDER BASE {} APEX {} RAD {} {material}",
                    vector(*base),
                    vector(*top),
                    number(*radius)
                ));
                self.caps([*base, *top], [*radius; 2], *capped, &material);
            }
            Shape::Cone { base, base_radius, top, top_radius, capped } => {
                let name =
                    object.name.as_deref().unwrap_or(&scene.materials[object.material.0 as usize].name);
                self.losses
                    .note_for("Tachyon has no cones; smooth facets stand for them", format!("`{name}`"));
                self.cone([*base, *top], [*base_radius, *top_radius], &material);
                self.caps([*base, *top], [*base_radius, *top_radius], *capped, &material);
            }
            Shape::Mesh(mesh) => {
                if !mesh.colors.is_empty() {
                    self.losses.note("colours of points are left out");
                }
                self.mesh(&mesh.placed(&object.transform), &material);
            }
        }
    }

    fn disc(&mut self, center: Vec3, normal: Vec3, radius: f64, material: &str) {
        let unit = normal.try_normalize().unwrap_or_default();
        self.line(format_args!(
            "RING CENTER {} NORMAL {} INNER 0 OUTER {} {material}",
            vector(center),
            vector(unit),
            number(radius)
        ));
    }

    fn caps(&mut self, ends: [Vec3; 2], radii: [f64; 2], capped: bool, material: &str) {
        let axis = ends[1] - ends[0];
        for (end, radius) in ends.into_iter().zip(radii) {
            if capped && radius > 0.0 {
                self.disc(end, axis, radius, material);
            }
        }
    }

    fn triangle(&mut self, [a, b, c]: [Vec3; 3], material: &str) {
        self.line(format_args!("TRI V0 {} V1 {} V2 {} {material}", vector(a), vector(b), vector(c)));
    }

    /// Tachyon tells the front by the order of the corners, which must agree with the normals.
    fn smooth_triangle(&mut self, corners: [Vec3; 3], normals: [Vec3; 3], material: &str) {
        let face = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        let agrees = face.dot(normals[0] + normals[1] + normals[2]) >= 0.0;
        // The mirrored axes turn the order round.
        let order = if agrees { [0, 2, 1] } else { [0, 1, 2] };
        let [a, b, c] = order.map(|i| vector(corners[i]));
        let [i, j, k] = order.map(|i| vector(normals[i]));
        self.line(format_args!("STRI V0 {a} V1 {b} V2 {c} N0 {i} N1 {j} N2 {k} {material}"));
    }

    fn polygon(&mut self, outline: &[Vec3], holes: &[Vec<Vec3>], material: &str) {
        let Some(plane) = polygon_plane(outline) else { return };
        let corners: Vec<Vec3> = outline.iter().chain(holes.iter().flatten()).copied().collect();
        for triangle in triangulate(outline, holes, plane.normal) {
            self.triangle(triangle.map(|i| corners[i as usize]), material);
        }
    }

    fn mesh(&mut self, mesh: &Mesh, material: &str) {
        for triangle in &mesh.triangles {
            let corners = triangle.map(|i| mesh.positions[i as usize]);
            if mesh.normals.is_empty() {
                self.triangle(corners, material);
            } else {
                // Tachyon does not bring interpolated normals to the length 1 of the corners'.
                let unit = |i: u32| mesh.normals[i as usize].try_normalize().unwrap_or_default();
                self.smooth_triangle(corners, triangle.map(unit), material);
            }
        }
    }

    /// The side of a cone or frustum as facets around its axis.
    fn cone(&mut self, [base, top]: [Vec3; 2], radii: [f64; 2], material: &str) {
        let height = (top - base).length();
        let axis = (top - base).try_normalize().unwrap_or_default();
        let (across, along) = axis.tangents();
        let out = |i: u32| {
            let angle = TAU * f64::from(i % FACETS) / f64::from(FACETS);
            across * libm::cos(angle) + along * libm::sin(angle)
        };
        let normal = |i: u32| (out(i) * height + axis * (radii[0] - radii[1])).normalize();
        for i in 0..FACETS {
            let j = i + 1;
            let low = [base + out(i) * radii[0], base + out(j) * radii[0]];
            let high = [top + out(i) * radii[1], top + out(j) * radii[1]];
            if radii[0] > 0.0 {
                self.smooth_triangle([low[0], low[1], high[0]], [normal(i), normal(j), normal(i)], material);
            }
            if radii[1] > 0.0 {
                self.smooth_triangle([low[1], high[1], high[0]], [normal(j), normal(j), normal(i)], material);
            }
        }
    }
}
