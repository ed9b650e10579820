//! Pictures of a page: as small as they are shown, inside the page.

use brt::PictureSize;
use brt::image::{EncodeError, Picture, heat_color};

use crate::embedded::png_address;
use crate::plot::escape;

/// Greatest side on the page.
const SHOWN: u32 = 256;

/// An `<img>` of a picture with linear values.
pub(super) fn image(picture: &Picture, text: &str) -> Result<String, EncodeError> {
    let color = |pixels: &[usize]| {
        let sum = pixels
            .iter()
            .map(|&i| picture.levels(i))
            .fold([0.0; 3], |a, b| [a[0] + b[0], a[1] + b[1], a[2] + b[2]]);
        sum.map(|level| (level / (255.0 * pixels.len() as f64)) as f32)
    };
    element(picture.size(), color, text)
}

/// An `<img>` of where two pictures differ: the greatest difference of all pixels that share one on the page.
pub(super) fn difference(a: &Picture, b: &Picture, text: &str) -> Result<String, EncodeError> {
    let levels = |i: usize| {
        let (a, b) = (a.levels(i), b.levels(i));
        (0..3).map(|c| (a[c] - b[c]).abs()).fold(0.0, f64::max)
    };
    let color = |pixels: &[usize]| heat_color(pixels.iter().map(|&i| levels(i)).fold(0.0, f64::max));
    element(a.size(), color, text)
}

/// A picture whose pixels are made of one or more of the original's.
fn element(
    size: PictureSize,
    color: impl Fn(&[usize]) -> [f32; 3],
    text: &str,
) -> Result<String, EncodeError> {
    let step = size.width.max(size.height).div_ceil(SHOWN).max(1);
    let shown = PictureSize::new((size.width / step).max(1), (size.height / step).max(1));
    let mut colors = Vec::with_capacity(shown.pixels() as usize);
    let mut pixels = Vec::new();
    for y in 0..shown.height {
        for x in 0..shown.width {
            pixels.clear();
            for row in (y * step..(y + 1) * step).filter(|&row| row < size.height) {
                let columns = (x * step..(x + 1) * step).filter(|&column| column < size.width);
                pixels.extend(columns.map(|column| row as usize * size.width as usize + column as usize));
            }
            colors.push(color(&pixels));
        }
    }
    let address = png_address(&colors, shown)?;
    let [width, height] = [shown.width, shown.height];
    Ok(format!("<img width=\"{width}\" height=\"{height}\" alt=\"{}\" src=\"{address}\">", escape(text)))
}
