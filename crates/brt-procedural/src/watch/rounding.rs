//! Coordinates rounded to hundredths of a micrometre: a scene file of half the size and no visible difference.

use std::sync::Arc;

use brt_geometry::{Vec3, vec3};
use brt_scene::{Scene, Shape};

/// The scene with all points and lengths rounded; corners that were equal stay equal.
pub(super) fn rounded(mut scene: Scene) -> Scene {
    for object in &mut scene.objects {
        round_shape(&mut object.shape);
    }
    scene
}

fn round_shape(shape: &mut Shape) {
    match shape {
        Shape::Sphere { center, radius } => {
            point(center);
            length(radius);
        }
        Shape::Plane { .. } => {}
        Shape::Polygon { outline, holes } => {
            outline.iter_mut().chain(holes.iter_mut().flatten()).for_each(point);
        }
        Shape::Disc { center, radius, .. } => {
            point(center);
            length(radius);
        }
        Shape::Cylinder { base, top, radius, .. } => {
            point(base);
            point(top);
            length(radius);
        }
        Shape::Cone { base, base_radius, top, top_radius, .. } => {
            point(base);
            point(top);
            length(base_radius);
            length(top_radius);
        }
        Shape::Mesh(mesh) => {
            let mesh = Arc::make_mut(mesh);
            mesh.positions.iter_mut().for_each(point);
            mesh.normals.iter_mut().for_each(point);
        }
    }
}

fn point(p: &mut Vec3) {
    let round = |mut x: f64| {
        length(&mut x);
        x
    };
    *p = vec3(round(p.x), round(p.y), round(p.z));
}

fn length(x: &mut f64) {
    const PER_MILLIMETRE: f64 = 1e5;
    *x = (*x * PER_MILLIMETRE).round() / PER_MILLIMETRE;
}
