//! Screws, jewels, rims.

use core::f64::consts::PI;

use brt_geometry::{Vec3, vec3};
use brt_scene::{MaterialId, Mesh, Shape};

use super::outline::direction;
use super::workshop::{Heights, Workshop};

impl Workshop {
    /// A screw with a slotted head that stands on a surface at height `z`.
    pub(super) fn screw(&mut self, center: Vec3, radius: f64, z: f64, slot_angle: f64) {
        let blued = self.metals.blued;
        let (floor, top) = (z + 0.3 * radius, z + 0.55 * radius);
        self.washer(self.metals.gold, center, [radius * 1.08, radius * 1.3], [z, z + 0.1 * radius]);
        self.stud(blued, center, radius, [z, floor], 0.0);
        for side in [slot_angle, slot_angle + PI] {
            self.half_moon(blued, (center, radius), side, [floor, top]);
        }
    }

    /// The part of a round head on the left of its slot, which runs at the angle `side`; bevelled along the arc.
    fn half_moon(
        &mut self,
        body: MaterialId,
        (center, radius): (Vec3, f64),
        side: f64,
        [low, high]: Heights,
    ) {
        let (half_slot, bevel) = (0.14 * radius, 0.12 * radius);
        let steps = self.segments / 2;
        // The slot's wall is flat: arcs of all radii end in the same plane.
        let arc = |r: f64| -> Vec<Vec3> {
            let edge = libm::asin(half_slot / r);
            let sweep = PI - 2.0 * edge;
            (0..=steps)
                .map(|i| direction(side + edge + sweep * f64::from(i) / f64::from(steps)) * r)
                .collect()
        };
        let ring =
            |r: f64, z: f64| arc(r).into_iter().map(|p| center + p + vec3(0.0, 0.0, z)).collect::<Vec<_>>();
        let rings = [ring(radius, low), ring(radius, high - bevel), ring(radius - bevel, high)];
        for (below, above) in [(&rings[0], &rings[1]), (&rings[1], &rings[2])] {
            self.scene.add(Shape::from(band(below, above, center)), body);
        }
        let [bottom, middle, top] = [&rings[0], &rings[1], &rings[2]].map(|r| [r[r.len() - 1], r[0]]);
        let chord = vec![bottom[0], bottom[1], middle[1], top[1], top[0], middle[0]];
        let [.., face] = rings;
        for outline in [chord, face] {
            self.scene.add(Shape::Polygon { outline, holes: Vec::new() }, body);
        }
    }

    /// A flat ring with a ridge, made of two cones.
    pub(super) fn washer(
        &mut self,
        body: MaterialId,
        center: Vec3,
        [inner, outer]: [f64; 2],
        [low, high]: Heights,
    ) {
        let at = |z: f64| vec3(center.x, center.y, z);
        let ridge = outer - 0.3 * (outer - inner);
        for (radius, end) in [(outer, low), (inner, (low + 3.0 * high) / 4.0)] {
            let cone = Shape::Cone {
                base: at(end),
                base_radius: radius,
                top: at(high),
                top_radius: ridge,
                capped: false,
            };
            self.scene.add(cone, body);
        }
    }

    /// A jewel in a gold setting on a surface at height `z`, with the pivot that turns in it.
    pub(super) fn jewel(&mut self, center: Vec3, radius: f64, z: f64) {
        let high = z + 0.28 * radius;
        self.washer(self.metals.gold, center, [radius, radius * 1.5], [z, high]);
        let at = |height: f64| vec3(center.x, center.y, height);
        // Only the cap of this ball stands out of the setting.
        let ball = 1.25 * radius;
        let sunk = libm::sqrt(ball * ball - radius * radius);
        let ruby = Shape::Sphere { center: at(z + 0.15 * radius - sunk), radius: ball };
        self.scene.add(ruby, self.metals.ruby);
        let crest = z + 0.15 * radius - sunk + ball;
        self.stud(
            self.metals.arbor,
            center,
            0.16 * radius,
            [crest - 0.1 * radius, crest + 0.12 * radius],
            0.04 * radius,
        );
    }

    /// A round pillar.
    pub(super) fn pillar(&mut self, body: MaterialId, center: Vec3, radius: f64, [low, high]: Heights) {
        let at = |z: f64| vec3(center.x, center.y, z);
        self.scene.add(Shape::Cylinder { base: at(low), top: at(high), radius, capped: false }, body);
        self.washer(self.metals.gold, center, [radius, radius * 1.25], [low, low + 0.18]);
    }
}

/// The smooth side between two arcs around an upright axis through `center`, the lower one first.
fn band(below: &[Vec3], above: &[Vec3], center: Vec3) -> Mesh {
    let mut mesh = Mesh::default();
    for (&a, &b) in below.iter().zip(above) {
        let out = vec3(a.x - center.x, a.y - center.y, 0.0).normalize();
        let step = b - a;
        let normal = (out * step.z - vec3(0.0, 0.0, step.dot(out))).normalize();
        mesh.positions.extend([a, b]);
        mesh.normals.extend([normal, normal]);
    }
    for i in 0..below.len() as u32 - 1 {
        mesh.triangles.extend([[2 * i, 2 * i + 2, 2 * i + 3], [2 * i, 2 * i + 3, 2 * i + 1]]);
    }
    mesh
}
