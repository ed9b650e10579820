//! Where the renderer has its origin of coordinates.
//!
//! The plane of a face, and how far rays start from it, round by a share of their coordinates. Of a scene in map
//! coordinates, or one that a program put 10¹³ of its sizes away, this would be more than all of it. So such a scene is
//! moved, eye and lights included, and looks as if it had been made here.

use brt_geometry::Vec3;
use brt_scene::{Object, Scene};

use crate::margins::FAR_FROM_ORIGIN;

/// The point of a scene that becomes the origin: axis by axis the middle of everything that is bounded, or 0 where that is
/// near.
pub(super) fn origin_of(scene: &Scene) -> Vec3 {
    let boxes = scene.objects.iter().filter_map(Object::bounds);
    boxes.reduce(|[a, b], [c, d]| [a.min(c), b.max(d)]).map_or(Vec3::ZERO, of_box)
}

/// The same of what has these for the corners of its box.
pub(super) fn of_box([lo, hi]: [Vec3; 2]) -> Vec3 {
    let size = hi - lo;
    let size = size.x.max(size.y).max(size.z);
    let mut origin = lo * 0.5 + hi * 0.5;
    for axis in 0..3 {
        if origin[axis].abs() <= FAR_FROM_ORIGIN * size {
            origin[axis] = 0.0;
        }
    }
    origin
}

#[cfg(test)]
mod tests {
    use super::*;
    use brt_geometry::vec3;
    use brt_image::Rgb;
    use brt_scene::{Camera, Material, MaterialId, Projection, Shape};

    fn scene_of_ball(center: Vec3) -> Scene {
        let eye = center + vec3(0.0, 0.0, 5.0);
        let projection = Projection::Perspective { fov_deg: 40.0 };
        let mut scene = Scene::new(Camera { eye, look_at: center, up: vec3(0.0, 1.0, 0.0), projection });
        scene.materials.push(Material::matte("m", Rgb::WHITE));
        scene.objects.push(Object::new(Shape::Sphere { center, radius: 1.0 }, MaterialId(0)));
        scene
    }

    #[test]
    fn only_far_coordinates_are_moved() {
        assert_eq!(origin_of(&scene_of_ball(vec3(7.0, -8.0, 0.0))), Vec3::ZERO);
        assert_eq!(origin_of(&scene_of_ball(vec3(9.0, 0.5, -1e13))), vec3(9.0, 0.0, -1e13));
    }

    #[test]
    fn infinite_planes_alone_stay() {
        let mut scene = scene_of_ball(Vec3::ZERO);
        scene.objects[0].shape = Shape::Plane { normal: vec3(0.0, 1.0, 0.0), distance: 1e9 };
        assert_eq!(origin_of(&scene), Vec3::ZERO);
    }
}
