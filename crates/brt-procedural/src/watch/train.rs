//! The wheels: from the barrel over centre, third and fourth wheel to the escape wheel, and the winding wheels.

use core::f64::consts::TAU;

use brt_geometry::{Vec3, vec3};

use super::outline::direction;
use super::wheel::Wheel;
use super::workshop::Workshop;

/// Where the wheels turn.
pub(super) struct Train {
    pub(super) barrel: Wheel,
    pub(super) center: Wheel,
    pub(super) third: Wheel,
    pub(super) fourth: Wheel,
    pub(super) escape: Wheel,
    pub(super) ratchet: Wheel,
    pub(super) crown: Wheel,
}

impl Train {
    /// Each pinion meshes with the wheel before it; directions are chosen so that all fit on the plate.
    pub(super) fn new() -> Self {
        let barrel = Wheel { center: vec3(-8.0, 5.0, 0.0), teeth: 48, phase: 0.0 };
        let step = |wheel: Wheel, pinion: u32, degrees: f64| wheel.meshing(pinion, degrees.to_radians());
        let center = step(barrel, 10, -25.0);
        let third = step(center.with_teeth(40), 8, 35.0);
        let fourth = step(third.with_teeth(36), 8, -30.0);
        let escape = step(fourth.with_teeth(32), 8, -100.0);
        let ratchet = Wheel { teeth: 32, phase: 0.06, ..barrel };
        let crown = step(ratchet, 24, -80.0);
        Self { barrel, center, third, fourth, escape, ratchet, crown }
    }
}

impl Workshop {
    /// Wheels and pinions at their levels above the plate (at 2.4) and below the bridges (at 5.8).
    pub(super) fn train(&mut self, train: &Train) {
        let (brass, gold) = (self.metals.brass, self.metals.gold);
        let barrel = train.barrel;
        self.prism(brass, &barrel.outline(), &[], [3.0, 3.6]);
        self.stud(brass, barrel.center, 5.2, [3.6, 4.25], 0.25);
        self.arbor(barrel.center, 0.9, [4.25, 5.9]);

        self.pinion(train.center, [2.8, 4.5]);
        self.wheel(gold, train.center.with_teeth(40), 5, [4.6, 5.0]);
        self.pinion(train.third, [3.7, 5.3]);
        self.wheel(brass, train.third.with_teeth(36), 4, [3.2, 3.6]);
        self.pinion(train.fourth, [2.8, 4.5]);
        self.wheel(gold, train.fourth.with_teeth(32), 5, [4.6, 5.0]);
        self.pinion(train.escape, [3.6, 5.2]);
        self.escape_wheel(train.escape.center, 2.6);
        for wheel in [train.center, train.third, train.fourth, train.escape] {
            self.arbor(wheel.center, 0.32, [2.4, 6.0]);
        }
    }

    /// Fifteen slender hooked teeth.
    fn escape_wheel(&mut self, center: Vec3, radius: f64) {
        let teeth = 15;
        let pitch = TAU / f64::from(teeth);
        let profile =
            [(0.0, 0.74), (0.14, 0.78), (0.34, 0.97), (0.3, 1.0), (0.46, 1.0), (0.43, 0.78), (0.56, 0.74)];
        let outline: Vec<Vec3> = (0..teeth)
            .flat_map(|i| profile.map(|(at, r)| (f64::from(i) + at, r)))
            .map(|(at, r)| center + direction(pitch * at) * (r * radius))
            .collect();
        let holes = super::wheel::openings(center, [0.75, 0.62 * radius], 4, 0.14, self.segments);
        self.prism(self.metals.arbor, &outline, &holes, [3.0, 3.3]);
    }

    /// Ratchet and crown wheel on the barrel bridge, whose top is at `z`.
    pub(super) fn winding(&mut self, train: &Train, z: f64) {
        let steel = self.metals.arbor;
        for (wheel, screw) in [(train.ratchet, 1.5), (train.crown, 1.15)] {
            let r = wheel.pitch_radius();
            self.prism(steel, &wheel.outline(), &[], [z + 0.1, z + 0.7]);
            // Rings turned into the top catch the light at many angles.
            for share in [0.86, 0.72, 0.58] {
                self.washer(steel, wheel.center, [r * (share - 0.1), r * share], [z + 0.7, z + 0.82]);
            }
            self.screw(wheel.center, screw, z + 0.7, 0.5);
        }
    }
}
