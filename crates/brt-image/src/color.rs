//! Colours: linear RGB without unit, where 1 is white on the screen.

use std::ops::{Add, Mul};

/// A colour in linear RGB; channels are not clamped.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rgb<T = f64> {
    /// Red.
    pub r: T,
    /// Green.
    pub g: T,
    /// Blue.
    pub b: T,
}

/// The colour (r, g, b).
#[inline(always)]
pub const fn rgb<T>(r: T, g: T, b: T) -> Rgb<T> {
    Rgb { r, g, b }
}

impl Rgb<f64> {
    /// No light.
    pub const BLACK: Self = rgb(0.0, 0.0, 0.0);
    /// White.
    pub const WHITE: Self = rgb(1.0, 1.0, 1.0);

    /// Are all channels finite?
    pub fn is_finite(self) -> bool {
        self.r.is_finite() && self.g.is_finite() && self.b.is_finite()
    }

    /// Channels as 32-bit floats.
    #[inline(always)]
    pub fn to_f32(self) -> [f32; 3] {
        [self.r as f32, self.g as f32, self.b as f32]
    }
}

impl<T: Add<Output = T>> Add for Rgb<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        rgb(self.r + other.r, self.g + other.g, self.b + other.b)
    }
}

impl<T: Mul<Output = T> + Copy> Mul<T> for Rgb<T> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: T) -> Self {
        rgb(self.r * factor, self.g * factor, self.b * factor)
    }
}

impl<T: Mul<Output = T>> Mul for Rgb<T> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        rgb(self.r * other.r, self.g * other.g, self.b * other.b)
    }
}

impl From<[f64; 3]> for Rgb<f64> {
    fn from([r, g, b]: [f64; 3]) -> Self {
        rgb(r, g, b)
    }
}

impl From<Rgb<f64>> for [f64; 3] {
    fn from(c: Rgb<f64>) -> Self {
        [c.r, c.g, c.b]
    }
}
