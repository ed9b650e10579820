//! Transfer functions: linear light to the values stored in a picture file, and back.
//!
//! Every value is made by pure Rust arithmetic (`libm`), so that the same picture is written on
//! every machine.

mod quantize;

/// The rule by which linear light becomes stored values.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Transfer {
    /// The piecewise curve of IEC 61966-2-1, what screens and viewers expect.
    #[default]
    Srgb,
    /// The identity.
    Linear,
}

/// Below this linear value the sRGB curve is a straight line.
const SRGB_CUT: f64 = 0.003_130_8;
const SRGB_SLOPE: f64 = 12.92;
/// The encoded value at which the straight part ends.
const SRGB_ENCODED_CUT: f64 = 0.040_45;

impl Transfer {
    /// The stored value in \[0, 1\] of a linear value, which is clamped to \[0, 1\] first.
    ///
    /// Not a number becomes 0.
    #[doc(alias = "gamma")]
    pub fn encode(self, linear: f64) -> f64 {
        let c = clamped(linear);
        match self {
            Self::Linear => c,
            Self::Srgb if c <= SRGB_CUT => SRGB_SLOPE * c,
            Self::Srgb => 1.055 * libm::pow(c, 1.0 / 2.4) - 0.055,
        }
    }

    /// The linear value in \[0, 1\] of a stored value, which is clamped to \[0, 1\] first.
    ///
    /// Not a number becomes 0.
    pub fn decode(self, stored: f64) -> f64 {
        let e = clamped(stored);
        match self {
            Self::Linear => e,
            Self::Srgb if e <= SRGB_ENCODED_CUT => e / SRGB_SLOPE,
            Self::Srgb => libm::pow((e + 0.055) / 1.055, 2.4),
        }
    }

    /// Writes `round(255 * encode(c))` of each linear value to `codes`.
    ///
    /// # Panics
    /// If the slices differ in length.
    pub fn quantize_8(self, linear: &[f32], codes: &mut [u8]) {
        assert_eq!(linear.len(), codes.len(), "one code for each value");
        match self {
            Self::Linear => quantize::linear_8(linear, codes),
            Self::Srgb => quantize::srgb_8(linear, codes),
        }
    }

    /// Writes `round(65535 * encode(c))` of each linear value to `codes`.
    ///
    /// # Panics
    /// If the slices differ in length.
    pub fn quantize_16(self, linear: &[f32], codes: &mut [u16]) {
        assert_eq!(linear.len(), codes.len(), "one code for each value");
        match self {
            Self::Linear => quantize::linear_16(linear, codes),
            Self::Srgb => quantize::srgb_16(linear, codes),
        }
    }
}

/// The value clamped to \[0, 1\]; not a number becomes 0.
fn clamped(value: f64) -> f64 {
    if value > 0.0 { value.min(1.0) } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOTH: [Transfer; 2] = [Transfer::Srgb, Transfer::Linear];

    #[test]
    fn ends_are_fixed_and_nothing_leaves_the_unit_interval() {
        for transfer in BOTH {
            assert_eq!(transfer.encode(0.0), 0.0);
            assert_eq!(transfer.decode(0.0), 0.0);
            assert!((transfer.encode(1.0) - 1.0).abs() <= f64::EPSILON);
            assert!((transfer.decode(1.0) - 1.0).abs() <= f64::EPSILON);
            assert_eq!(transfer.encode(-3.0), 0.0);
            assert_eq!(transfer.encode(f64::INFINITY), transfer.encode(1.0));
            assert_eq!(transfer.encode(f64::NAN), 0.0);
            assert_eq!(transfer.decode(f64::NAN), 0.0);
        }
    }

    #[test]
    fn middle_grey_of_srgb_is_code_188() {
        // 1.055 * 0.5^(1/2.4) - 0.055 = 0.735357; times 255 = 187.516.
        assert!((Transfer::Srgb.encode(0.5) - 0.735_356_98).abs() < 5e-9);
        let mut code = [0];
        Transfer::Srgb.quantize_8(&[0.5], &mut code);
        assert_eq!(code, [188]);
    }

    #[test]
    fn every_16_bit_code_survives_decoding_and_quantising() {
        let codes: Vec<u16> = (0..=u16::MAX).collect();
        for transfer in BOTH {
            let linear: Vec<f32> =
                codes.iter().map(|&k| transfer.decode(f64::from(k) / 65535.0) as f32).collect();
            let mut back = vec![0; codes.len()];
            transfer.quantize_16(&linear, &mut back);
            assert_eq!(back, codes);
        }
    }
}
