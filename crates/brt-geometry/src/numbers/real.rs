//! The number type of every predicate and of the shading formula.
//!
//! A formula written once over [`Real`] is read in several ways: as scalar `f64` by the tracers, and as a
//! [`Taylor`](crate::Taylor) model by bounds over whole blocks of samples. The second reading encloses what the
//! first one computes, its rounding included.
//!
//! Rules for code over `Real`: no branch on a comparison except through [`Mask::any`] and [`Mask::all`]; choose
//! with [`Real::select`]; no fused multiply-add and no approximate reciprocal, so that every reading rounds alike.

use std::fmt::Debug;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

use super::{Across, Vec3};

/// The answer to a comparison of two [`Real`] values.
pub trait Mask: Copy + Debug + BitAnd<Output = Self> + BitOr<Output = Self> + Not<Output = Self> {
    /// The mask that is true everywhere.
    const TRUE: Self;
    /// The mask that is false everywhere.
    const FALSE: Self;
    /// Is the comparison possibly true, for any value enclosed?
    fn any(self) -> bool;
    /// Is the comparison certainly true, for all values enclosed?
    fn all(self) -> bool;
}

/// A real number: scalar, or a conservative enclosure of many scalars.
pub trait Real:
    Copy
    + Debug
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
{
    /// What a comparison answers.
    type Mask: Mask;
    /// What rays keep for seeing points along them ([`Ray`](crate::Ray)); nothing where that is found anew each time.
    type Across: Across<Self>;

    /// The constant `x`.
    fn constant(x: f64) -> Self;
    /// Square root; of a negative value: undefined (scalar NaN), so guard with [`Real::max`].
    fn sqrt(self) -> Self;
    /// The smaller of both.
    fn min(self, other: Self) -> Self;
    /// The greater of both.
    fn max(self, other: Self) -> Self;
    /// `self < other`
    fn lt(self, other: Self) -> Self::Mask;
    /// `self <= other`
    fn le(self, other: Self) -> Self::Mask;
    /// `yes` where the mask is true, else `no`.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
    /// `self` to a power that is not whole, for `self >= 0`, `exponent >= 0`. [`Exponent`] takes whole ones too.
    fn broken_power(self, exponent: f64) -> Self;

    /// `1 / √self` for `self > 0`.
    #[inline(always)]
    fn inverse_sqrt(self) -> Self {
        Self::constant(1.0) / self.sqrt()
    }
    /// `self` to a whole power, for `self >= 0`.
    #[inline(always)]
    fn whole_power(self, exponent: u32) -> Self {
        power_by_squaring(self, exponent)
    }
    /// `self > other`
    #[inline(always)]
    fn gt(self, other: Self) -> Self::Mask {
        other.lt(self)
    }
    /// `self >= other`
    #[inline(always)]
    fn ge(self, other: Self) -> Self::Mask {
        other.le(self)
    }
}

/// An exponent, sorted by how a power is computed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Exponent {
    /// Up to 2²⁰: a fixed chain of multiplications.
    Whole(u32),
    /// Any other.
    Broken(f64),
}

impl Exponent {
    /// The exponent `x`, at least 0.
    pub fn new(x: f64) -> Self {
        const GREATEST: f64 = 1_048_576.0;
        if (0.0..=GREATEST).contains(&x) && x.fract() == 0.0 {
            Self::Whole(x as u32)
        } else {
            Self::Broken(x)
        }
    }

    /// `base` to this power for `base >= 0`.
    #[inline(always)]
    pub fn power<R: Real>(self, base: R) -> R {
        match self {
            Self::Whole(exponent) => base.whole_power(exponent),
            Self::Broken(exponent) => base.broken_power(exponent),
        }
    }
}

/// Repeated squaring, low bit first: the same chain for every [`Real`].
#[inline(always)]
pub(crate) fn power_by_squaring<R: Real>(base: R, exponent: u32) -> R {
    let mut result = R::constant(1.0);
    let mut square = base;
    let mut rest = exponent;
    while rest > 0 {
        if rest & 1 == 1 {
            result = result * square;
        }
        rest >>= 1;
        if rest > 0 {
            square = square * square;
        }
    }
    result
}

impl Mask for bool {
    const TRUE: Self = true;
    const FALSE: Self = false;
    #[inline(always)]
    fn any(self) -> bool {
        self
    }
    #[inline(always)]
    fn all(self) -> bool {
        self
    }
}

impl Real for f64 {
    type Mask = bool;
    type Across = [Vec3; 2];

    #[inline(always)]
    fn constant(x: f64) -> Self {
        x
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        if self < other { self } else { other }
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        if self > other { self } else { other }
    }
    #[inline(always)]
    fn lt(self, other: Self) -> bool {
        self < other
    }
    #[inline(always)]
    fn le(self, other: Self) -> bool {
        self <= other
    }
    #[inline(always)]
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }
    #[inline]
    fn broken_power(self, exponent: f64) -> Self {
        libm::pow(self, exponent)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_powers_are_products() {
        // 3^5 = 243; 2^0 = 1; 0.5^3 = 0.125
        assert_eq!(Exponent::new(5.0).power(3.0), 243.0);
        assert_eq!(Exponent::new(0.0).power(2.0), 1.0);
        assert_eq!(Exponent::new(3.0).power(0.5), 0.125);
    }

    #[test]
    fn broken_powers_agree_with_the_logarithm() {
        // 4^1.5 = 8
        assert!((Exponent::new(1.5).power(4.0_f64) - 8.0).abs() < 1e-14);
    }
}
