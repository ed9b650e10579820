//! A seeded generator for loops over thousands of cases, where shrinking is not worth its time.

use brt_geometry::{Vec3, vec3};

/// SplitMix64 (Steele, Lea, Flood 2014): the same numbers on every machine.
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// The generator with this seed.
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ self.0 >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ mixed >> 31
    }

    /// In [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// In [lo, hi).
    pub fn between(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * self.unit()
    }

    /// A whole number in 0..count.
    pub fn below(&mut self, count: u32) -> u32 {
        (self.bits() % u64::from(count)) as u32
    }

    /// True once in `count` times.
    pub fn one_in(&mut self, count: u32) -> bool {
        self.below(count) == 0
    }

    /// A power of ten with an exponent in [lo, hi).
    pub fn magnitude(&mut self, lo: f64, hi: f64) -> f64 {
        libm::pow(10.0, self.between(lo, hi))
    }

    /// One of some values.
    pub fn pick<T: Copy>(&mut self, values: &[T]) -> T {
        values[self.below(values.len() as u32) as usize]
    }

    /// A point in the cube of this half side around the origin.
    pub fn point(&mut self, half: f64) -> Vec3 {
        vec3(self.between(-half, half), self.between(-half, half), self.between(-half, half))
    }

    /// A unit vector; once in four times along an axis, with zeros of both signs.
    pub fn direction(&mut self) -> Vec3 {
        if self.one_in(4) {
            let axis = self.below(3) as usize;
            let mut unit = vec3(self.zero(), self.zero(), self.zero());
            unit[axis] = if self.one_in(2) { 1.0 } else { -1.0 };
            return unit;
        }
        loop {
            let p = self.point(1.0);
            if let Some(unit) = p.try_normalize()
                && p.length() <= 1.0
            {
                return unit;
            }
        }
    }

    /// 0 or −0.
    pub fn zero(&mut self) -> f64 {
        if self.one_in(2) { 0.0 } else { -0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_seed_gives_one_sequence_and_another_seed_another() {
        let sequence = |seed| {
            let mut random = Random::new(seed);
            [random.bits(), random.bits(), random.bits()]
        };
        // The first value of SplitMix64 for seed 0, from its authors' code.
        assert_eq!(sequence(0)[0], 0xe220_a839_7b1d_cdaf);
        assert_eq!(sequence(7), sequence(7));
        assert_ne!(sequence(7), sequence(8));
    }
}
