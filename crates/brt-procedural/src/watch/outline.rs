//! Closed curves in the plane of the movement: what bridges, rims and screws are cut from.

use core::f64::consts::{PI, TAU};

use brt_geometry::{Vec3, vec3};

/// A point of a curve (z = 0) and the unit direction away from the material there.
#[derive(Clone, Copy)]
pub(super) struct Corner {
    pub(super) at: Vec3,
    pub(super) out: Vec3,
}

/// A closed curve, counter-clockwise around the material.
#[derive(Clone)]
pub(super) struct Outline(pub(super) Vec<Corner>);

/// The unit vector at this angle to the x axis.
pub(super) fn direction(angle: f64) -> Vec3 {
    vec3(libm::cos(angle), libm::sin(angle), 0.0)
}

/// The angle of a vector to the x axis.
pub(super) fn angle_of(v: Vec3) -> f64 {
    libm::atan2(v.y, v.x)
}

impl Outline {
    pub(super) fn circle(center: Vec3, radius: f64, segments: u32) -> Self {
        let corner = |i: u32| {
            let out = direction(TAU * f64::from(i) / f64::from(segments));
            Corner { at: center + out * radius, out }
        };
        Self((0..segments).map(corner).collect())
    }

    /// A rubber band around circles, given by centre and radius.
    pub(super) fn around(circles: &[(Vec3, f64)], segments: u32) -> Self {
        let mut angles: Vec<f64> = (0..segments).map(|i| TAU * f64::from(i) / f64::from(segments)).collect();
        for (i, &(a, ra)) in circles.iter().enumerate() {
            for &(b, rb) in &circles[i + 1..] {
                // Directions in which both reach equally far: there the band leaves one for the other.
                let way = b - a;
                let half = libm::acos(((ra - rb) / way.length()).clamp(-1.0, 1.0));
                angles.extend([-half, half].map(|turn| (angle_of(way) + turn + 2.0 * TAU) % TAU));
            }
        }
        angles.sort_by(f64::total_cmp);
        angles.dedup();
        let mut corners: Vec<(usize, f64)> = Vec::new();
        for (i, &from) in angles.iter().enumerate() {
            let to = angles.get(i + 1).copied().unwrap_or(angles[0] + TAU);
            let farthest = farthest(circles, direction((from + to) / 2.0));
            for corner in [(farthest, from), (farthest, to % TAU)] {
                if corners.last() != Some(&corner) && corners.first() != Some(&corner) {
                    corners.push(corner);
                }
            }
        }
        let place = |(circle, angle): (usize, f64)| {
            let (center, radius) = circles[circle];
            Corner { at: center + direction(angle) * radius, out: direction(angle) }
        };
        Self(corners.into_iter().map(place).collect())
    }

    /// A curved arm with round ends along a cubic Bézier curve; `widths`: half the width at the start, in the middle,
    /// at the end.
    pub(super) fn arm(curve: [Vec3; 4], widths: [f64; 3], segments: u32) -> Self {
        let count = segments / 2;
        let sample = |i: u32| {
            let t = f64::from(i) / f64::from(count);
            let (point, along) = bezier(curve, t);
            (point, vec3(-along.y, along.x, 0.0), width(widths, t))
        };
        let right = (0..=count).map(sample).map(|(p, left, w)| p - left * w);
        let left = (0..=count).rev().map(sample).map(|(p, left, w)| p + left * w);
        let cap = |(center, left, w): (Vec3, Vec3, f64), from: f64| {
            let start = angle_of(left) + from;
            (1..count).map(move |i| center + direction(start + PI * f64::from(i) / f64::from(count)) * w)
        };
        let points: Vec<Vec3> =
            right.chain(cap(sample(count), PI)).chain(left).chain(cap(sample(0), 0.0)).collect();
        Self::smooth(&points)
    }

    /// A smooth curve through these points.
    fn smooth(points: &[Vec3]) -> Self {
        let n = points.len();
        let corner = |i: usize| {
            let along = points[(i + 1) % n] - points[(i + n - 1) % n];
            Corner { at: points[i], out: vec3(along.y, -along.x, 0.0).normalize() }
        };
        Self((0..n).map(corner).collect())
    }

    /// The same curve as the border of a hole in material around it.
    pub(super) fn as_hole(&self) -> Self {
        Self(self.0.iter().rev().map(|c| Corner { at: c.at, out: -c.out }).collect())
    }

    /// The curve moved into the material.
    pub(super) fn inset(&self, distance: f64) -> Self {
        Self(self.0.iter().map(|c| Corner { at: c.at - c.out * distance, out: c.out }).collect())
    }

    /// The points at a height.
    pub(super) fn at_height(&self, z: f64) -> Vec<Vec3> {
        self.0.iter().map(|c| c.at + vec3(0.0, 0.0, z)).collect()
    }
}

fn farthest(circles: &[(Vec3, f64)], along: Vec3) -> usize {
    let reach = |i: usize| circles[i].0.dot(along) + circles[i].1;
    (1..circles.len()).fold(0, |best, i| if reach(i) > reach(best) { i } else { best })
}

/// Point and unit tangent.
fn bezier([a, b, c, d]: [Vec3; 4], t: f64) -> (Vec3, Vec3) {
    let mix = |a: Vec3, b: Vec3| a * (1.0 - t) + b * t;
    let (ab, bc, cd) = (mix(a, b), mix(b, c), mix(c, d));
    let (abc, bcd) = (mix(ab, bc), mix(bc, cd));
    (mix(abc, bcd), (bcd - abc).normalize())
}

fn width([start, middle, end]: [f64; 3], t: f64) -> f64 {
    let smooth = |a: f64, b: f64, t: f64| a + (b - a) * t * t * (3.0 - 2.0 * t);
    if t < 0.5 { smooth(start, middle, 2.0 * t) } else { smooth(middle, end, 2.0 * t - 1.0) }
}

#[cfg(test)]
mod tests {
    use brt_geometry::polygon_plane;

    use super::*;

    #[test]
    fn band_around_two_circles_has_the_area_of_a_stadium() {
        let band = Outline::around(&[(Vec3::ZERO, 1.0), (vec3(4.0, 0.0, 0.0), 1.0)], 720);
        let points = band.at_height(0.0);
        let area =
            (0..points.len()).map(|i| points[i].cross(points[(i + 1) % points.len()]).z / 2.0).sum::<f64>();
        // A rectangle of 4 × 2 and a circle of radius 1.
        assert!((area - (8.0 + PI)).abs() < 1e-3, "{area}");
    }

    #[test]
    fn outlines_run_counter_clockwise_and_look_away_from_the_material() {
        let p = vec3(1.0, 2.0, 0.0);
        let arm = [Vec3::ZERO, vec3(2.0, 0.0, 0.0), vec3(3.0, 3.0, 0.0), vec3(5.0, 3.0, 0.0)];
        for outline in [
            Outline::circle(p, 1.5, 40),
            Outline::around(&[(p, 1.0), (Vec3::ZERO, 0.5), (vec3(3.0, 0.0, 0.0), 0.8)], 40),
            Outline::arm(arm, [1.0, 0.5, 0.7], 40),
        ] {
            assert!(polygon_plane(&outline.at_height(0.0)).unwrap().normal.z > 0.999);
            let n = outline.0.len();
            for (i, corner) in outline.0.iter().enumerate() {
                let (before, after) = (outline.0[(i + n - 1) % n].at, outline.0[(i + 1) % n].at);
                let along = after - before;
                assert!(corner.out.dot(vec3(along.y, -along.x, 0.0).normalize()) > 0.9);
            }
        }
    }
}
