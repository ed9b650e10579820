//! May the samples between four traced ones be interpolated? Paper: P5, P6, reading 2.
//!
//! Brightness is the mean of the clamped linear RGB in levels of 255.

use crate::settings::{DeviationDelta, DifferenceDelta, Judge, VarianceDelta};

impl Judge {
    /// Are four colours (linear RGB) even enough to interpolate between them?
    pub(super) fn accepts(&self, colors: &[[f32; 3]; 4]) -> bool {
        let values = colors.map(|c| brightness(&c));
        let mean = 0.25 * (values[0] + values[1] + values[2] + values[3]);
        match *self {
            Self::Variance(VarianceDelta(delta)) => variance(&values, mean) <= delta,
            Self::Deviation(DeviationDelta(delta)) => variance(&values, mean) <= delta * delta,
            Self::Difference(DifferenceDelta(delta)) => values.iter().all(|v| (v - mean).abs() <= delta),
        }
    }
}

/// Mean of the clamped linear RGB, in levels of 255.
pub(super) fn brightness(color: &[f32; 3]) -> f64 {
    let level = |c: f32| f64::from(c.clamp(0.0, 1.0));
    (level(color[0]) + level(color[1]) + level(color[2])) * 85.0
}

/// Variance of the brightness that the four values are a sample of, so with n − 1 = 3 degrees of freedom.
fn variance(values: &[f64; 4], mean: f64) -> f64 {
    let square = |v: f64| (v - mean) * (v - mean);
    (square(values[0]) + square(values[1]) + square(values[2]) + square(values[3])) / 3.0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grey(level: f32) -> [f32; 3] {
        [level / 255.0; 3]
    }

    #[test]
    fn the_three_judgements_by_hand() {
        // 0, 0, 6, 6: mean 3, squares 4 · 9 = 36, variance 36/3 = 12, deviation 3.464, greatest difference 3
        let colors = [grey(0.0), grey(0.0), grey(6.0), grey(6.0)];
        assert!(Judge::Variance(VarianceDelta(12.01)).accepts(&colors));
        assert!(!Judge::Variance(VarianceDelta(11.99)).accepts(&colors));
        assert!(Judge::Deviation(DeviationDelta(3.47)).accepts(&colors));
        assert!(!Judge::Deviation(DeviationDelta(3.46)).accepts(&colors));
        assert!(Judge::Difference(DifferenceDelta(3.01)).accepts(&colors));
        assert!(!Judge::Difference(DifferenceDelta(2.99)).accepts(&colors));
    }

    #[test]
    fn light_beyond_white_does_not_count() {
        assert_eq!(brightness(&[2.0, -1.0, 1.0]), 170.0);
    }
}
