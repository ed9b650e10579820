//! Measures of the difference between two pictures.
//!
//! Paper: P12

use crate::picture::STEPS_PER_LEVEL;

/// How far two pictures differ, in levels of 255 of the encoded values.
///
/// A value that is not a number differs infinitely from anything but another such value.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Comparison {
    /// Pixels compared.
    pub pixels: u64,
    /// The paper's error: the mean over all pixels of (|Δr| + |Δg| + |Δb|) / 3; 0 if there are
    /// none. Where there is alpha, it is a fourth channel.
    ///
    /// Paper: P12
    pub mean_error: f64,
    /// The greatest difference of any channel of any pixel.
    pub max_error: f64,
    /// Pixels of which some channel differs by more than 1 level.
    pub over_1: u64,
    /// Pixels of which some channel differs by more than 2 levels.
    pub over_2: u64,
    /// Pixels of which some channel differs by more than 10 levels.
    pub over_10: u64,
}

/// Gathers a [`Comparison`] pixel by pixel.
///
/// Sums over pictures of 8 or 16 bits are exact, so they do not depend on the order.
#[derive(Clone, Copy, Debug, Default)]
pub struct DifferenceMeter {
    pixels: u64,
    /// Of all pixels.
    channels: u64,
    /// Of the absolute differences of all channels, in steps.
    sum: f64,
    /// In steps.
    max: f64,
    over_1: u64,
    over_2: u64,
    over_10: u64,
}

impl DifferenceMeter {
    /// Takes a pixel of each picture, in levels; its channels are colours or colours and alpha.
    pub fn add_levels<const N: usize>(&mut self, a: [f64; N], b: [f64; N]) {
        self.add_difference(difference(a, b).map(|levels| levels * STEPS_PER_LEVEL));
    }

    /// Takes a pixel of each picture, in steps.
    pub(crate) fn add_steps<const N: usize>(&mut self, a: [f64; N], b: [f64; N]) {
        self.add_difference(difference(a, b));
    }

    fn add_difference<const N: usize>(&mut self, steps: [f64; N]) {
        let greatest = steps.into_iter().fold(0.0, f64::max);
        self.pixels += 1;
        self.channels += N as u64;
        self.sum += steps.into_iter().sum::<f64>();
        self.max = self.max.max(greatest);
        self.over_1 += u64::from(greatest > STEPS_PER_LEVEL);
        self.over_2 += u64::from(greatest > 2.0 * STEPS_PER_LEVEL);
        self.over_10 += u64::from(greatest > 10.0 * STEPS_PER_LEVEL);
    }

    /// Adds what another meter has gathered.
    pub fn merge(&mut self, other: &Self) {
        self.pixels += other.pixels;
        self.channels += other.channels;
        self.sum += other.sum;
        self.max = self.max.max(other.max);
        self.over_1 += other.over_1;
        self.over_2 += other.over_2;
        self.over_10 += other.over_10;
    }

    /// The numbers.
    pub fn comparison(&self) -> Comparison {
        let samples = self.channels.max(1) as f64;
        Comparison {
            pixels: self.pixels,
            mean_error: self.sum / samples / STEPS_PER_LEVEL,
            max_error: self.max / STEPS_PER_LEVEL,
            over_1: self.over_1,
            over_2: self.over_2,
            over_10: self.over_10,
        }
    }
}

/// The absolute difference of each channel.
pub(crate) fn difference<const N: usize>(a: [f64; N], b: [f64; N]) -> [f64; N] {
    std::array::from_fn(|i| channel_difference(a[i], b[i]))
}

fn channel_difference(a: f64, b: f64) -> f64 {
    let difference = (a - b).abs();
    if !difference.is_nan() {
        difference
    } else if a == b || (a.is_nan() && b.is_nan()) {
        // Equal infinities, or nothing on both sides.
        0.0
    } else {
        f64::INFINITY
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_agree_with_hand_computation() {
        let mut meter = DifferenceMeter::default();
        meter.add_levels([10.0, 20.0, 30.0], [10.0, 20.0, 30.0]);
        meter.add_levels([10.0, 20.0, 30.0], [11.0, 20.0, 29.0]);
        meter.add_levels([10.0, 20.0, 30.0], [10.0, 22.0, 30.0]);
        meter.add_levels([0.0, 0.0, 0.0], [10.5, 1.0, 0.0]);
        let c = meter.comparison();
        // Sums: 0 + 2 + 2 + 11.5 = 15.5; over 4 pixels of 3 channels: 15.5 / 12.
        assert!((c.mean_error - 15.5 / 12.0).abs() <= f64::EPSILON);
        assert_eq!(c.max_error, 10.5);
        // Exactly 1 is not over 1, exactly 2 not over 2.
        assert_eq!((c.pixels, c.over_1, c.over_2, c.over_10), (4, 2, 1, 1));
    }

    #[test]
    fn merging_is_adding() {
        let (mut a, mut b, mut both) = <(DifferenceMeter, DifferenceMeter, DifferenceMeter)>::default();
        a.add_steps([257.0; 3], [0.0; 3]);
        b.add_steps([900.0; 3], [0.0; 3]);
        both.add_steps([900.0; 3], [0.0; 3]);
        both.add_steps([257.0; 3], [0.0; 3]);
        a.merge(&b);
        assert_eq!(a.comparison(), both.comparison());
    }

    #[test]
    fn not_a_number_is_infinitely_wrong_but_equal_to_itself() {
        assert_eq!(channel_difference(f64::NAN, 1.0), f64::INFINITY);
        assert_eq!(channel_difference(f64::NAN, f64::NAN), 0.0);
        assert_eq!(channel_difference(f64::INFINITY, f64::INFINITY), 0.0);
        assert_eq!(channel_difference(f64::INFINITY, f64::NEG_INFINITY), f64::INFINITY);
    }
}
