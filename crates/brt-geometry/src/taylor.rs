//! First-order Taylor models: one value over a whole block of samples.
//!
//! A model `c + u·U + v·V ± e` encloses a function of (U, V) ∈ [−1, 1]². Each operation adds its second-order terms
//! and its own rounding to `e`, so that the model encloses what the same expression computes in scalar `f64` for any
//! sample of the block (Makino, Berz 2003; affine arithmetic: Comba, Stolfi 1993). Unknown results are `e = ∞` or
//! NaN; comparisons with them are neither certainly true nor certainly false.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::margins::MODEL_ROUNDING;
use crate::numbers::{Mask, Real, power_by_squaring};
use crate::{Trilean, Vec3};

/// A first-order model over a block.
#[derive(Clone, Copy, Debug)]
pub struct Taylor {
    /// Value in the middle of the block.
    pub c: f64,
    /// Change per unit of U.
    pub u: f64,
    /// Change per unit of V.
    pub v: f64,
    /// Greatest distance of the function from the linear part, ≥ 0.
    pub e: f64,
}

impl Taylor {
    /// The model `c + u·U + v·V`, exact.
    pub fn linear(c: f64, u: f64, v: f64) -> Self {
        Self { c, u, v, e: 0.0 }
    }

    /// Lower and upper bound over the block; infinite where nothing is known.
    #[inline]
    pub fn range(self) -> [f64; 2] {
        let radius = (self.u.abs() + self.v.abs() + self.e) * (1.0 + 2.0 * MODEL_ROUNDING);
        let lo = self.c - radius;
        let hi = self.c + radius;
        if lo.is_nan() || hi.is_nan() {
            return [f64::NEG_INFINITY, f64::INFINITY];
        }
        [lo - MODEL_ROUNDING * lo.abs(), hi + MODEL_ROUNDING * hi.abs()]
    }

    fn unknown() -> Self {
        Self { c: 0.0, u: 0.0, v: 0.0, e: f64::INFINITY }
    }

    fn enclosing([lo, hi]: [f64; 2]) -> Self {
        let c = 0.5 * lo + 0.5 * hi;
        if !c.is_finite() {
            return Self::unknown();
        }
        Self { c, u: 0.0, v: 0.0, e: (hi - c).max(c - lo) * (1.0 + MODEL_ROUNDING) }
    }

    fn magnitude(self) -> f64 {
        self.c.abs() + self.u.abs() + self.v.abs()
    }

    #[inline(always)]
    fn is_constant(self) -> bool {
        self.u == 0.0 && self.v == 0.0 && self.e == 0.0
    }

    /// `self · factor`, at less cost than the product of two models.
    #[inline(always)]
    fn scaled(self, factor: f64) -> Self {
        let scaled =
            Self { c: self.c * factor, u: self.u * factor, v: self.v * factor, e: self.e * factor.abs() };
        scaled.rounded(2.0 * (scaled.magnitude() + scaled.e))
    }

    /// With error `e` plus the rounding of an operation whose terms sum up to `terms` in magnitude.
    #[inline(always)]
    fn rounded(self, terms: f64) -> Self {
        Self { e: (self.e + MODEL_ROUNDING * terms) * (1.0 + MODEL_ROUNDING) + f64::MIN_POSITIVE, ..self }
    }

    /// `slope·self + offset ± error`, for a function bounded by that line over the model's range.
    fn through_line(self, slope: f64, offset: f64, error: f64) -> Self {
        let terms = slope.abs() * (self.magnitude() + self.e) + offset.abs() + error;
        Self {
            c: slope * self.c + offset,
            u: slope * self.u,
            v: slope * self.v,
            e: slope.abs() * self.e + error,
        }
        .rounded(8.0 * terms)
    }

