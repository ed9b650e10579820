//! Proves that a linear colour over a block is within the tolerance of what tracing its samples gives.
//!
//! From: the remainder of the colour's Taylor model, and how steep the transfer function is at the lowest value that the
//! model encloses: the curve is concave, so nowhere above is it steeper.

use brt_geometry::Taylor;
use brt_image::{Rgb, Transfer};

use crate::methods::CertifiedSettings;

/// The tolerance of a picture.
#[derive(Clone, Debug)]
pub(crate) struct Tolerance {
    /// Of stored values, 1 being white.
    stored: f64,
    transfer: Transfer,
}

/// Below, the sRGB curve is a straight line.
const SRGB_CUT: f64 = 0.003_130_8;

/// Left for the rounding of weights and sums that make a pixel of its samples.
const RESERVE: f64 = 1e-3;

impl Tolerance {
    pub(crate) fn new(settings: &CertifiedSettings, transfer: Transfer) -> Self {
        Self { stored: settings.tolerance * (1.0 - RESERVE) / 255.0, transfer }
    }

    /// The greatest error of a channel in units of what is allowed.
    pub(in crate::methods::certified) fn excess(&self, color: &Rgb<Taylor>) -> f64 {
        let of = |channel: Taylor| {
            let [lo, hi] = channel.range();
            // Both the filled and the traced value are rounded to `f32`, the filled one in three steps.
            let rounding = 8.0 * f64::from(f32::EPSILON) * lo.abs().max(hi.abs());
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
        const AT_BLACK: f64 = 0.031;
        const AT_CUT: f64 = 0.077;
        match self.transfer {
            Transfer::Linear => self.stored,
            Transfer::Srgb if least <= SRGB_CUT => {
                self.stored * (AT_BLACK + (AT_CUT - AT_BLACK) * least.max(0.0) / SRGB_CUT)
            }
            // 1 / slope of 1.055·x^(1/2.4)
            Transfer::Srgb => self.stored * 2.4 / 1.055 * libm::pow(least, 1.4 / 2.4) * 0.97,
        }
    }
}
