//! The colours of [`heat_map`], looked up by error.

use std::sync::OnceLock;

use brt_image::{PictureLimits, decode_picture, heat_map};

/// Steps of the table: those of 16 bits, 257 to a level.
const STEPS: usize = 1 << 16;

/// Linear RGB of an error in levels: the colour that a heat map of two pictures gives it.
pub(crate) fn heat_color(levels: f64) -> [f32; 3] {
    static TABLE: OnceLock<Vec<[f32; 3]>> = OnceLock::new();
    let table = TABLE.get_or_init(table);
    let step = (levels * 257.0).round() as usize;
    table.get(step.min(STEPS - 1)).copied().unwrap_or_default()
}

/// The heat map of a ramp of all errors over black, so that there is one definition of the colours.
fn table() -> Vec<[f32; 3]> {
    let grey = |code: fn(u16) -> u16| {
        let mut bytes = format!("P5 {STEPS} 1 65535\n").into_bytes();
        bytes.extend((0..=u16::MAX).flat_map(|i| code(i).to_be_bytes()));
        decode_picture(&bytes, PictureLimits::default()).expect("it was made here")
    };
    heat_map(&grey(|_| 0), &grey(|code| code)).expect("both are of one size").into_pixels()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_is_black_and_larger_errors_are_lighter() {
        assert_eq!(heat_color(0.0), [0.0; 3]);
        let green = |levels| heat_color(levels)[1];
        assert!(green(0.5) < green(1.0) && green(1.0) < green(10.0) && green(10.0) < green(255.0));
        assert_eq!(heat_color(1e9), heat_color(255.0));
        assert_eq!(heat_color(f64::INFINITY), heat_color(255.0));
    }
}