    /// Reciprocal by the secant through the ends of the range.
    fn reciprocal(self) -> Self {
        let [lo, hi] = self.range();
        if lo < 0.0 && hi < 0.0 {
            return -(-self).reciprocal();
        }
        let slope = -1.0 / (lo * hi);
        if !(lo > 0.0 && slope.is_finite()) {
            return Self::unknown();
        }
        // 1/x − slope·x is 1/lo + 1/hi at both ends and 2/√(lo·hi) at its least, also for a slope that underflows.
        let top = if slope.is_normal() { -slope * (lo + hi) } else { 1.0 / lo + 1.0 / hi - slope * hi };
        let bottom = 2.0 * (-slope).sqrt();
        self.through_line(slope, 0.5 * (top + bottom), 0.5 * (top - bottom).max(0.0))
    }
}

impl Vec3<Taylor> {
    /// The scalar product with a constant vector, at less cost than that of two models.
    #[inline]
    pub fn along(&self, normal: Vec3) -> Taylor {
        let sum =
            |of: fn(&Taylor) -> f64| normal.x * of(&self.x) + normal.y * of(&self.y) + normal.z * of(&self.z);
        let sizes = normal.x.abs() * (self.x.magnitude() + self.x.e)
            + normal.y.abs() * (self.y.magnitude() + self.y.e)
            + normal.z.abs() * (self.z.magnitude() + self.z.e);
        let errors = normal.x.abs() * self.x.e + normal.y.abs() * self.y.e + normal.z.abs() * self.z.e;
        Taylor { c: sum(|x| x.c), u: sum(|x| x.u), v: sum(|x| x.v), e: errors }.rounded(8.0 * sizes)
    }
}

impl Neg for Taylor {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { c: -self.c, u: -self.u, v: -self.v, e: self.e }
    }
}

impl Add for Taylor {
    type Output = Self;
    #[inline(always)]
    fn add(self, o: Self) -> Self {
        let sum = Self { c: self.c + o.c, u: self.u + o.u, v: self.v + o.v, e: self.e + o.e };
        // Rounding is relative to the results; results too small for that are exact.
        Self { e: sum.e + 1.5 * MODEL_ROUNDING * (sum.magnitude() + sum.e), ..sum }
    }
}

impl Sub for Taylor {
    type Output = Self;
    #[inline(always)]
    fn sub(self, o: Self) -> Self {
        self + -o
    }
}

impl Mul for Taylor {
    type Output = Self;
    #[inline(always)]
    fn mul(self, o: Self) -> Self {
        if o.is_constant() {
            return self.scaled(o.c);
        }
        if self.is_constant() {
            return o.scaled(self.c);
        }
        // U² and V² lie in [0, 1], UV in [−1, 1].
        let (uu, vv) = (self.u * o.u, self.v * o.v);
        let uv = (self.u * o.v).abs() + (self.v * o.u).abs();
        let second = 0.5 * (uu.abs() + vv.abs()) + uv;
        let (a, b) = (self.magnitude(), o.magnitude());
        Self {
            c: self.c * o.c + 0.5 * (uu + vv),
            u: self.c * o.u + self.u * o.c,
            v: self.c * o.v + self.v * o.c,
            e: second + self.e * (b + o.e) + o.e * a,
        }
        .rounded(4.0 * (a + self.e) * (b + o.e))
    }
}

impl Div for Taylor {
    type Output = Self;
    #[expect(clippy::suspicious_arithmetic_impl, reason = "a quotient is a product with the reciprocal")]
    fn div(self, o: Self) -> Self {
        self * o.reciprocal()
    }
}

impl Real for Taylor {
    type Mask = Trilean;
    type Across = ();

    #[inline(always)]
    fn constant(x: f64) -> Self {
        Self { c: x, u: 0.0, v: 0.0, e: 0.0 }
    }

    /// Bounds the root over the part of the range that is not negative.
    fn sqrt(self) -> Self {
        let [lo, hi] = self.range();
        let (a, b) = (lo.max(0.0).sqrt(), hi.max(0.0).sqrt());
        if b == 0.0 {
            return Self::constant(0.0);
        }
        let slope = 1.0 / (a + b);
        if !slope.is_finite() || !b.is_finite() {
            return Self::unknown();
        }
        // √x − slope·x is slope·a·b at both ends and 1/(4·slope) at its greatest.
        let (ends, top) = (slope * a * b, 0.25 * (a + b));
        self.through_line(slope, 0.5 * (ends + top), 0.5 * (top - ends).max(0.0))
    }

