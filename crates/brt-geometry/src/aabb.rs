//! Boxes along the axes.

use crate::{Vec3, vec3};

/// A box along the axes, faces included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    /// Lower corner.
    pub lo: Vec3,
    /// Upper corner.
    pub hi: Vec3,
}

impl Aabb {
    /// The box with this centre and half size.
    pub fn around(center: Vec3, half: Vec3) -> Self {
        Self { lo: center - half, hi: center + half }
    }

    /// The smallest box around points; empty (lower above upper) for none.
    pub fn of_points(points: &[Vec3]) -> Self {
        let empty = Self { lo: Vec3::splat(f64::INFINITY), hi: Vec3::splat(f64::NEG_INFINITY) };
        points.iter().fold(empty, |b, &p| Self { lo: b.lo.min(p), hi: b.hi.max(p) })
    }

    /// The smallest box around both.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self { lo: self.lo.min(other.lo), hi: self.hi.max(other.hi) }
    }

    /// Its middle.
    pub fn center(&self) -> Vec3 {
        (self.lo + self.hi) * 0.5
    }

    /// The length of its longest side.
    pub fn longest_side(&self) -> f64 {
        let size = self.hi - self.lo;
        size.x.max(size.y).max(size.z)
    }

    /// The eight corners.
    pub fn corners(&self) -> [Vec3; 8] {
        std::array::from_fn(|i| {
            let pick = |bit: usize, lo: f64, hi: f64| if i & bit == 0 { lo } else { hi };
            vec3(pick(1, self.lo.x, self.hi.x), pick(2, self.lo.y, self.hi.y), pick(4, self.lo.z, self.hi.z))
        })
    }
}
