//! A floor to stand on.

use brt_image::rgb;

use super::Up;
use super::support::Reach;
use crate::{Material, Object, Scene, Shape};

/// Puts an endless matte floor under everything that has bounds.
pub fn add_floor(scene: &mut Scene, up: Up) {
    let normal = up.direction();
    let reach = Reach::of(scene);
    let distance = reach.origin.dot(normal) - reach.along(-normal).unwrap_or(0.0);
    let mut material = Material::matte("floor", rgb(0.9, 0.9, 0.9));
    material.ambient = 0.25;
    material.diffuse = 0.7;
    let id = scene.add_material(material);
    let shape = Shape::Plane { normal, distance };
    scene.objects.push(Object { name: Some("floor".to_owned()), ..Object::new(shape, id) });
}

#[cfg(test)]
mod tests {
    use brt_geometry::vec3;
    use brt_image::Rgb;

    use super::*;
    use crate::framing::{Framing, framed_camera};

    #[test]
    fn the_floor_touches_what_stands_lowest() {
        for (_, up) in Up::ALL {
            let camera = crate::Camera {
                eye: vec3(0.0, 0.0, 0.0),
                look_at: vec3(1.0, 1.0, 1.0),
                up: vec3(0.0, 1.0, 0.0),
                projection: crate::Projection::Perspective { fov_deg: 45.0 },
            };
            let mut scene = Scene::new(camera);
            let id = scene.add_material(Material::matte("m", Rgb::WHITE));
            scene.add(Shape::Sphere { center: vec3(3.0, 3.0, 3.0), radius: 1.0 }, id);
            add_floor(&mut scene, up);
            let expected = if up.direction().dot(vec3(1.0, 1.0, 1.0)) > 0.0 { 2.0 } else { -4.0 };
            let Shape::Plane { distance, .. } = scene.objects[1].shape else { panic!("a plane") };
            assert_eq!(distance, expected);
            scene.camera = framed_camera(&scene, &Framing::new(up));
            assert_eq!(scene.check(), []);
        }
    }
}