    /// Bounds the function as one: tighter than the quotient by the root.
    fn inverse_sqrt(self) -> Self {
        let [lo, hi] = self.range();
        let (a, b) = (1.0 / lo.sqrt(), 1.0 / hi.sqrt());
        let per_sum = 1.0 / (a + b);
        let slope = -a * b * a * b * per_sum;
        if !(lo > 0.0 && slope.is_normal()) {
            return Self::constant(1.0) / self.sqrt();
        }
        // x^-½ − slope·x is this at both ends; its least, 3/2·(2a²b²/(a + b))^⅓, is half more than a mean of h, h
        // and (a + b)/2 with h = 2ab/(a + b): no less than their harmonic mean.
        let top = a + b * b * per_sum;
        let harmonic = 2.0 * a * b * per_sum;
        let bottom = 4.5 * a * b / (a + b + harmonic);
        self.through_line(slope, 0.5 * (top + bottom), 0.5 * (top - bottom).max(0.0))
    }

    /// Bounds the power as one: tighter than a chain of products.
    fn whole_power(self, exponent: u32) -> Self {
        if exponent <= 1 {
            return power_by_squaring(self, exponent);
        }
        let [lo, hi] = self.range().map(|x| x.max(0.0));
        let middle = 0.5 * lo + 0.5 * hi;
        let [least, greatest] = [lo, hi].map(|x| power_by_squaring(x, exponent));
        let rise = power_by_squaring(middle, exponent - 1);
        let slope = if hi > lo { (greatest - least) / (hi - lo) } else { 0.0 };
        let steepness = f64::from(exponent) * rise;
        // The power runs below its chord and above its tangent; each product of the chain rounds once.
        let top = greatest - slope * hi;
        let tangent = |x: f64| middle * rise + steepness * (x - middle) - slope * x;
        let bottom = tangent(lo).min(tangent(hi));
        let rounding = 8.0 * MODEL_ROUNDING * f64::from(exponent) * greatest;
        let line = self.through_line(slope, 0.5 * (top + bottom), 0.5 * (top - bottom).max(0.0) + rounding);
        if line.e.is_finite() { line } else { Self::unknown() }
    }

    fn min(self, other: Self) -> Self {
        -(-self).max(-other)
    }

    fn max(self, other: Self) -> Self {
        let less = self.lt(other);
        if less.all() {
            return other;
        }
        if !less.any() {
            return self;
        }
        let ([a, b], [c, d]) = (self.range(), other.range());
        Self::enclosing([a.max(c), b.max(d)])
    }

    #[inline]
    fn lt(self, other: Self) -> Trilean {
        let [lo, hi] = (other - self).range();
        Trilean { possible: hi > 0.0, certain: lo > 0.0 }
    }

    #[inline]
    fn le(self, other: Self) -> Trilean {
        let [lo, hi] = (other - self).range();
        Trilean { possible: hi >= 0.0, certain: lo >= 0.0 }
    }

    fn select(mask: Trilean, yes: Self, no: Self) -> Self {
        if mask.certain {
            return yes;
        }
        if !mask.possible {
            return no;
        }
        let ([a, b], [c, d]) = (yes.range(), no.range());
        Self::enclosing([a.min(c), b.max(d)])
    }

    fn broken_power(self, exponent: f64) -> Self {
        let [lo, hi] = self.range();
        let (a, b) = (libm::pow(lo.max(0.0), exponent), libm::pow(hi.max(0.0), exponent));
        // libm's pow is monotone but for its last place.
        Self::enclosing([a * (1.0 - 4.0 * MODEL_ROUNDING), b * (1.0 + 4.0 * MODEL_ROUNDING)])
    }
}
