//! Colours that show data: numbers of surfaces and of ray histories.

use crate::Transfer;

/// A colour for a number, linear RGB: neighbouring numbers get colours far apart, none is
/// black or grey, and the same number always gets the same colour.
pub fn id_color(id: u64) -> [f32; 3] {
    // The golden ratio spreads any run of numbers evenly round the circle of hues, and
    // neighbours are always more than a third of it apart.
    const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;
    let turns = id.wrapping_mul(GOLDEN) >> 40;
    let hue = 6.0 * turns as f64 / (1_u64 << 24) as f64;
    // Where hues come close again, after 5, 8, 13 or 21 numbers, lightness or saturation differ.
    let value = [1.0, 0.62, 0.8][(id % 3) as usize];
    let saturation = [0.9, 0.55][(id / 3 % 2) as usize];
    [5.0, 3.0, 1.0].map(|shift: f64| {
        let sector = (shift + hue) % 6.0;
        let fall = sector.min(4.0 - sector).clamp(0.0, 1.0);
        Transfer::Srgb.decode(value * (1.0 - saturation * fall)) as f32
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn codes(color: [f32; 3]) -> [i32; 3] {
        let mut codes = [0; 3];
        Transfer::Srgb.quantize_8(&color, &mut codes);
        codes.map(i32::from)
    }

    fn distance(a: u64, b: u64) -> i32 {
        let (a, b) = (codes(id_color(a)), codes(id_color(b)));
        (0..3).map(|i| (a[i] - b[i]).abs()).sum()
    }

    #[test]
    fn near_numbers_are_far_apart_in_colour() {
        for id in (0..2000).chain([u64::from(u32::MAX), u64::MAX - 40]) {
            assert!(distance(id, id + 1) > 120, "{id}");
            for step in 2..=32 {
                assert!(distance(id, id + step) > 20, "{id} + {step}: {}", distance(id, id + step));
            }
        }
    }

    #[test]
    fn no_number_is_black_or_grey() {
        for id in 0..2000 {
            let c = codes(id_color(id));
            assert!(c.iter().max().unwrap() - c.iter().min().unwrap() > 60, "{id}: {c:?}");
        }
    }
}
