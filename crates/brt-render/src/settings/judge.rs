//! How brightness is judged. Paper: P5, reading 2.
//!
//! The three thresholds are types of their own: 16 levels² of variance is a standard deviation of 4 levels, so they must not be
//! compared "at equal Δ".

/// Greatest variance of the four brightness values, in levels². The paper's wording.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct VarianceDelta(pub f64);

/// Greatest standard deviation of the four brightness values, in levels. What the paper's figures speak for.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct DeviationDelta(pub f64);

/// Greatest difference of a brightness value from the mean of the four, in levels: as PSRT and the first BRT judged.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct DifferenceDelta(pub f64);

/// How brightness is judged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Judge {
    /// By the variance.
    Variance(VarianceDelta),
    /// By the standard deviation.
    Deviation(DeviationDelta),
    /// By the difference from the mean.
    Difference(DifferenceDelta),
}
