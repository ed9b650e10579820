//! How far a scene reaches in a direction: all that framing needs to know about shapes.

use brt_geometry::{Affine, Vec3, vec3};

use crate::{Object, Scene, Shape};

/// Greatest `p·direction` of all points of bounded objects; `None` where there are none.
pub fn support(scene: &Scene, direction: Vec3) -> Option<f64> {
    scene.objects.iter().filter_map(|object| of_object(object, direction)).reduce(f64::max)
}

fn of_object(object: &Object, n: Vec3) -> Option<f64> {
    match &object.shape {
        Shape::Sphere { center, radius } => Some(center.dot(n) + radius * n.length()),
        Shape::Plane { .. } => None,
        Shape::Polygon { outline, .. } => of_points(outline, n),
        Shape::Disc { center, normal, radius } => Some(of_disc(*center, *normal, *radius, n)),
        Shape::Cylinder { base, top, radius, .. } => {
            let axis = *top - *base;
            Some(of_disc(*base, axis, *radius, n).max(of_disc(*top, axis, *radius, n)))
        }
        Shape::Cone { base, base_radius, top, top_radius, .. } => {
            let axis = *top - *base;
            Some(of_disc(*base, axis, *base_radius, n).max(of_disc(*top, axis, *top_radius, n)))
        }
        // (A·p + o)·n is p·(Aᵀ·n) + o·n.
        Shape::Mesh(mesh) => {
            let Affine { axes: [a, b, c], offset } = object.transform;
            let turned = vec3(a.dot(n), b.dot(n), c.dot(n));
            Some(of_points(&mesh.positions, turned)? + offset.dot(n))
        }
    }
}

fn of_points(points: &[Vec3], n: Vec3) -> Option<f64> {
    points.iter().map(|p| p.dot(n)).reduce(f64::max)
}

/// Of a disc only the part of the direction counts that lies in its plane.
fn of_disc(center: Vec3, normal: Vec3, radius: f64, n: Vec3) -> f64 {
    let normal = normal.try_normalize().unwrap_or_default();
    center.dot(n) + radius * (n - normal * normal.dot(n)).length()
}
