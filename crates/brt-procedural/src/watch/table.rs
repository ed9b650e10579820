//! The mirror, the backdrop, and what lies around the movement: crown, loupe, loose parts.

use core::f64::consts::TAU;

use brt_geometry::{Vec3, vec3};
use brt_scene::{Mesh, Shape};

use super::bridges::PLATE;
use super::outline::direction;
use super::wheel::Wheel;
use super::workshop::Workshop;

impl Workshop {
    /// The dark mirror, and far behind it a wall with a soft glow.
    pub(super) fn surroundings(&mut self) {
        let table = Shape::Plane { normal: vec3(0.0, 0.0, 1.0), distance: 0.0 };
        self.scene.add(table, self.metals.table);
        let wall = Shape::Plane { normal: vec3(0.0, -1.0, 0.0), distance: -95.0 };
        self.scene.add(wall, self.metals.backdrop);
    }

    /// The crown at the end of its stem, with knurls all around.
    pub(super) fn crown(&mut self) {
        let out = direction(197.0f64.to_radians());
        let at = |r: f64| out * r + vec3(0.0, 0.0, 1.7);
        let (gold, arbor) = (self.metals.gold, self.metals.arbor);
        let stem =
            Shape::Cylinder { base: at(PLATE - 0.5), top: at(PLATE + 1.6), radius: 0.4, capped: false };
        self.scene.add(stem, arbor);
        let (near, far, radius) = (PLATE + 1.4, PLATE + 3.7, 1.5);
        let body = Shape::Cylinder { base: at(near), top: at(far), radius, capped: true };
        self.scene.add(body, gold);
        let dome = Shape::Cone {
            base: at(far),
            base_radius: radius - 0.25,
            top: at(far + 0.45),
            top_radius: 0.9,
            capped: true,
        };
        self.scene.add(dome, gold);
        let (side, up) = (vec3(-out.y, out.x, 0.0), vec3(0.0, 0.0, 1.0));
        let knurls = 28;
        for i in 0..knurls {
            let turn = direction(TAU * f64::from(i) / f64::from(knurls));
            let off = (side * turn.x + up * turn.y) * radius;
            let knurl = Shape::Cylinder {
                base: at(near + 0.15) + off,
                top: at(far - 0.15) + off,
                radius: 0.13,
                capped: true,
            };
            self.scene.add(knurl, gold);
        }
    }

    /// A watchmaker's loupe, a lens in a gold rim, that leans on the plate's border in this direction.
    pub(super) fn loupe(&mut self, degrees: f64, radius: f64) {
        let out = direction(degrees.to_radians());
        let (lean, upright) = (0.5, libm::sqrt(0.75));
        let axis = out * lean + vec3(0.0, 0.0, upright);
        // Its lowest point touches the mirror.
        let height = (radius + 0.6) * lean + 0.55 * upright + 0.02;
        let center = out * (PLATE + 0.35) + vec3(0.0, 0.0, height);
        let half = axis * 0.55;
        let gold = self.metals.gold;
        for (r, outer) in [(radius + 0.02, false), (radius + 0.6, true)] {
            let grow = if outer { 0.0 } else { 0.12 };
            let ring = Shape::Cylinder {
                base: center - half - axis * grow,
                top: center + half + axis * grow,
                radius: r,
                capped: false,
            };
            self.scene.add(ring, gold);
        }
        for side in [1.0, -1.0] {
            let rim = Shape::Cone {
                base: center + half * side,
                base_radius: radius + 0.6,
                top: center + (half + axis * 0.12) * side,
                top_radius: radius + 0.02,
                capped: false,
            };
            self.scene.add(rim, gold);
        }
        self.scene.add(Shape::from(lens(center, axis, radius, self.segments)), self.metals.glass);
    }

    /// A spare wheel, screws and jewels that lie on the mirror.
    pub(super) fn loose_parts(&mut self) {
        let spare = Wheel { center: vec3(-19.0, -12.5, 0.0), teeth: 28, phase: 0.1 };
        self.wheel(self.metals.brass, spare, 4, [0.03, 0.4]);
        for (x, y, turn) in [(-13.5, -14.4, 0.4), (-10.6, -16.0, 1.9), (-22.8, -8.0, 2.6)] {
            self.screw(vec3(x, y, 0.0), 0.8, 0.03, turn);
        }
        for (x, y, radius) in
            [(-15.6, -15.6, 0.62), (-12.3, -16.7, 0.45), (-8.2, -17.2, 0.5), (-17.0, -16.7, 0.38)]
        {
            let center = vec3(x, y, radius + 0.01);
            self.scene.add(Shape::Sphere { center, radius }, self.metals.ruby);
        }
    }
}

/// A lens of two equal spherical caps that meet in a circle of this radius around the axis.
fn lens(center: Vec3, axis: Vec3, radius: f64, segments: u32) -> Mesh {
    let curvature = 2.6 * radius;
    let depth = libm::sqrt(curvature * curvature - radius * radius);
    let (u, v) = axis.tangents();
    let rings = segments / 8;
    let mut mesh = Mesh::default();
    for side in [1.0, -1.0] {
        let middle = center - axis * (depth * side);
        let first = mesh.positions.len() as u32;
        let mut push = |off: Vec3| {
            mesh.positions.push(middle + off);
            mesh.normals.push(off * (1.0 / curvature));
        };
        push(axis * (curvature * side));
        for ring in 1..=rings {
            let r = radius * f64::from(ring) / f64::from(rings);
            let height = libm::sqrt(curvature * curvature - r * r);
            for i in 0..segments {
                let turn = direction(TAU * f64::from(i) / f64::from(segments));
                push((u * turn.x + v * turn.y) * r + axis * (height * side));
            }
        }
        let at = |ring: u32, i: u32| first + 1 + (ring - 1) * segments + i % segments;
        let mut face =
            |[a, b, c]: [u32; 3]| mesh.triangles.push(if side > 0.0 { [a, b, c] } else { [a, c, b] });
        for i in 0..segments {
            face([first, at(1, i), at(1, i + 1)]);
            for ring in 1..rings {
                face([at(ring, i), at(ring + 1, i), at(ring + 1, i + 1)]);
                face([at(ring, i), at(ring + 1, i + 1), at(ring, i + 1)]);
            }
        }
    }
    mesh
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faces_of_the_lens_look_outwards() {
        let lens = lens(vec3(1.0, 2.0, 3.0), vec3(0.6, 0.0, 0.8), 4.0, 32);
        for &[a, b, c] in &lens.triangles {
            let [p, q, r] = [a, b, c].map(|i| lens.positions[i as usize]);
            assert!((q - p).cross(r - p).dot(lens.normals[b as usize]) > 0.0);
        }
    }
}
