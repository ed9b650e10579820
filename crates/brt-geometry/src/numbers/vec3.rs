//! Three-dimensional vectors over any [`Real`].

use std::ops::{Add, Index, IndexMut, Mul, Neg, Sub};

use super::Real;

/// A vector or point in space; lengths in scene units.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vec3<R = f64> {
    /// First coordinate: to the right in the scenes of the paper.
    pub x: R,
    /// Second coordinate: up in the scenes of the paper.
    pub y: R,
    /// Third coordinate: towards the viewer in the scenes of the paper (right-handed).
    pub z: R,
}

/// The vector (x, y, z).
#[inline(always)]
pub const fn vec3<R>(x: R, y: R, z: R) -> Vec3<R> {
    Vec3 { x, y, z }
}

impl Vec3<f64> {
    /// The origin.
    pub const ZERO: Self = vec3(0.0, 0.0, 0.0);

    /// The vector (x, x, x).
    pub const fn splat(x: f64) -> Self {
        vec3(x, x, x)
    }

    /// Smaller coordinate by coordinate.
    #[inline]
    pub fn min(self, other: Self) -> Self {
        vec3(self.x.min(other.x), self.y.min(other.y), self.z.min(other.z))
    }

    /// Greater coordinate by coordinate.
    #[inline]
    pub fn max(self, other: Self) -> Self {
        vec3(self.x.max(other.x), self.y.max(other.y), self.z.max(other.z))
    }

    /// Are all coordinates finite?
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite() && self.z.is_finite()
    }

    /// The vector of length 1 in this direction, also for lengths whose square under- or overflows.
    ///
    /// `None` for the zero vector and for coordinates that are not finite.
    pub fn try_normalize(self) -> Option<Self> {
        let greatest = self.x.abs().max(self.y.abs()).max(self.z.abs());
        // The greatest of a number and one that is none is the number.
        if !self.is_finite() || greatest == 0.0 {
            return None;
        }
        let scaled = vec3(self.x / greatest, self.y / greatest, self.z / greatest);
        Some(scaled.normalize())
    }

    /// Vector product, each coordinate right to two roundings of itself, even of vectors that are almost parallel (Kahan's
    /// difference of products: Jeannerod, Louvet, Muller 2013).
    pub fn cross_accurately(self, other: Self) -> Self {
        let difference = |a: f64, b: f64, c: f64, d: f64| {
            let cd = c * d;
            libm::fma(a, b, -cd) - libm::fma(c, d, -cd)
        };
        vec3(
            difference(self.y, other.z, self.z, other.y),
            difference(self.z, other.x, self.x, other.z),
            difference(self.x, other.y, self.y, other.x),
        )
    }

    /// Two unit vectors that span the plane normal to this unit vector.
    pub fn tangents(self) -> (Self, Self) {
        let axis = if self.x.abs() <= self.y.abs() && self.x.abs() <= self.z.abs() {
            vec3(1.0, 0.0, 0.0)
        } else if self.y.abs() <= self.z.abs() {
            vec3(0.0, 1.0, 0.0)
        } else {
            vec3(0.0, 0.0, 1.0)
        };
        let u = self.cross(axis).normalize();
        (u, self.cross(u))
    }

    /// The same vector over another [`Real`].
    #[inline(always)]
    pub fn lift<R: Real>(self) -> Vec3<R> {
        vec3(R::constant(self.x), R::constant(self.y), R::constant(self.z))
    }
}

impl<R: Real> Vec3<R> {
    /// Scalar product.
    #[inline(always)]
    pub fn dot(self, other: Self) -> R {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// Vector product. `a.cross(b)` is exactly `-(b.cross(a))`, rounding included: shared edges are watertight.
    #[inline(always)]
    pub fn cross(self, other: Self) -> Self {
        vec3(
            self.y * other.z - self.z * other.y,
            self.z * other.x - self.x * other.z,
            self.x * other.y - self.y * other.x,
        )
    }

    /// Square of the length.
    #[inline(always)]
    pub fn length_squared(self) -> R {
        self.dot(self)
    }

    /// Length.
    #[inline(always)]
    pub fn length(self) -> R {
        self.length_squared().sqrt()
    }

    /// The vector of length 1 in this direction; undefined for the zero vector.
    #[inline(always)]
    pub fn normalize(self) -> Self {
        self * self.length_squared().inverse_sqrt()
    }

    /// `yes` where the mask is true, else `no`.
    #[inline(always)]
    pub fn select(mask: R::Mask, yes: Self, no: Self) -> Self {
        vec3(R::select(mask, yes.x, no.x), R::select(mask, yes.y, no.y), R::select(mask, yes.z, no.z))
    }
}

impl<R: Real> Add for Vec3<R> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        vec3(self.x + other.x, self.y + other.y, self.z + other.z)
    }
}

impl<R: Real> Sub for Vec3<R> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        vec3(self.x - other.x, self.y - other.y, self.z - other.z)
    }
}

impl<R: Real> Mul<R> for Vec3<R> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: R) -> Self {
        vec3(self.x * factor, self.y * factor, self.z * factor)
    }
}

impl<R: Real> Neg for Vec3<R> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        vec3(-self.x, -self.y, -self.z)
    }
}

impl<R> Index<usize> for Vec3<R> {
    type Output = R;
    #[inline(always)]
    fn index(&self, axis: usize) -> &R {
        match axis {
            0 => &self.x,
            1 => &self.y,
            _ => &self.z,
        }
    }
}

impl<R> IndexMut<usize> for Vec3<R> {
    #[inline(always)]
    fn index_mut(&mut self, axis: usize) -> &mut R {
        match axis {
            0 => &mut self.x,
            1 => &mut self.y,
            _ => &mut self.z,
        }
    }
}

impl From<[f64; 3]> for Vec3<f64> {
    fn from([x, y, z]: [f64; 3]) -> Self {
        vec3(x, y, z)
    }
}

impl From<Vec3<f64>> for [f64; 3] {
    fn from(v: Vec3<f64>) -> Self {
        [v.x, v.y, v.z]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cross_product_is_exactly_antisymmetric() {
        let a = vec3(0.1, 1.0 / 3.0, 7.7e5);
        let b = vec3(-4.3e-3, 0.7, 0.123);
        assert_eq!(a.cross(b), -(b.cross(a)));
    }

    #[test]
    fn accurate_product_is_across_vectors_that_are_almost_parallel() {
        let a = vec3(1.0 / 3.0, 1.0 / 7.0, -0.6);
        let b = a * 1.5 + vec3(1e-12, 2e-12, 3e-12);
        let across = a.cross_accurately(b).normalize();
        assert!(across.dot(a).abs().max(across.dot(b).abs()) < 1e-15);
        assert!(a.cross(b).normalize().dot(a).abs() > 1e-6, "the plain product is not across");
    }

    #[test]
    fn tiny_and_huge_vectors_normalize() {
        for scale in [1e-300, 1.0, 1e300] {
            let n = (vec3(3.0, 0.0, 4.0) * scale).try_normalize().unwrap();
            // 3-4-5 triangle
            assert!((n - vec3(0.6, 0.0, 0.8)).length() < 1e-15);
        }
        assert!(Vec3::ZERO.try_normalize().is_none());
        assert!(vec3(f64::NAN, 1.0, 0.0).try_normalize().is_none());
        assert!(vec3(1.0, f64::INFINITY, 0.0).try_normalize().is_none());
    }
}
