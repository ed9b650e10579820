//! Compares two pictures, and draws where they differ.

use thiserror::Error;

use crate::metrics::{Comparison, DifferenceMeter, difference};
use crate::picture::{Picture, STEPS_PER_LEVEL};
use crate::{Image, PictureSize, Transfer};

/// Pictures of different size cannot be compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("a picture of {reference} cannot be compared with one of {test}")]
pub struct SizeMismatch {
    /// Size of the first picture.
    pub reference: PictureSize,
    /// Size of the second.
    pub test: PictureSize,
}

/// Measures the difference of two pictures in levels of their own encodings. If one of them has an alpha, it is a fourth
/// channel; the other is wholly covered then.
///
/// # Errors
/// If their sizes differ.
pub fn compare(reference: &Picture, test: &Picture) -> Result<Comparison, SizeMismatch> {
    let pixels = pixels_in_common(reference, test)?;
    let mut meter = DifferenceMeter::default();
    for i in 0..pixels {
        if reference.has_alpha() || test.has_alpha() {
            meter.add_steps(all_steps(reference, i), all_steps(test, i));
        } else {
            meter.add_steps(reference.steps(i), test.steps(i));
        }
    }
    Ok(meter.comparison())
}

/// Draws the greatest channel difference of each pixel: black where the pictures are equal,
/// then violet, red, orange and pale yellow, ever lighter.
///
/// Scale: from 0 to 1 level the first 30 % of the ramp, a violet well visible on black at 1;
/// from there to 255 levels the rest, logarithmically (16 levels stand in the middle of it).
///
/// # Errors
/// If their sizes differ.
pub fn heat_map(reference: &Picture, test: &Picture) -> Result<Image, SizeMismatch> {
    let mut image = Image::black(reference.size());
    let width = reference.size().width as usize;
    for (row, pixels) in heat_rows(reference, test)?.zip(image.pixels_mut().chunks_mut(width)) {
        pixels.copy_from_slice(&row);
    }
    Ok(image)
}

/// The rows of [`heat_map`], from the top, for those who need only one at a time.
///
/// # Errors
/// If the sizes of the pictures differ.
pub fn heat_rows<'p>(
    reference: &'p Picture,
    test: &'p Picture,
) -> Result<impl Iterator<Item = Vec<[f32; 3]>> + use<'p>, SizeMismatch> {
    pixels_in_common(reference, test)?;
    let color = |i| {
        let differences = difference(all_steps(reference, i), all_steps(test, i));
        heat_color(differences.into_iter().fold(0.0, f64::max) / STEPS_PER_LEVEL)
    };
    let PictureSize { width, height } = reference.size();
    let row = move |y: usize| (y * width as usize..(y + 1) * width as usize).map(color).collect();
    Ok((0..height as usize).map(row))
}

/// Steps of colours and alpha.
fn all_steps(picture: &Picture, i: usize) -> [f64; 4] {
    let [r, g, b] = picture.steps(i);
    [r, g, b, picture.alpha_steps(i)]
}

fn pixels_in_common(reference: &Picture, test: &Picture) -> Result<usize, SizeMismatch> {
    if reference.size() == test.size() {
        Ok(reference.size().pixels() as usize)
    } else {
        Err(SizeMismatch { reference: reference.size(), test: test.size() })
    }
}

/// sRGB stops at equal distances, of increasing lightness.
const HEAT: [[f64; 3]; 6] = [
    [0.0, 0.0, 0.0],
    [92.0, 26.0, 138.0],
    [170.0, 51.0, 125.0],
    [231.0, 82.0, 98.0],
    [254.0, 159.0, 109.0],
    [252.0, 253.0, 191.0],
];

/// Linear RGB that a heat map shows for a difference in levels: black for none, lighter for more.
pub fn heat_color(levels: f64) -> [f32; 3] {
    let position =
        if levels <= 1.0 { 0.3 * levels } else { 0.3 + 0.7 * libm::log2(levels) / libm::log2(255.0) };
    let at = position.min(1.0) * (HEAT.len() - 1) as f64;
    let stop = (at as usize).min(HEAT.len() - 2);
    let part = at - stop as f64;
    let (from, to) = (HEAT[stop], HEAT[stop + 1]);
    [0, 1, 2].map(|i| Transfer::Srgb.decode((from[i] + part * (to[i] - from[i])) / 255.0) as f32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::{PixelKind, Samples};

    fn eight(pixels: Vec<[u8; 3]>) -> Picture {
        let size = PictureSize::new(pixels.len() as u32, 1);
        Picture::new(size, PixelKind::Rgb, Samples::Eight(pixels.into_flattened()))
    }

    #[test]
    fn depths_compare_exactly() {
        let size = PictureSize::new(2, 1);
        let a = eight(vec![[0, 100, 255], [7, 8, 9]]);
        let codes = [0_u16, 100 * 257, 65535, 8 * 257, 8 * 257, 9 * 257 + 258];
        let bytes = codes.into_iter().flat_map(u16::to_be_bytes).collect();
        let b = Picture::new(size, PixelKind::Rgb, Samples::Sixteen(bytes));
        let c = compare(&a, &b).unwrap();
        // Steps: 0, 0, 0 and 257, 0, 258; one pixel is one step over one level.
        assert_eq!(c.max_error, 258.0 / 257.0);
        assert_eq!((c.over_1, c.over_2, c.over_10), (1, 0, 0));
        assert!((c.mean_error - 515.0 / 257.0 / 6.0).abs() <= f64::EPSILON);

        let f = Picture::new(size, PixelKind::Rgb, Samples::Float(vec![0.0, 0.0, 1.0, 2.0, 0.0, 0.0]));
        assert_eq!(f.levels(1), [510.0, 0.0, 0.0]);
    }

    #[test]
    fn sizes_must_agree() {
        let error = compare(&eight(vec![[0; 3]]), &eight(vec![[0; 3]; 2])).unwrap_err();
        assert_eq!(error.to_string(), "a picture of 1×1 cannot be compared with one of 2×1");
    }

    #[test]
    fn heat_grows_lighter_and_one_level_is_visible() {
        let a = eight((0..=255).map(|_| [0; 3]).collect());
        let b = eight((0..=255).map(|v| [0, v, 0]).collect());
        let map = heat_map(&a, &b).unwrap();
        let luminance =
            |[r, g, b]: [f32; 3]| 0.2126 * f64::from(r) + 0.7152 * f64::from(g) + 0.0722 * f64::from(b);
        let light: Vec<f64> = map.pixels().iter().map(|&p| luminance(p)).collect();
        assert_eq!(map.pixels()[0], [0.0; 3]);
        assert!(light.windows(2).all(|pair| pair[0] < pair[1]));
        let mut codes = [0; 3];
        Transfer::Srgb.quantize_8(&map.pixels()[1], &mut codes);
        assert!(codes.iter().any(|&c| c > 100), "{codes:?}");
    }
}
