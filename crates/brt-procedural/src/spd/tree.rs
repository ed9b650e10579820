//! A tree of cones with spheres at their joints; every branch ends in two.

use brt_geometry::{Vec3, vec3};
use brt_scene::{MaterialId, Scene, Shape};

use super::{NO_SHINE, fill, polygon, start};

/// How a branch leaves its parent: turned about the parent's axis, tilted away from it, shorter than it.
struct Fork {
    roll_deg: f64,
    tilt_deg: f64,
    length: f64,
}

const FORKS: [Fork; 2] = [
    Fork { roll_deg: 0.0, tilt_deg: 40.0, length: 0.65 },
    Fork { roll_deg: 140.0, tilt_deg: 25.0, length: 0.7 },
];
/// Radius of a branch's end relative to its beginning.
const TAPER: f64 = 0.67;

/// `depth` forks above the trunk.
pub(crate) fn build(depth: u32) -> Scene {
    let lights = [
        vec3(-5.0, 5.0, 50.0),
        vec3(30.0, -30.0, 30.0),
        vec3(-40.0, -30.0, 20.0),
        vec3(10.0, 30.0, 40.0),
        vec3(-30.0, 40.0, 10.0),
        vec3(50.0, 25.0, 20.0),
        vec3(-10.0, -60.0, 30.0),
    ];
    let mut scene = start(vec3(4.5, 0.4, 2.0), vec3(0.0, 0.0, 1.5), vec3(0.0, 0.0, 1.0), &lights);
    let grass = scene.add_material(fill("grass", [0.2, 0.7, 0.2], 1.0, 0.0, NO_SHINE));
    let bark = scene.add_material(fill("bark", [0.55, 0.4, 0.2], 1.0, 0.0, NO_SHINE));
    let corner = |x: f64, y: f64| vec3(50.0 * x, 50.0 * y, 0.0);
    scene.add(polygon([corner(1.0, 1.0), corner(-1.0, 1.0), corner(-1.0, -1.0), corner(1.0, -1.0)]), grass);
    let trunk = Branch { base: Vec3::ZERO, frame: Frame::UPRIGHT, length: 1.0, radius: 0.15 };
    trunk.grow(&mut scene, bark, depth);
    scene
}

struct Branch {
    base: Vec3,
    frame: Frame,
    length: f64,
    radius: f64,
}

impl Branch {
    fn grow(&self, scene: &mut Scene, bark: MaterialId, depth: u32) {
        let top = self.base + self.frame.z * self.length;
        let top_radius = self.radius * TAPER;
        let cone = Shape::Cone { base: self.base, base_radius: self.radius, top, top_radius, capped: false };
        scene.add(cone, bark);
        scene.add(Shape::Sphere { center: top, radius: top_radius }, bark);
        if depth == 0 {
            return;
        }
        for fork in &FORKS {
            let frame = self.frame.fork(fork);
            let child = Branch { base: top, frame, length: self.length * fork.length, radius: top_radius };
            child.grow(scene, bark, depth - 1);
        }
    }
}

/// Three axes at right angles; the branch runs along z.
#[derive(Clone, Copy)]
struct Frame {
    x: Vec3,
    y: Vec3,
    z: Vec3,
}

impl Frame {
    const UPRIGHT: Self = Self { x: vec3(1.0, 0.0, 0.0), y: vec3(0.0, 1.0, 0.0), z: vec3(0.0, 0.0, 1.0) };

    fn fork(self, fork: &Fork) -> Self {
        let (roll, tilt) = (fork.roll_deg.to_radians(), fork.tilt_deg.to_radians());
        let (out, side) = turned(self.x, self.y, roll);
        let (z, x) = turned(self.z, out, tilt);
        // A quarter turn from fork to fork lets the tree grow in all directions.
        Self { x: side, y: -x, z }
    }
}

/// Two axes turned in their plane, the first towards the second.
fn turned(a: Vec3, b: Vec3, angle: f64) -> (Vec3, Vec3) {
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    (a * cos + b * sin, b * cos - a * sin)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn branches_are_those_of_the_database() {
        let scene = build(5);
        assert_eq!(scene.objects.len(), 1 + 126);
        // The first branch of the third level, printed with six digits by the original.
        let Shape::Sphere { center, radius } = scene.objects[1 + 5].shape else { panic!() };
        assert!((center - vec3(0.625853, 0.271578, 1.74586)).length() < 1e-5, "{center:?}");
        assert!((radius - 0.0451145).abs() < 1e-7);
    }
}
