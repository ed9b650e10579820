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
    /// `self` to the power `exponent` for `self >= 0`, `exponent >= 0`.
    ///
    /// Whole exponents up to 2²⁰ are a fixed chain of multiplications ([`power_by_squaring`]).
    fn pow(self, exponent: f64) -> Self;

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

/// `base` to the power `exponent` by repeated squaring, low bit first: the same chain for every [`Real`].
#[inline]
pub fn power_by_squaring<R: Real>(base: R, exponent: u32) -> R {
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

/// The whole exponent that [`power_by_squaring`] serves, if `exponent` is one.
#[inline]
pub(crate) fn whole_exponent(exponent: f64) -> Option<u32> {
    const GREATEST: f64 = 1_048_576.0;
    ((0.0..=GREATEST).contains(&exponent) && exponent.fract() == 0.0).then_some(exponent as u32)
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
    fn pow(self, exponent: f64) -> Self {
        match whole_exponent(exponent) {
            Some(n) => power_by_squaring(self, n),
            None => libm::pow(self, exponent),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_powers_are_products() {
        // 3^5 = 243; 2^0 = 1; 0.5^3 = 0.125
        assert_eq!(3.0_f64.pow(5.0), 243.0);
        assert_eq!(2.0_f64.pow(0.0), 1.0);
        assert_eq!(0.5_f64.pow(3.0), 0.125);
    }

    #[test]
    fn broken_powers_agree_with_the_logarithm() {
        // 4^1.5 = 8
        assert!((4.0_f64.pow(1.5) - 8.0).abs() < 1e-14);
    }
}
