//! Affine maps: how a shape is placed in the scene.

use crate::{Vec3, vec3};

/// An affine map of space: a linear part, then an offset.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Affine {
    /// Images of the three unit vectors, without the offset.
    pub axes: [Vec3; 3],
    /// Image of the origin.
    pub offset: Vec3,
}

impl Affine {
    /// The map that changes nothing.
    pub const IDENTITY: Self =
        Self { axes: [vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0), vec3(0.0, 0.0, 1.0)], offset: Vec3::ZERO };

    /// The map with these three rows of four numbers: row · (x, y, z, 1) is a coordinate of the image.
    pub fn from_rows(rows: [[f64; 4]; 3]) -> Self {
        let column = |i: usize| vec3(rows[0][i], rows[1][i], rows[2][i]);
        Self { axes: [column(0), column(1), column(2)], offset: column(3) }
    }

    /// The rows that [`Self::from_rows`] takes.
    pub fn rows(&self) -> [[f64; 4]; 3] {
        let [a, b, c] = self.axes;
        std::array::from_fn(|i| [a[i], b[i], c[i], self.offset[i]])
    }

    /// First `self`, then `outer`.
    #[must_use]
    pub fn then(&self, outer: &Self) -> Self {
        Self { axes: self.axes.map(|axis| outer.direction(axis)), offset: outer.point(self.offset) }
    }

    /// The image of a point.
    pub fn point(&self, p: Vec3) -> Vec3 {
        self.direction(p) + self.offset
    }

    /// The image of a difference of points.
    pub fn direction(&self, d: Vec3) -> Vec3 {
        self.axes[0] * d.x + self.axes[1] * d.y + self.axes[2] * d.z
    }

    /// The normal of the image of a surface with normal `n`, of any length. It stays on the side that the images of
    /// points in front of the surface are on, also where the map mirrors.
    pub fn normal(&self, n: Vec3) -> Vec3 {
        let [a, b, c] = self.axes;
        let cofactors = b.cross(c) * n.x + c.cross(a) * n.y + a.cross(b) * n.z;
        if self.mirrors() { -cofactors } else { cofactors }
    }

    /// Factor by which volumes grow; negative where the map turns right hands into left ones.
    pub fn determinant(&self) -> f64 {
        let [a, b, c] = self.axes;
        a.cross(b).dot(c)
    }

    /// Does it turn right hands into left ones?
    pub fn mirrors(&self) -> bool {
        self.determinant() < 0.0
    }

    /// Are all numbers finite?
    pub fn is_finite(&self) -> bool {
        self.axes.iter().all(|axis| axis.is_finite()) && self.offset.is_finite()
    }
}

impl Default for Affine {
    fn default() -> Self {
        Self::IDENTITY
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn maps_follow_each_other() {
        // Twice as wide, then a quarter turn about z and one to the right: (1, 2, 3) → (2, 2, 3) → (−2 + 1, 2, 3).
        let wide = Affine::from_rows([[2.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]]);
        let turn = Affine::from_rows([[0.0, -1.0, 0.0, 1.0], [1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]]);
        let both = wide.then(&turn);
        assert_eq!(both.point(vec3(1.0, 2.0, 3.0)), vec3(-1.0, 2.0, 3.0));
        assert_eq!(Affine::from_rows(both.rows()), both);
    }

    #[test]
    fn normals_stay_normal_and_in_front() {
        // The plane x + y = 0 with (1, 1, 0) in front, stretched along x and mirrored: 1/−3·x + y = 0.
        let map = Affine::from_rows([[-3.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]]);
        let normal = map.normal(vec3(1.0, 1.0, 0.0));
        assert_eq!(normal.dot(map.direction(vec3(1.0, -1.0, 0.0))), 0.0);
        assert!(normal.dot(map.direction(vec3(1.0, 1.0, 0.0))) > 0.0);
        assert!(map.mirrors());
    }
}
