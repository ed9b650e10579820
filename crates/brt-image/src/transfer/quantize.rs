//! Linear light to integer codes, exactly `round(E(c) * max)`, without a power per value.
//!
//! The sRGB codes are found by *thresholds*: threshold k is the smallest `f32` whose code is at
//! least k, found once with the formula itself. A small table leads near the code, exact
//! comparisons decide.

use std::sync::LazyLock;

use super::Transfer;

/// `round(255 * c)`. The product and the sum are exact in f64, so this is the exact rounding;
/// the cast turns not-a-number into 0 and clamps.
pub(crate) fn linear_8(linear: &[f32], codes: &mut [u8]) {
    for (code, &c) in codes.iter_mut().zip(linear) {
        *code = (f64::from(c) * 255.0 + 0.5) as u8;
    }
}

/// `round(65535 * c)`, exact as above.
pub(crate) fn linear_16(linear: &[f32], codes: &mut [u16]) {
    for (code, &c) in codes.iter_mut().zip(linear) {
        *code = (f64::from(c) * 65535.0 + 0.5) as u16;
    }
}

/// Adding 2^23 to a small positive float rounds it to an integer in its lowest bits, with no
/// conversion instruction in the way of vectors.
const ROUNDING: f32 = 8_388_608.0;

/// Cells per unit. Thresholds of 8-bit sRGB are at least 1/(255 * 12.92) apart, more than
/// 1/4096: no cell holds two.
const CELLS: f32 = 4096.0;
/// A power of two above the last cell, so that masked indices need no bounds check.
const CELL_SLOTS: usize = 8192;

/// The cell of a value in \[0, 1\]; it never decreases when the value grows.
#[inline(always)]
fn cell(c: f32) -> usize {
    (c * CELLS + ROUNDING).to_bits() as usize & (CELL_SLOTS - 1)
}

/// For each cell, how many thresholds lie in lower cells, and the one in the cell if any: the
/// code is `first_code + (c >= threshold)`.
struct Grid8 {
    first_code: [u8; CELL_SLOTS],
    threshold: [f32; CELL_SLOTS],
}

static GRID_8: LazyLock<Box<Grid8>> = LazyLock::new(|| {
    let mut grid = Box::new(Grid8 { first_code: [255; CELL_SLOTS], threshold: [f32::INFINITY; CELL_SLOTS] });
    let mut next_cell = 0;
    for (below, &threshold) in srgb_thresholds(255)[1..].iter().enumerate() {
        let cell = cell(threshold);
        grid.first_code[next_cell..=cell].fill(below as u8);
        grid.threshold[cell] = threshold;
        next_cell = cell + 1;
    }
    grid
});

/// The 8-bit sRGB codes of linear values.
pub(crate) fn srgb_8(linear: &[f32], codes: &mut [u8]) {
    let grid = &**GRID_8;
    for (code, &c) in codes.iter_mut().zip(linear) {
        let c = clamped(c);
        let cell = cell(c);
        *code = grid.first_code[cell].wrapping_add(u8::from(c >= grid.threshold[cell]));
    }
}

/// Pieces per octave of the chord approximation; with 256 its error is 0.03 codes of 16 bits.
const PIECE_BITS: u32 = 8;
/// The octaves from 2^-9 to 1 hold the curved part of the sRGB curve.
const OCTAVES: u32 = 9;
const PIECE_SHIFT: u32 = 23 - PIECE_BITS;
/// Bits of 2^-9.
const FIRST_PIECE: u32 = (127 - OCTAVES) << PIECE_BITS;
const PIECES: usize = (OCTAVES << PIECE_BITS) as usize + 1;

/// A continuous piecewise linear approximation of the 16-bit code, and the exact thresholds.
struct Chords16 {
    /// For each piece: code = intercept + slope * c.
    chord: [(f32, f32); PIECES],
    /// Index k: the smallest value with code at least k; one more at the end, never reached.
    threshold: Vec<f32>,
}

static CHORDS_16: LazyLock<Box<Chords16>> = LazyLock::new(|| {
    let mut threshold = srgb_thresholds(65535);
    threshold.push(f32::INFINITY);
    let mut table = Box::new(Chords16 { chord: [(0.0, 0.0); PIECES], threshold });
    for (piece, chord) in table.chord.iter_mut().enumerate() {
        let start = |p: usize| f32::from_bits((FIRST_PIECE + p as u32) << PIECE_SHIFT);
        let (x0, x1) = (f64::from(start(piece)), f64::from(start(piece + 1)));
        let y0 = 65535.0 * Transfer::Srgb.encode(x0);
        let y1 = 65535.0 * Transfer::Srgb.encode(x1);
        let slope = (y1 - y0) / (x1 - x0);
        *chord = ((y0 - slope * x0) as f32, slope as f32);
    }
    table
});

