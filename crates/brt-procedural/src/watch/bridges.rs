//! The main plate and the bridges that hold the upper pivots.

use core::f64::consts::TAU;

use brt_geometry::{Vec3, vec3};
use brt_scene::Shape;

use super::outline::{Outline, direction};
use super::train::Train;
use super::wheel::Wheel;
use super::workshop::Workshop;
use crate::random::Random;

/// Radius of the main plate.
pub(super) const PLATE: f64 = 16.5;
/// Height of its top.
pub(super) const FLOOR: f64 = 2.4;
/// Height of the bridges' lower and upper sides.
const BRIDGE: [f64; 2] = [5.8, 6.9];

impl Workshop {
    /// The plate on its four feet, a raised gold rim with studs around it.
    pub(super) fn main_plate(&mut self) {
        let (plate, gold) = (self.metals.plate, self.metals.gold);
        let down = Shape::Disc { center: vec3(0.0, 0.0, 1.0), normal: vec3(0.0, 0.0, -1.0), radius: PLATE };
        self.scene.add(down, plate);
        self.stud(plate, Vec3::ZERO, PLATE, [1.0, FLOOR], 0.3);
        self.washer(gold, Vec3::ZERO, [PLATE - 1.15, PLATE - 0.4], [FLOOR, FLOOR + 0.22]);
        let studs = 60;
        for i in 0..studs {
            let at = direction(TAU * f64::from(i) / f64::from(studs)) * (PLATE - 1.55);
            let radius = if i % 5 == 0 { 0.2 } else { 0.1 };
            self.scene.add(Shape::Sphere { center: at + vec3(0.0, 0.0, FLOOR), radius }, gold);
        }
        // The plate's side is fluted like a coin's.
        let flutes = 180;
        for i in 0..flutes {
            let at = direction(TAU * f64::from(i) / f64::from(flutes)) * PLATE;
            let flute = Shape::Cylinder {
                base: at + vec3(0.0, 0.0, 1.12),
                top: at + vec3(0.0, 0.0, 1.98),
                radius: 0.19,
                capped: true,
            };
            self.scene.add(flute, gold);
        }
        for i in 0..4 {
            let at = direction(TAU * (f64::from(i) + 0.5) / 4.0) * (PLATE - 2.5);
            let foot = Shape::Cylinder {
                base: at + vec3(0.0, 0.0, 0.05),
                top: at + vec3(0.0, 0.0, 1.0),
                radius: 1.1,
                capped: false,
            };
            self.scene.add(foot, gold);
        }
    }

    /// The bridge over barrel and winding wheels.
    pub(super) fn barrel_bridge(&mut self, train: &Train) -> f64 {
        let [barrel, crown] = [train.ratchet.center, train.crown.center];
        let ears = [vec3(-11.6, -5.2, 0.0), vec3(-4.2, 12.3, 0.0)];
        let outline =
            Outline::around(&[(barrel, 4.55), (crown, 3.5), (ears[0], 1.5), (ears[1], 1.5)], self.segments);
        let bevel = 0.3;
        self.cut_open(self.metals.steel, &outline, &[], BRIDGE, bevel);
        let face = outline.inset(bevel).at_height(BRIDGE[1]);
        self.stripes([self.metals.steel, self.metals.stripe], &face, direction(0.45), 0.55);
        self.jewel(vec3(-11.3, -1.2, 0.0), 0.5, BRIDGE[1]);
        for ear in ears {
            self.pillar(self.metals.arbor, ear, 0.9, [FLOOR, BRIDGE[0]]);
            self.screw(ear, 0.85, BRIDGE[1], 0.9);
        }
        BRIDGE[1]
    }

    /// Curved fingers from the rim to the pivots of centre, third, fourth and escape wheel.
    pub(super) fn fingers(&mut self, train: &Train) {
        let finger = |foot: [f64; 2], bend: [f64; 2], pivot: Vec3| {
            let (foot, bend) = (vec3(foot[0], foot[1], 0.0), vec3(bend[0], bend[1], 0.0));
            [foot, foot + (bend - foot) * 0.6, pivot + (bend - pivot) * 0.6, pivot]
        };
        let fingers = [
            (finger([0.9, 14.0], [1.6, 8.2], train.center.center), 1.25),
            (finger([5.8, 12.8], [7.4, 8.5], train.third.center), 1.15),
            (finger([13.2, 5.4], [11.5, 1.6], train.fourth.center), 1.15),
            (finger([13.7, -2.4], [10.8, -4.0], train.escape.center), 0.95),
        ];
        for (curve, pad) in fingers {
            let outline = Outline::arm(curve, [1.45, 0.72, pad], self.segments);
            self.cut(self.metals.steel, &outline, &[], BRIDGE, 0.24);
            let [foot, .., pivot] = curve;
            self.pillar(self.metals.arbor, foot, 0.9, [FLOOR, BRIDGE[0]]);
            self.screw(foot, 0.72, BRIDGE[1], pivot.x + pivot.y);
            self.jewel(pivot, 0.4 * pad, BRIDGE[1]);
        }
    }

    /// The moon's disc: a toothed wheel of night sky with two moons and stars.
    pub(super) fn moon(&mut self) {
        let center = vec3(-6.3, -8.9, 0.0);
        let (blued, gold) = (self.metals.sky, self.metals.gold);
        let wheel = Wheel { center, teeth: 32, phase: 0.0 };
        self.prism(gold, &wheel.outline(), &[], [FLOOR + 0.15, FLOOR + 0.45]);
        let (r, sky) = (wheel.pitch_radius() - 0.35, FLOOR + 0.65);
        self.stud(blued, center, r - 0.1, [FLOOR + 0.45, sky], 0.1);
        let at = |degrees: f64, reach: f64| {
            center + direction(degrees.to_radians()) * (reach * r) + vec3(0.0, 0.0, sky)
        };
        for degrees in [40.0, 220.0] {
            self.scene
                .add(Shape::Sphere { center: at(degrees, 0.52) - vec3(0.0, 0.0, 0.55), radius: 1.05 }, gold);
        }
        // Stars keep to where the moons are not.
        let mut random = Random::new(59);
        for i in 0..34 {
            let half = if i % 2 == 0 { 130.0 } else { 310.0 };
            let (degrees, reach) =
                (half + random.between(-52.0, 52.0), libm::sqrt(random.between(0.1, 0.85)));
            let radius = random.between(0.03, 0.11);
            self.scene.add(Shape::Sphere { center: at(degrees, reach), radius }, gold);
        }
        self.washer(gold, center, [0.42, 0.75], [sky, sky + 0.15]);
        self.screw(center, 0.42, sky, 1.0);
    }
}
