//! A lying pyramid of clusters, each of six interlocking five-sided rings of cylinders and spheres.

use brt_geometry::{Vec3, vec3};
use brt_scene::{Scene, Shape};

use super::{NO_SHINE, fill, polygon, start};

/// Distance of a ring's corners from the middle of its cluster, and the radius of its rods.
const REACH: f64 = 0.930995;
const ROD: f64 = 0.07412;
const COLORS: [(&str, [f64; 3]); 6] = [
    ("red", [1.0, 0.0, 0.0]),
    ("green", [0.0, 1.0, 0.0]),
    ("blue", [0.0, 0.0, 1.0]),
    ("cyan", [0.0, 1.0, 1.0]),
    ("magenta", [1.0, 0.0, 1.0]),
    ("yellow", [1.0, 1.0, 0.0]),
];

/// `layers` layers of 1, 4, 9 … clusters behind each other.
pub(crate) fn build(layers: u32) -> Scene {
    let half_view = 22.5f64.to_radians();
    // From here a cluster of radius 1 just fills the view.
    let apart = 1.0 / libm::sin(half_view);
    let eye = vec3(-1.0, -apart, 0.5);
    let lights = [vec3(3.0, -apart, 3.0), vec3(-4.0, -apart, 1.0), vec3(2.0, -apart, -4.0)];
    let mut scene = start(eye, eye + vec3(0.0, 1.0, 0.0), vec3(0.0, 0.0, 1.0), &lights);

    let wall = scene.add_material(fill("wall", [1.0, 1.0, 1.0], 1.0, 0.0, NO_SHINE));
    let depth = apart * f64::from(layers + 1);
    let half = 1.01 * libm::tan(half_view) * (depth + apart);
    let corner = |x: f64, z: f64| vec3(eye.x + x * half, depth, eye.z + z * half);
    scene.add(polygon([corner(1.0, 1.0), corner(-1.0, 1.0), corner(-1.0, -1.0), corner(1.0, -1.0)]), wall);

    let colors = COLORS.map(|(name, color)| scene.add_material(fill(name, color, 0.5, 0.2, 3.0827)));
    let rings = rings();
    for layer in 0..layers {
        let across = |i: u32| 2.0 * f64::from(i) - f64::from(layer);
        for (z, x) in (0..=layer).flat_map(|z| (0..=layer).map(move |x| (z, x))) {
            let middle = vec3(across(x), apart * f64::from(layer + 1), across(z));
            for (ring, &color) in rings.iter().zip(&colors) {
                for i in 0..5 {
                    let (base, top) = (middle + ring[i], middle + ring[(i + 4) % 5]);
                    scene.add(Shape::Cylinder { base, top, radius: ROD, capped: false }, color);
                    scene.add(Shape::Sphere { center: base, radius: ROD }, color);
                }
            }
        }
    }
    scene
}

/// The six regular pentagons around a common middle whose axes are the six diagonals of an icosahedron.
fn rings() -> [[Vec3; 5]; 6] {
    let direction = |degrees: f64| {
        let angle = degrees.to_radians();
        vec3(libm::cos(angle), libm::sin(angle), 0.0)
    };
    std::array::from_fn(|ring| {
        let (first, across) = if ring == 0 {
            (direction(0.0), direction(90.0))
        } else {
            // Diagonals of an icosahedron stand at the angle atan 2 to each other.
            let start = 72.0 * ring as f64 - 36.0;
            let tilted = direction(start + 90.0) + vec3(0.0, 0.0, 2.0);
            (direction(start), tilted * (1.0 / libm::sqrt(5.0)))
        };
        std::array::from_fn(|corner| {
            let turn = direction(72.0 * corner as f64);
            (first * turn.x + across * turn.y) * REACH
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rods_and_wall_are_those_of_the_database() {
        let scene = build(2);
        assert_eq!(scene.objects.len(), 1 + 300);
        let Shape::Polygon { outline, .. } = &scene.objects[0].shape else { panic!() };
        // Printed with six digits by the original.
        assert!((outline[0] - vec3(3.37286, 7.83938, 4.87286)).length() < 2e-5);
        let Shape::Cylinder { base, top, .. } = scene.objects[1 + 12].shape else { panic!() };
        assert!((base - vec3(0.0, 3.10258, 0.791951)).length() < 1e-5, "{base:?}");
        assert!((top - vec3(0.753191, 3.16035, 0.0)).length() < 1e-5, "{top:?}");
    }
}