/// The 16-bit sRGB codes of linear values.
pub(crate) fn srgb_16(linear: &[f32], codes: &mut [u16]) {
    let table = &**CHORDS_16;
    for (code, &c) in codes.iter_mut().zip(linear) {
        let c = clamped(c);
        // Below 2^-9 the first piece serves: the curve is its straight line there.
        let piece = (c.to_bits() >> PIECE_SHIFT).saturating_sub(FIRST_PIECE) as usize;
        let (intercept, slope) = table.chord[piece.min(PIECES - 1)];
        let approximate = intercept + slope * c;
        let rounding = approximate + ROUNDING;
        let guess = (rounding.to_bits() & 0xffff) as usize;
        // The approximation is wrong by less than 0.1. Most values are farther from a boundary
        // than that, and the large table stays out of the cache's way.
        *code = if (approximate - (rounding - ROUNDING)).abs() < 0.4 {
            guess as u16
        } else {
            let up = usize::from(c >= table.threshold[guess + 1]);
            let down = usize::from(c < table.threshold[guess]);
            (guess + up).wrapping_sub(down) as u16
        };
    }
}

/// The value clamped to \[0, 1\]; not a number becomes 0.
#[inline(always)]
fn clamped(c: f32) -> f32 {
    if c > 0.0 { c.min(1.0) } else { 0.0 }
}

/// Index k: the smallest `f32` whose code by the formula is at least k; index 0 holds 0.
fn srgb_thresholds(max: u32) -> Vec<f32> {
    (0..=max).map(|code| if code == 0 { 0.0 } else { srgb_threshold(code, max) }).collect()
}

fn srgb_threshold(code: u32, max: u32) -> f32 {
    let boundary = (f64::from(code) - 0.5) / f64::from(max);
    let mut c = Transfer::Srgb.decode(boundary) as f32;
    // The inverse lands within a few floats of the boundary; walk to it by the formula.
    while srgb_code(c, max) >= code {
        c = c.next_down();
    }
    while srgb_code(c, max) < code {
        c = c.next_up();
    }
    c
}

/// The definition: `round(max * E(c))`.
fn srgb_code(c: f32, max: u32) -> u32 {
    (Transfer::Srgb.encode(f64::from(c)) * f64::from(max) + 0.5) as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The values around each threshold of `max`, and ugly ones.
    fn trying_values(max: u32) -> Vec<f32> {
        let ugly = [0.0, -0.0, -1.0, 1.0, 2.0, 1e-40, f32::NAN, f32::INFINITY, f32::NEG_INFINITY];
        let mut values = ugly.to_vec();
        for t in srgb_thresholds(max) {
            let (down, up) = (t.next_down(), t.next_up());
            values.extend([down.next_down(), down, t, up, up.next_up()]);
        }
        for pair in srgb_thresholds(max).windows(2) {
            values.extend([0.05, 0.1, 0.2, 0.5, 0.8, 0.9].map(|p| pair[0] + p * (pair[1] - pair[0])));
        }
        values.extend((0..200_000).map(|i| i as f32 / 200_000.0));
        values
    }

    #[test]
    fn srgb_8_agrees_with_the_formula_around_every_threshold() {
        let values = trying_values(255);
        let mut codes = vec![0; values.len()];
        srgb_8(&values, &mut codes);
        for (&c, &code) in values.iter().zip(&codes) {
            assert_eq!(u32::from(code), srgb_code(c, 255), "{c}");
        }
    }

    #[test]
    fn srgb_16_agrees_with_the_formula_around_every_threshold() {
        let values = trying_values(65535);
        let mut codes = vec![0; values.len()];
        srgb_16(&values, &mut codes);
        for (&c, &code) in values.iter().zip(&codes) {
            assert_eq!(u32::from(code), srgb_code(c, 65535), "{c}");
        }
    }

    #[test]
    fn thresholds_increase_and_cover_every_code() {
        for max in [255, 65535] {
            let thresholds = srgb_thresholds(max);
            assert!(thresholds.windows(2).all(|pair| pair[0] < pair[1]));
            // Index 0 is no threshold: code 0 has no start.
            let gap = thresholds[1..].windows(2).map(|p| p[1] - p[0]).fold(1.0, f32::min);
            assert!(max != 255 || gap > 1.0 / CELLS);
        }
    }

    #[test]
    fn linear_codes_change_at_the_exact_halves() {
        for code in 1..=255_u32 {
            // The smallest f32 c with 255 c >= code - 1/2, decided in exact integers.
            let mut c = ((f64::from(code) - 0.5) / 255.0) as f32;
            let reaches = |c: f32| f64::from(c) * 510.0 >= f64::from(2 * code - 1);
            while reaches(c) {
                c = c.next_down();
            }
            let mut got = [0; 2];
            linear_8(&[c, c.next_up()], &mut got);
            assert_eq!(got.map(u32::from), [code - 1, code]);
        }
        let mut got = [9; 4];
        linear_16(&[f32::NAN, -1.0, 7.0, 0.5], &mut got);
        assert_eq!(got, [0, 0, 65535, 32768]);
    }
}
