//! Proves that a linear colour over a block is within the tolerance of what tracing its samples gives.
//!
//! From: the remainder of the colour's Taylor model, and how steep the transfer function is at the lowest value that the
//! model encloses: the curve is concave, so nowhere above is it steeper.

use brt_geometry::Taylor;
use brt_image::{Rgb, Transfer};

use crate::margins::{ALLOWED_ABOVE, ALLOWED_AT_BLACK, ALLOWED_AT_CUT, RESERVE, STORED_ROUNDINGS};
use crate::settings::CertifiedSettings;

/// The tolerance of a picture.
#[derive(Clone, Debug)]
pub(crate) struct Tolerance {
    /// Of stored values, 1 being white.
    stored: f64,
    transfer: Transfer,
}

/// Below, the sRGB curve is a straight line.
const SRGB_CUT: f64 = 0.003_130_8;

impl Tolerance {
    pub(crate) fn new(settings: &CertifiedSettings, transfer: Transfer) -> Self {
        Self { stored: settings.tolerance * (1.0 - RESERVE) / 255.0, transfer }
    }

    /// The greatest error of a channel in units of what is allowed.
    pub(in crate::methods::certified) fn excess(&self, color: &Rgb<Taylor>) -> f64 {
        let of = |channel: Taylor| {
            let [lo, hi] = channel.range();
            let rounding = STORED_ROUNDINGS * lo.abs().max(hi.abs());
            (channel.e + rounding) / self.allowed(lo)
        };
        let worse = |a: f64, b: f64| if a > b { a } else { b };
        let [r, g, b] = [color.r, color.g, color.b].map(of);
        let greatest = worse(worse(r, g), b);
        if r.is_nan() || g.is_nan() || b.is_nan() { f64::INFINITY } else { greatest }
    }

    /// The error that is allowed of linear values from `least` on.
    ///
    /// A pixel is a mean of samples: that each keeps to this suffices only if it is a concave function of the value.
    /// The inverse of the curve's slope is, but for the corner where the straight part ends; there a chord runs below.
    fn allowed(&self, least: f64) -> f64 {
        match self.transfer {
            Transfer::Linear => self.stored,
            Transfer::Srgb if least <= SRGB_CUT => {
                self.stored
                    * (ALLOWED_AT_BLACK + (ALLOWED_AT_CUT - ALLOWED_AT_BLACK) * least.max(0.0) / SRGB_CUT)
            }
            // 1 / slope of 1.055·x^(1/2.4)
            Transfer::Srgb => self.stored * 2.4 / 1.055 * libm::pow(least, 1.4 / 2.4) * ALLOWED_ABOVE,
        }
    }
}

#[cfg(test)]
mod tests {
    use brt_testkit::Random;

    use super::*;

    fn tolerance(levels: f64, transfer: Transfer) -> Tolerance {
        Tolerance::new(&CertifiedSettings { tolerance: levels }, transfer)
    }

    /// Values at which something happens: black, about the corner of the curve, white, beyond.
    fn value(random: &mut Random) -> f64 {
        match random.below(4) {
            0 => SRGB_CUT * random.between(0.9, 1.1),
            1 => SRGB_CUT * random.unit(),
            2 => random.magnitude(-4.0, 0.0),
            _ => random.between(0.0, 1.2),
        }
    }

    /// A pixel is a mean of samples, of which each is off by as much as is allowed of it.
    #[test]
    fn a_mean_of_samples_that_keep_to_what_is_allowed_is_within_the_tolerance() {
        let mut random = Random::new(7);
        for (transfer, levels) in [(Transfer::Srgb, 1.0), (Transfer::Srgb, 0.1), (Transfer::Linear, 1.0)] {
            let tolerance = tolerance(levels, transfer);
            let mut worst = 0.0_f64;
            for _ in 0..100_000 {
                let count = 1 + random.below(4);
                let (mut right, mut filled) = (0.0, 0.0);
                for _ in 0..count {
                    let least = value(&mut random);
                    let share = 1.0 / f64::from(count);
                    right += share * least;
                    filled += share * (least + tolerance.allowed(least));
                }
                let error = transfer.encode(filled.min(1.0)) - transfer.encode(right.min(1.0));
                worst = worst.max(255.0 * error / levels);
            }
            assert!((0.9..1.0).contains(&worst), "{transfer:?} {levels}: {worst}");
        }
    }

    #[test]
    fn a_colour_is_let_through_up_to_the_tolerance_and_no_further() {
        let tolerance = tolerance(1.0, Transfer::Linear);
        let excess = |e: f64| {
            let channel = Taylor { e, ..Taylor::linear(0.5, 0.1, 0.0) };
            tolerance.excess(&Rgb { r: Taylor::linear(0.2, 0.0, 0.0), g: channel, b: channel })
        };
        assert!(excess(0.99 / 255.0) < 1.0);
        assert!(excess(1.0 / 255.0) > 1.0);
        assert_eq!(excess(f64::NAN), f64::INFINITY);
        assert!(excess(f64::INFINITY) > 1.0);
    }
}
