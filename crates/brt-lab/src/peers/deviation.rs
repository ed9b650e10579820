//! How far a picture is from another that it should be equal to.

use brt::Transfer;
use brt::image::{Picture, SizeMismatch, compare};

use super::findings::percent_over_2;

/// In levels of 255, over all pixels and channels.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Deviation {
    /// Of linear values.
    pub(super) linear: Amount,
    /// Of the same as sRGB, which is what is seen.
    pub(super) srgb: Amount,
    /// Share of the pixels of which a channel differs by more than 2 levels of linear values.
    pub(super) percent_over_2: f64,
}

/// Of differences.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Amount {
    /// Mean of what they are without sign.
    pub(super) mean: f64,
    /// Square root of the mean of their squares.
    pub(super) rms: f64,
}

impl Deviation {
    /// Of pictures with linear values.
    pub(super) fn between(reference: &Picture, picture: &Picture) -> Result<Self, SizeMismatch> {
        let percent_over_2 = percent_over_2(&compare(reference, picture)?);
        let (mut linear, mut srgb) = (Sums::default(), Sums::default());
        for i in 0..reference.size().pixels() as usize {
            let (a, b) = (reference.levels(i), picture.levels(i));
            for (a, b) in a.into_iter().zip(b) {
                linear.add(a - b);
                // Most values are equal and need no power.
                srgb.add(if a == b { 0.0 } else { as_srgb(a) - as_srgb(b) });
            }
        }
        Ok(Self { linear: linear.amount(), srgb: srgb.amount(), percent_over_2 })
    }
}

fn as_srgb(level: f64) -> f64 {
    255.0 * Transfer::Srgb.encode(level / 255.0)
}

#[derive(Default)]
struct Sums {
    count: u64,
    sum: f64,
    squares: f64,
}

impl Sums {
    fn add(&mut self, difference: f64) {
        self.count += 1;
        self.sum += difference.abs();
        self.squares += difference * difference;
    }

    fn amount(&self) -> Amount {
        let count = self.count.max(1) as f64;
        Amount { mean: self.sum / count, rms: (self.squares / count).sqrt() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use brt::image::{PictureLimits, decode_picture};

    fn picture(levels: [u8; 6]) -> Picture {
        let file = [b"P6 2 1 255\n".as_slice(), &levels].concat();
        decode_picture(&file, PictureLimits::default()).unwrap()
    }

    #[test]
    fn numbers_agree_with_hand_computation() {
        let (a, b) = (picture([0, 0, 0, 255, 10, 20]), picture([0, 0, 1, 255, 10, 17]));
        let Deviation { linear, srgb, percent_over_2 } = Deviation::between(&a, &b).unwrap();
        assert!(
            (linear.mean - 4.0 / 6.0).abs() < 1e-12 && (linear.rms - (10.0_f64 / 6.0).sqrt()).abs() < 1e-12
        );
        assert_eq!(percent_over_2, 50.0);
        // 1 of 255 is nearly on the straight part of sRGB, whose slope is 12.92.
        assert!(srgb.mean > 2.0 && srgb.rms > srgb.mean);
        assert_eq!(Deviation::between(&a, &a), Ok(Deviation::default()));
    }
}
