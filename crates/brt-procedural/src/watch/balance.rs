//! The balance with its hairspring under a cock, and the pallet fork.

use core::f64::consts::TAU;

use brt_geometry::{Vec3, vec3};
use brt_scene::Shape;

use super::bridges::FLOOR;
use super::outline::{Outline, direction};
use super::train::Train;
use super::wheel::{openings, towards};
use super::workshop::Workshop;

/// Where the balance turns.
const AXIS: Vec3 = vec3(2.55, -6.34, 0.0);
/// Outer radius of its rim.
const RIM: f64 = 5.0;

impl Workshop {
    /// Everything around the balance.
    pub(super) fn balance(&mut self, train: &Train) {
        self.balance_wheel();
        self.hairspring();
        self.cock();
        self.fork(train.escape.center);
        // A gold line around the balance's place.
        self.washer(self.metals.gold, AXIS, [RIM + 0.95, RIM + 1.25], [FLOOR, FLOOR + 0.1]);
    }

    fn balance_wheel(&mut self) {
        let gold = self.metals.gold;
        let rim: Vec<Vec3> =
            Outline::circle(AXIS, RIM, 2 * self.segments).0.iter().map(|corner| corner.at).collect();
        let holes = openings(AXIS, [1.1, RIM - 0.75], 3, 0.32, self.segments);
        self.prism(gold, &rim, &holes, [5.3, 5.95]);
        let screws = 18;
        for i in 0..screws {
            let out = direction(TAU * (f64::from(i) + 0.5) / f64::from(screws));
            let at = |r: f64| AXIS + out * r + vec3(0.0, 0.0, 5.55);
            let head =
                Shape::Cylinder { base: at(RIM - 0.05), top: at(RIM + 0.5), radius: 0.24, capped: true };
            self.scene.add(head, self.metals.arbor);
        }
        self.arbor(AXIS, 0.3, [FLOOR, 7.5]);
        self.stud(self.metals.arbor, AXIS, 0.8, [5.95, 6.2], 0.08);
        self.stud(gold, AXIS, 0.7, [6.4, 6.95], 0.08);
    }

    /// A spiral of nine turns.
    fn hairspring(&mut self) {
        let turns = 9;
        let count = turns * self.segments;
        let [inner, outer] = [0.72, 3.75];
        let path: Vec<(Vec3, Vec3)> = (0..=count)
            .map(|i| {
                let share = f64::from(i) / f64::from(count);
                let angle = TAU * f64::from(turns) * share;
                let radius = inner + (outer - inner) * share;
                let (out, around) = (direction(angle), direction(angle + TAU / 4.0));
                // The radius grows by the same step in every turn.
                let along = around * radius + out * ((outer - inner) / (TAU * f64::from(turns)));
                (AXIS + out * radius + vec3(0.0, 0.0, 6.67), along.normalize())
            })
            .collect();
        self.tube(self.metals.blued, &path, 0.075);
        // The stud that holds the outer end hangs from the cock.
        self.pillar(self.metals.arbor, AXIS + vec3(outer, 0.0, 0.0), 0.2, [6.5, 7.4]);
    }

    fn cock(&mut self) {
        let foot = vec3(12.3, -8.6, 0.0);
        let curve = [foot, vec3(10.0, -4.6, 0.0), vec3(6.0, -6.34, 0.0), AXIS];
        let z = [7.4, 8.4];
        let outline = Outline::arm(curve, [1.9, 1.25, 1.6], self.segments);
        // An opening along the middle, on the same curve between its quarters.
        let slot = Outline::arm(middle(curve), [0.42, 0.4, 0.34], self.segments);
        self.cut(self.metals.steel, &outline, &[slot], z, 0.28);
        self.stud(self.metals.steel, foot, 1.5, [FLOOR, z[0] + 0.1], 0.0);
        self.screw(foot, 0.95, z[1], 2.2);
        self.jewel(AXIS, 0.72, z[1]);
        // The index, a slender needle across the cock.
        let tip = AXIS + vec3(-0.4, 3.4, 0.0);
        let needle = Outline::around(&[(AXIS + vec3(-0.13, 1.25, 0.0), 0.3), (tip, 0.1)], self.segments);
        self.cut(self.metals.gold, &needle, &[], [z[1] + 0.04, z[1] + 0.24], 0.0);
    }

    /// The fork between escape wheel and balance with its two ruby pallets.
    fn fork(&mut self, escape: Vec3) {
        let angle = towards(escape, AXIS);
        let along = direction(angle);
        let across = direction(angle + TAU / 4.0);
        let pivot = escape + along * 3.5;
        let curve = [-1.9, -0.7, 0.7, 1.9].map(|x: f64| pivot + across * x - along * (0.22 * x * x));
        let arms = Outline::arm(curve, [0.3, 0.42, 0.3], self.segments);
        self.cut(self.metals.arbor, &arms, &[], [3.5, 3.8], 0.0);
        let lever = Outline::around(&[(pivot, 0.42), (pivot + along * 2.3, 0.2)], self.segments);
        self.cut(self.metals.arbor, &lever, &[], [3.85, 4.1], 0.0);
        for x in [-1.75, 1.75] {
            let at = pivot + across * x - along * 0.9;
            let pallet = Shape::Sphere { center: at + vec3(0.0, 0.0, 3.55), radius: 0.3 };
            self.scene.add(pallet, self.metals.ruby);
        }
    }
}

/// The part of a cubic Bézier curve between a fifth and seven tenths of its parameter.
fn middle(curve: [Vec3; 4]) -> [Vec3; 4] {
    let until = split(curve, 0.7);
    let [a, b, c, d] = split([until[3], until[2], until[1], until[0]], 1.0 - 0.22 / 0.7);
    [d, c, b, a]
}

/// The beginning of a cubic Bézier curve by de Casteljau's method.
fn split([a, b, c, d]: [Vec3; 4], t: f64) -> [Vec3; 4] {
    let mix = |a: Vec3, b: Vec3| a * (1.0 - t) + b * t;
    let (ab, bc, cd) = (mix(a, b), mix(b, c), mix(c, d));
    let (abc, bcd) = (mix(ab, bc), mix(bc, cd));
    [a, ab, abc, mix(abc, bcd)]
}
