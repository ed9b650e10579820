//! How far a scene reaches in a direction: all that framing needs to know about shapes.

use brt_geometry::Vec3;

use crate::{Scene, Shape};

/// Greatest `p·direction` of all points of bounded objects; `None` where there are none.
pub fn support(scene: &Scene, direction: Vec3) -> Option<f64> {
    scene.objects.iter().filter_map(|object| of_shape(&object.shape, direction)).reduce(f64::max)
}

fn of_shape(shape: &Shape, n: Vec3) -> Option<f64> {
    match shape {
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
        Shape::Mesh(mesh) => of_points(&mesh.positions, n),
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
