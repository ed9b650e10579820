//! Sphereflake: on each sphere sit nine of a third of its radius, where its neighbours in the densest packing would.

use brt_geometry::{Vec3, vec3};
use brt_scene::{MaterialId, Scene, Shape};

use super::{NO_SHINE, fill, polygon, start};

/// Spheres down to `depth` levels below the first, over a floor.
pub(crate) fn build(depth: u32) -> Scene {
    let lights = [vec3(4.0, 3.0, 2.0), vec3(1.0, -4.0, 4.0), vec3(-3.0, 1.0, 5.0)];
    let mut scene = start(vec3(2.1, 1.3, 1.7), Vec3::ZERO, vec3(0.0, 0.0, 1.0), &lights);
    let floor = scene.add_material(fill("floor", [1.0, 0.75, 0.33], 0.8, 0.0, NO_SHINE));
    let ball = scene.add_material(fill("ball", [1.0, 0.9, 0.7], 0.5, 0.5, 3.0827));
    let corner = |x: f64, y: f64| vec3(12.0 * x, 12.0 * y, -0.5);
    scene.add(polygon([corner(1.0, 1.0), corner(-1.0, 1.0), corner(-1.0, -1.0), corner(1.0, -1.0)]), floor);
    let mut flake = Flake { scene, ball, directions: directions() };
    flake.grow(Vec3::ZERO, 0.5, vec3(0.0, 0.0, 1.0), depth);
    flake.scene
}

struct Flake {
    scene: Scene,
    ball: MaterialId,
    directions: [Vec3; 9],
}

impl Flake {
    fn grow(&mut self, center: Vec3, radius: f64, axis: Vec3, depth: u32) {
        self.scene.add(Shape::Sphere { center, radius }, self.ball);
        if depth == 0 {
            return;
        }
        for direction in self.directions {
            let child = turn(direction, axis);
            // The child touches its parent from outside.
            self.grow(center + child * (radius * 4.0 / 3.0), radius / 3.0, child, depth - 1);
        }
    }
}

/// Nine of the twelve neighbours of a ball in the densest packing, for the axis z: six around the equator, three above.
fn directions() -> [Vec3; 9] {
    let (above, height) = (libm::sqrt(1.0 / 3.0), libm::sqrt(2.0 / 3.0));
    let at = |degrees: f64, reach: f64, height: f64| {
        let angle = degrees.to_radians();
        vec3(reach * libm::cos(angle), reach * libm::sin(angle), height)
    };
    let mut directions = [Vec3::ZERO; 9];
    for (third, trio) in directions.chunks_exact_mut(3).enumerate() {
        let start = 120.0 * third as f64;
        trio[0] = at(start + 45.0, above, height);
        trio[1] = at(start + 15.0, 1.0, 0.0);
        trio[2] = at(start + 75.0, 1.0, 0.0);
    }
    directions
}

/// Turns a vector by the smallest rotation that brings z to this unit axis.
fn turn(v: Vec3, axis: Vec3) -> Vec3 {
    let cos = axis.z;
    // Straight down the smallest rotation is not unique; the databases turn about y.
    if cos <= -0.9999 {
        return vec3(-v.x, v.y, -v.z);
    }
    let sin_axis = vec3(0.0, 0.0, 1.0).cross(axis);
    v * cos + sin_axis.cross(v) + sin_axis * (sin_axis.dot(v) / (1.0 + cos))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_and_places_are_those_of_the_database() {
        let scene = build(2);
        assert_eq!(scene.objects.len(), 1 + 1 + 9 + 81);
        // The second grandchild, printed with six digits by the original.
        let Shape::Sphere { center, radius } = scene.objects[4].shape else { panic!() };
        assert!((center - vec3(0.461844, 0.304709, 0.43322)).length() < 2e-6);
        assert!((radius - 0.0555556).abs() < 1e-7);
    }
}
