//! Whole scenes, scaled and moved.

use std::sync::Arc;

use brt_geometry::{Affine, Vec3};
use brt_scene::{Light, Projection, Scene, Shape};

/// The scene seen through a magnifying glass: every length times `factor`.
pub fn scaled(scene: &Scene, factor: f64) -> Scene {
    moved(scene, |p| p * factor, &|length| length * factor)
}

/// The scene somewhere else, with its camera. Chequered patterns stay where they are.
pub fn shifted(scene: &Scene, offset: Vec3) -> Scene {
    let mut scene = moved(scene, |p| p + offset, &|length| length);
    for object in &mut scene.objects {
        if let Shape::Plane { normal, distance } = &mut object.shape {
            *distance += normal.dot(offset);
        }
    }
    scene
}

/// The scene turned around the origin by a map that keeps lengths. Chequered patterns stay as they are.
pub fn turned(scene: &Scene, turn: &Affine) -> Scene {
    let mut scene = moved(scene, |p| turn.point(p), &|length| length);
    scene.camera.up = turn.direction(scene.camera.up);
    for light in &mut scene.lights {
        if let Light::Directional { direction, .. } | Light::Spot { direction, .. } = light {
            *direction = turn.direction(*direction);
        }
    }
    for object in &mut scene.objects {
        if object.transform != Affine::IDENTITY {
            object.transform.axes = object.transform.axes.map(|axis| turn.direction(axis));
            continue;
        }
        match &mut object.shape {
            Shape::Plane { normal, .. } | Shape::Disc { normal, .. } => *normal = turn.direction(*normal),
            Shape::Mesh(mesh) => {
                Arc::make_mut(mesh).normals.iter_mut().for_each(|n| *n = turn.direction(*n));
            }
            _ => {}
        }
    }
    scene
}

fn moved(scene: &Scene, point: impl Fn(Vec3) -> Vec3, length: &dyn Fn(f64) -> f64) -> Scene {
    let mut scene = scene.clone();
    scene.camera.eye = point(scene.camera.eye);
    scene.camera.look_at = point(scene.camera.look_at);
    if let Projection::Orthographic { extent } = &mut scene.camera.projection {
        *extent = length(*extent);
    }
    for light in &mut scene.lights {
        if let Light::Point { position, .. } | Light::Spot { position, .. } = light {
            *position = point(*position);
        }
    }
    for checker in scene.materials.iter_mut().filter_map(|m| m.checker.as_mut()) {
        checker.size = length(checker.size);
    }
    for object in &mut scene.objects {
        if object.transform != Affine::IDENTITY {
            let map = &mut object.transform;
            map.axes = map.axes.map(|axis| axis * length(1.0));
            map.offset = point(map.offset);
            continue;
        }
        move_shape(&mut object.shape, &point, length);
    }
    scene
}

fn move_shape(shape: &mut Shape, point: impl Fn(Vec3) -> Vec3, length: &dyn Fn(f64) -> f64) {
    match shape {
        Shape::Sphere { center, radius } | Shape::Disc { center, radius, .. } => {
            (*center, *radius) = (point(*center), length(*radius));
        }
        Shape::Plane { distance, .. } => *distance = length(*distance),
        Shape::Polygon { outline, holes } => {
            outline.iter_mut().chain(holes.iter_mut().flatten()).for_each(|p| *p = point(*p));
        }
        Shape::Cylinder { base, top, radius, .. } => {
            (*base, *top, *radius) = (point(*base), point(*top), length(*radius));
        }
        Shape::Cone { base, base_radius, top, top_radius, .. } => {
            (*base, *top) = (point(*base), point(*top));
            (*base_radius, *top_radius) = (length(*base_radius), length(*top_radius));
        }
        Shape::Mesh(mesh) => Arc::make_mut(mesh).positions.iter_mut().for_each(|p| *p = point(*p)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::all_shapes;
    use brt_geometry::vec3;

    #[test]
    fn moving_there_and_back_is_no_move() {
        let scene = all_shapes();
        // Powers of two: no rounding.
        assert_eq!(scaled(&scaled(&scene, 1024.0), 1.0 / 1024.0), scene);
        let there = shifted(&scene, vec3(64.0, -32.0, 16.0));
        assert_ne!(there, scene);
        assert!(there.check().is_empty());
        // A quarter turn, four times.
        let quarter = Affine {
            axes: [vec3(0.0, 0.0, -1.0), vec3(0.0, 1.0, 0.0), vec3(1.0, 0.0, 0.0)],
            offset: Vec3::ZERO,
        };
        let once = turned(&scene, &quarter);
        assert_ne!(once, scene);
        assert_eq!((0..3).fold(once, |scene, _| turned(&scene, &quarter)), scene);
    }
}
