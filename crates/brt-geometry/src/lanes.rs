//! Eight numbers side by side, computed by vector instructions where the machine has them.
//!
//! Lanes are plain arrays whose operations are loops of fixed length: inside [`SimdLevel::run`] the compiler has wide
//! registers for them. So each lane computes exactly what scalar `f64` does, at every level.

use std::array::from_fn;
use std::fmt;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};
use std::str::FromStr;

use crate::numbers::{Mask, Real};
use crate::{Ray, vec3};

/// How many lanes there are.
pub const LANES: usize = 8;

/// Eight numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Lanes(pub [f64; LANES]);

/// Eight answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(align(64))]
pub struct LaneMask([u64; LANES]);

/// Which vector instructions are used. The numbers are the same at every level.
///
/// A level that the machine lacks falls back to the next lower one. Only x86 has more than one level: elsewhere all of
/// them are [`Self::Baseline`], for which the compiler takes whatever the target has (NEON on AArch64).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum SimdLevel {
    /// The widest that the machine has: AVX-512, AVX2, or the baseline.
    #[default]
    Widest,
    /// AVX2, also where there is AVX-512.
    Avx2,
    /// Those that every machine of the target has.
    Baseline,
}

impl SimdLevel {
    /// All levels, from the widest to the narrowest.
    pub const ALL: [Self; 3] = [Self::Widest, Self::Avx2, Self::Baseline];

    /// Its name on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Widest => "widest",
            Self::Avx2 => "avx2",
            Self::Baseline => "baseline",
        }
    }

    /// What is used for it on this machine: "AVX-512", "AVX2" or "baseline".
    pub fn instructions(self) -> &'static str {
        dispatch::instructions(self)
    }

    /// Runs a function with these instructions: it and all it calls must be marked `inline(always)` to use them.
    #[inline]
    pub fn run<T>(self, function: impl FnOnce() -> T) -> T {
        dispatch::run(self, function)
    }
}

impl fmt::Display for SimdLevel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl FromStr for SimdLevel {
    type Err = UnknownSimdLevel;

    fn from_str(name: &str) -> Result<Self, UnknownSimdLevel> {
        Self::ALL.into_iter().find(|level| level.name() == name).ok_or(UnknownSimdLevel)
    }
}

/// A text that names no [`SimdLevel`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UnknownSimdLevel;

impl fmt::Display for UnknownSimdLevel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names = SimdLevel::ALL.map(SimdLevel::name);
        write!(f, "expected one of {}", names.join(", "))
    }
}

impl std::error::Error for UnknownSimdLevel {}

/// The only code that knows x86. `--cfg brt_hide_x86` hides it, so that an x86 machine builds and tests what any other
/// architecture gets.
#[cfg(all(any(target_arch = "x86", target_arch = "x86_64"), not(brt_hide_x86)))]
mod dispatch {
    use fearless_simd::{Level, Simd};

    use super::SimdLevel;

    pub(super) fn instructions(level: SimdLevel) -> &'static str {
        let machine = Level::new();
        match level {
            SimdLevel::Widest if machine.as_avx512().is_some() => "AVX-512",
            SimdLevel::Widest | SimdLevel::Avx2 if machine.as_avx2().is_some() => "AVX2",
            _ => "baseline",
        }
    }

    #[inline]
    pub(super) fn run<T>(level: SimdLevel, function: impl FnOnce() -> T) -> T {
        if level == SimdLevel::Baseline {
            return function();
        }
        let machine = Level::new();
        match (machine.as_avx512(), machine.as_avx2()) {
            (Some(avx512), _) if level == SimdLevel::Widest => avx512.vectorize(function),
            (_, Some(avx2)) => avx2.vectorize(function),
            _ => function(),
        }
    }
}

/// Every machine of the target has the same instructions, and the compiler uses them everywhere.
#[cfg(not(all(any(target_arch = "x86", target_arch = "x86_64"), not(brt_hide_x86))))]
mod dispatch {
    use super::SimdLevel;

    pub(super) fn instructions(_: SimdLevel) -> &'static str {
        "baseline"
    }

    #[inline(always)]
    pub(super) fn run<T>(_: SimdLevel, function: impl FnOnce() -> T) -> T {
        function()
    }
}

impl Lanes {
    /// Number by number from `f`.
    #[inline(always)]
    pub fn from_fn(f: impl FnMut(usize) -> f64) -> Self {
        Self(from_fn(f))
    }

    /// Their magnitudes.
    #[inline(always)]
    pub fn abs(self) -> Self {
        Self(from_fn(|i| self.0[i].abs()))
    }

    /// Where are both the same number?
    #[inline(always)]
    pub fn equals(self, other: Self) -> LaneMask {
        LaneMask::from_fn(|i| self.0[i] == other.0[i])
    }
}

impl LaneMask {
    /// Answer by answer from `f`.
    #[inline(always)]
    pub fn from_fn(mut f: impl FnMut(usize) -> bool) -> Self {
        Self(from_fn(|i| if f(i) { !0 } else { 0 }))
    }

