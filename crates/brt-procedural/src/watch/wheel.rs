//! Toothed wheels and pinions, and how they mesh.

use core::f64::consts::{PI, TAU};

use brt_geometry::Vec3;
use brt_scene::MaterialId;

use super::outline::{angle_of, direction};
use super::workshop::{Heights, Workshop};

/// Pitch diameter per tooth; the same for all wheels of the movement.
pub(super) const MODULE: f64 = 0.25;

/// A toothed wheel seen from above.
#[derive(Clone, Copy)]
pub(super) struct Wheel {
    pub(super) center: Vec3,
    pub(super) teeth: u32,
    /// Angle of the middle of one tooth.
    pub(super) phase: f64,
}

impl Wheel {
    pub(super) fn pitch_radius(self) -> f64 {
        f64::from(self.teeth) * MODULE / 2.0
    }

    fn pitch(self) -> f64 {
        TAU / f64::from(self.teeth)
    }

    /// A wheel with so many teeth that meshes with this one in the direction at this angle.
    pub(super) fn meshing(self, teeth: u32, angle: f64) -> Self {
        let mut other = Self { center: self.center, teeth, phase: 0.0 };
        other.center = self.center + direction(angle) * (self.pitch_radius() + other.pitch_radius());
        // Between the centres a tooth of one meets a gap of the other; they turn in opposite senses.
        let passed = (angle - self.phase) / self.pitch();
        other.phase = angle + PI - other.pitch() * (0.5 - passed);
        other
    }

    /// Another wheel on the same arbor.
    pub(super) fn with_teeth(self, teeth: u32) -> Self {
        Self { teeth, ..self }
    }

    /// Teeth with straight flanks and narrow tops.
    pub(super) fn outline(self) -> Vec<Vec3> {
        let r = self.pitch_radius();
        let (root, tip) = (r - 1.15 * MODULE, r + 0.85 * MODULE);
        let profile = [
            (-0.29, root),
            (-0.22, r),
            (-0.16, r + 0.45 * MODULE),
            (-0.07, tip),
            (0.07, tip),
            (0.16, r + 0.45 * MODULE),
            (0.22, r),
            (0.29, root),
        ];
        (0..self.teeth)
            .flat_map(|tooth| profile.map(|(at, radius)| (f64::from(tooth) + at, radius)))
            .map(|(at, radius)| self.center + direction(self.phase + self.pitch() * at) * radius)
            .collect()
    }
}

/// The openings between `count` straight spokes of a given half width, from the hub to the rim; clockwise.
pub(super) fn openings(
    center: Vec3,
    [hub, rim]: [f64; 2],
    count: u32,
    half_width: f64,
    segments: u32,
) -> Vec<Vec<Vec3>> {
    let sector = TAU / f64::from(count);
    let arc = |start: f64, radius: f64, steps: u32| {
        let edge = libm::asin(half_width / radius);
        let sweep = sector - 2.0 * edge;
        (0..=steps)
            .map(move |i| center + direction(start + edge + sweep * f64::from(i) / f64::from(steps)) * radius)
            .collect::<Vec<_>>()
    };
    let steps = (segments / count).max(4);
    (0..count)
        .map(|i| {
            let start = sector * f64::from(i);
            let mut points = arc(start, hub, steps / 2);
            points.extend(arc(start, rim, steps).into_iter().rev());
            points
        })
        .collect()
}

impl Workshop {
    /// A wheel with spokes and a raised hub.
    pub(super) fn wheel(&mut self, body: MaterialId, wheel: Wheel, spokes: u32, z: Heights) {
        let r = wheel.pitch_radius();
        let hub = (0.22 * r).max(0.75);
        let holes = openings(wheel.center, [hub, r - 0.75], spokes, 0.06 * r, self.segments);
        self.prism(body, &wheel.outline(), &holes, z);
        self.stud(body, wheel.center, hub * 0.72, [z[1], z[1] + 0.14], 0.06);
    }

    /// A pinion: a wheel without openings.
    pub(super) fn pinion(&mut self, wheel: Wheel, z: Heights) {
        self.prism(self.metals.arbor, &wheel.outline(), &[], z);
    }

    /// An arbor between two heights.
    pub(super) fn arbor(&mut self, center: Vec3, radius: f64, z: Heights) {
        self.stud(self.metals.arbor, center, radius, z, 0.03);
    }
}

/// The angle of the way from one place to another.
pub(super) fn towards(from: Vec3, to: Vec3) -> f64 {
    angle_of(to - from)
}

#[cfg(test)]
mod tests {
    use brt_geometry::vec3;

    use super::*;

    #[test]
    fn meshing_wheels_do_not_cut_into_each_other() {
        let wheel = Wheel { center: vec3(1.0, 2.0, 0.0), teeth: 40, phase: 0.3 };
        for teeth in [8, 10, 24] {
            for angle in [0.0, 0.7, 3.3] {
                let other = wheel.meshing(teeth, angle);
                let outline = wheel.outline();
                for point in other.outline() {
                    assert!(!inside(point, &outline), "{teeth} at {angle}: {point:?}");
                }
            }
        }
    }

    fn inside(p: Vec3, outline: &[Vec3]) -> bool {
        let crossings = (0..outline.len()).filter(|&i| {
            let (a, b) = (outline[i], outline[(i + 1) % outline.len()]);
            (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)
        });
        crossings.count() % 2 == 1
    }
}
