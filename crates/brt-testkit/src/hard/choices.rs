//! Bytes read as choices: what a fuzzer mutates, a property test shrinks, and a seeded generator fills.

use brt_geometry::{Vec3, vec3};

/// Choices from bytes. When they run out every further choice is the first, the simplest.
#[derive(Clone, Debug)]
pub struct Choices<'a>(std::slice::Iter<'a, u8>);

impl<'a> Choices<'a> {
    /// The choices that these bytes stand for.
    pub fn new(bytes: &'a [u8]) -> Self {
        Self(bytes.iter())
    }

    fn byte(&mut self) -> u8 {
        self.0.next().copied().unwrap_or(0)
    }

    /// A whole number in 0..count, count up to 256.
    pub fn below(&mut self, count: usize) -> usize {
        usize::from(self.byte()) % count
    }

    /// True once in `count` times; false when bytes have run out.
    pub fn one_in(&mut self, count: usize) -> bool {
        self.below(count) + 1 == count
    }

    /// One of some values.
    pub fn pick<T: Copy>(&mut self, values: &[T]) -> T {
        values[self.below(values.len())]
    }

    /// In [0, 1).
    fn unit(&mut self) -> f64 {
        f64::from(u16::from_le_bytes([self.byte(), self.byte()])) / 65536.0
    }

    /// In [lo, hi).
    pub fn between(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * self.unit()
    }

    /// A power of ten with an exponent in [lo, hi): `10^lo` when bytes have run out.
    pub fn magnitude(&mut self, lo: f64, hi: f64) -> f64 {
        libm::pow(10.0, self.between(lo, hi))
    }

    /// In [-half, half]; twice in three times one of nine even steps, so that things touch and lie in one plane.
    pub fn coordinate(&mut self, half: f64) -> f64 {
        const STEPS: [f64; 9] = [0.0, 0.25, -0.25, 0.5, -0.5, 0.75, -0.75, 1.0, -1.0];
        if self.one_in(3) { self.between(-half, half) } else { half * self.pick(&STEPS) }
    }

    /// A point in the cube of this half side around the origin.
    pub fn point(&mut self, half: f64) -> Vec3 {
        vec3(self.coordinate(half), self.coordinate(half), self.coordinate(half))
    }

    /// A unit vector, every other time along an axis.
    pub fn direction(&mut self) -> Vec3 {
        const AXES: [Vec3; 6] = [
            vec3(0.0, 1.0, 0.0),
            vec3(1.0, 0.0, 0.0),
            vec3(0.0, 0.0, 1.0),
            vec3(0.0, -1.0, 0.0),
            vec3(-1.0, 0.0, 0.0),
            vec3(0.0, 0.0, -1.0),
        ];
        if self.one_in(2) { self.point(1.0).try_normalize().unwrap_or(AXES[0]) } else { self.pick(&AXES) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_bytes_every_choice_is_the_first() {
        let mut choices = Choices::new(&[]);
        assert_eq!(choices.pick(&[7, 8, 9]), 7);
        assert!(!choices.one_in(2));
        assert_eq!(choices.point(3.0), Vec3::ZERO);
        assert_eq!(choices.direction(), vec3(0.0, 1.0, 0.0));
        assert_eq!(choices.magnitude(-2.0, 5.0), 0.01);
    }

    #[test]
    fn choices_stay_within_their_ranges() {
        let bytes: Vec<u8> = (0..=u8::MAX).flat_map(|b| [b, b.wrapping_mul(89)]).collect();
        let mut choices = Choices::new(&bytes);
        for _ in 0..60 {
            assert!(choices.below(7) < 7);
            assert!((-2.0..5.0).contains(&choices.between(-2.0, 5.0)));
            assert!(choices.coordinate(3.0).abs() <= 3.0);
            assert!((choices.direction().length() - 1.0).abs() < 1e-12);
        }
    }
}