    /// The first `count` lanes.
    #[inline(always)]
    pub fn first(count: usize) -> Self {
        Self::from_fn(|i| i < count)
    }

    /// One bit a lane, the lowest for the first.
    #[inline(always)]
    pub fn bits(self) -> u8 {
        (0..LANES).fold(0, |bits, lane| bits | u8::from(self.has(lane)) << lane)
    }

    /// Is this lane's answer yes?
    #[inline(always)]
    pub fn has(self, lane: usize) -> bool {
        self.0[lane] != 0
    }

    /// How many answers are yes.
    #[inline(always)]
    pub fn count(self) -> u64 {
        self.0.iter().map(|lane| lane & 1).sum()
    }

    /// The lanes whose answer is yes.
    #[inline(always)]
    pub fn lanes(self) -> impl Iterator<Item = usize> {
        (0..LANES).filter(move |&lane| self.has(lane))
    }
}

impl Ray<Lanes> {
    /// One of the rays.
    #[inline(always)]
    pub fn lane(&self, i: usize) -> Ray {
        let (o, d) = (self.origin, self.direction);
        Ray::new(vec3(o.x.0[i], o.y.0[i], o.z.0[i]), vec3(d.x.0[i], d.y.0[i], d.z.0[i]))
    }
}

impl Neg for Lanes {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(from_fn(|i| -self.0[i]))
    }
}

impl Add for Lanes {
    type Output = Self;
    #[inline(always)]
    fn add(self, o: Self) -> Self {
        Self(from_fn(|i| self.0[i] + o.0[i]))
    }
}

impl Sub for Lanes {
    type Output = Self;
    #[inline(always)]
    fn sub(self, o: Self) -> Self {
        Self(from_fn(|i| self.0[i] - o.0[i]))
    }
}

impl Mul for Lanes {
    type Output = Self;
    #[inline(always)]
    fn mul(self, o: Self) -> Self {
        Self(from_fn(|i| self.0[i] * o.0[i]))
    }
}

impl Div for Lanes {
    type Output = Self;
    #[inline(always)]
    fn div(self, o: Self) -> Self {
        Self(from_fn(|i| self.0[i] / o.0[i]))
    }
}

impl Real for Lanes {
    type Mask = LaneMask;
    type Across = ();

    #[inline(always)]
    fn constant(x: f64) -> Self {
        Self([x; LANES])
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(from_fn(|i| self.0[i].sqrt()))
    }
    #[inline(always)]
    fn min(self, o: Self) -> Self {
        Self(from_fn(|i| Real::min(self.0[i], o.0[i])))
    }
    #[inline(always)]
    fn max(self, o: Self) -> Self {
        Self(from_fn(|i| Real::max(self.0[i], o.0[i])))
    }
    #[inline(always)]
    fn lt(self, o: Self) -> LaneMask {
        LaneMask::from_fn(|i| self.0[i] < o.0[i])
    }
    #[inline(always)]
    fn le(self, o: Self) -> LaneMask {
        LaneMask::from_fn(|i| self.0[i] <= o.0[i])
    }
    #[inline(always)]
    fn select(mask: LaneMask, yes: Self, no: Self) -> Self {
        Self(from_fn(|i| if mask.has(i) { yes.0[i] } else { no.0[i] }))
    }
    #[inline(always)]
    fn broken_power(self, exponent: f64) -> Self {
        Self(self.0.map(|x| x.broken_power(exponent)))
    }
}

impl Mask for LaneMask {
    const TRUE: Self = Self([!0; LANES]);
    const FALSE: Self = Self([0; LANES]);
    #[inline(always)]
    fn any(self) -> bool {
        self.0.iter().fold(0, |a, b| a | b) != 0
    }
    #[inline(always)]
    fn all(self) -> bool {
        self.0.iter().fold(!0, |a, b| a & b) == !0
    }
}

impl BitAnd for LaneMask {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, o: Self) -> Self {
        Self(from_fn(|i| self.0[i] & o.0[i]))
    }
}

impl BitOr for LaneMask {
    type Output = Self;
    #[inline(always)]
    fn bitor(self, o: Self) -> Self {
        Self(from_fn(|i| self.0[i] | o.0[i]))
    }
}

impl Not for LaneMask {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        Self(from_fn(|i| !self.0[i]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Levels fall back to lower ones, never to higher ones; without code for x86 all are the baseline.
    #[test]
    fn levels_use_no_wider_instructions_than_they_name() {
        let [widest, avx2, baseline] = SimdLevel::ALL.map(SimdLevel::instructions);
        assert_eq!(baseline, "baseline");
        assert!(["AVX2", "baseline"].contains(&avx2));
        assert!(widest == avx2 || widest == "AVX-512");
        if cfg!(brt_hide_x86) {
            assert_eq!([widest, avx2], ["baseline"; 2]);
        }
    }
}
