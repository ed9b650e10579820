//! Sierpiński's tetrahedron: four half as large in its corners, and so on.

use brt_geometry::{Vec3, vec3};
use brt_scene::{MaterialId, Scene};

use super::{NO_SHINE, fill, polygon, start};

/// 4^`depth` triangles: the smallest tetrahedra have four each.
pub(crate) fn build(depth: u32) -> Scene {
    let third = libm::sqrt(2.0 / 3.0);
    let mut scene = start(
        vec3(1.02285, -3.17715, -2.17451),
        vec3(-0.004103, -0.004103, 0.216539),
        vec3(-third, -third, third),
        &[vec3(2.0, -18.0, -5.0)],
    );
    let red = scene.add_material(fill("red", [1.0, 0.2, 0.2], 1.0, 0.0, NO_SHINE));
    let corners = [vec3(-1.0, -1.0, 1.0), vec3(-1.0, 1.0, -1.0), vec3(1.0, -1.0, -1.0), vec3(1.0, 1.0, 1.0)];
    split(&mut scene, red, corners, depth - 1);
    scene
}

fn split(scene: &mut Scene, material: MaterialId, corners: [Vec3; 4], depth: u32) {
    if depth > 0 {
        for kept in corners {
            // Halving the way to one corner is exact in binary numbers.
            split(scene, material, corners.map(|c| (c + kept) * 0.5), depth - 1);
        }
        return;
    }
    let [a, b, c, d] = corners;
    for face in [[a, b, c], [d, c, b], [c, d, a], [b, a, d]] {
        scene.add(polygon(face), material);
    }
}

#[cfg(test)]
mod tests {
    use brt_geometry::polygon_plane;

    use super::*;
    use brt_scene::Shape;

    #[test]
    fn first_triangle_is_that_of_the_database() {
        let scene = build(4);
        assert_eq!(scene.objects.len(), 256);
        let Shape::Polygon { outline, .. } = &scene.objects[0].shape else { panic!() };
        let printed = [vec3(-1.0, -1.0, 1.0), vec3(-1.0, -0.75, 0.75), vec3(-0.75, -1.0, 0.75)];
        assert_eq!(outline.as_slice(), printed);
    }

    #[test]
    fn faces_look_outwards() {
        for object in build(1).objects {
            let Shape::Polygon { outline, .. } = object.shape else { panic!() };
            let plane = polygon_plane(&outline).unwrap();
            // The middle of the tetrahedron is the origin.
            assert!(plane.normal.dot(plane.center) > 0.0);
        }
    }
}
