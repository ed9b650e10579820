//! Pictures in memory: their errors, and how they get into the page.

use brt::image::{DifferenceMeter, heat_color};
use brt::{Comparison, LayerRows, PictureSize, RayHistory, Rows, SampleState, Stats};

use super::PaperError;
use crate::embedded::png_address;

/// A picture with the layers that were asked for; the others are empty.
#[derive(Clone, Debug)]
pub(crate) struct Picture {
    pub(crate) size: [u32; 2],
    /// Linear RGB.
    pub(crate) colors: Vec<[f32; 3]>,
    pub(crate) stats: Stats,
    pub(crate) surface: Vec<u32>,
    pub(crate) history: Vec<RayHistory>,
    pub(crate) state: Vec<SampleState>,
}

impl Picture {
    pub(crate) fn new(size: [u32; 2], stats: Stats, rows: Vec<Rows>) -> Self {
        let (colors, surface, history, state) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let mut picture = Self { size, colors, stats, surface, history, state };
        for part in rows {
            picture.colors.extend(&part.colors);
            for layer in &part.layers {
                match layer {
                    LayerRows::Surface(rows) => picture.surface.extend(rows),
                    LayerRows::History(rows) => picture.history.extend(rows),
                    LayerRows::State(rows) => picture.state.extend(rows),
                    LayerRows::Depth(_) | LayerRows::Normal(_) | LayerRows::Certificates(_) => {}
                }
            }
        }
        picture
    }

    /// Share of traced samples in percent.
    pub(crate) fn traced_percent(&self) -> f64 {
        traced_percent(&self.stats)
    }

    /// Where samples were traced: white.
    pub(crate) fn traced_map(&self) -> Vec<[f32; 3]> {
        let color = |s: &SampleState| if *s == SampleState::Traced { [1.0; 3] } else { [0.0; 3] };
        self.state.iter().map(color).collect()
    }

    /// The picture's side.
    pub(crate) fn width(&self) -> u32 {
        self.size[0]
    }
}

/// Share of traced samples in percent.
pub(crate) fn traced_percent(stats: &Stats) -> f64 {
    100.0 * stats.pixels.traced as f64 / stats.pixels.total as f64
}

/// The paper's pixel values: 8 bits, proportional to light. Paper: P7, P12.
pub(crate) fn levels(color: [f32; 3]) -> [f64; 3] {
    unrounded_levels(color).map(f64::round)
}

/// The same before rounding.
pub(crate) fn unrounded_levels(color: [f32; 3]) -> [f64; 3] {
    color.map(|c| 255.0 * f64::from(c.clamp(0.0, 1.0)))
}

/// Error of 8-bit values.
pub(crate) fn error(picture: &[[f32; 3]], full: &[[f32; 3]]) -> Comparison {
    compare(picture, full, levels)
}

/// Error before values are rounded to 8 bits.
pub(crate) fn unrounded_error(picture: &[[f32; 3]], full: &[[f32; 3]]) -> Comparison {
    compare(picture, full, unrounded_levels)
}

fn compare(a: &[[f32; 3]], b: &[[f32; 3]], levels: fn([f32; 3]) -> [f64; 3]) -> Comparison {
    let mut meter = DifferenceMeter::default();
    for (a, b) in a.iter().zip(b) {
        meter.add_levels(levels(*a), levels(*b));
    }
    meter.comparison()
}

/// The paper's formula written out: the mean of (|r − r₀| + |g − g₀| + |b − b₀|) / 3. Paper: P12.
pub(crate) fn papers_error(picture: &[[f32; 3]], full: &[[f32; 3]]) -> f64 {
    let of_pixel = |(a, b): (&[f32; 3], &[f32; 3])| {
        let ([r, g, b], [r0, g0, b0]) = (levels(*a), levels(*b));
        ((r - r0).abs() + (g - g0).abs() + (b - b0).abs()) / 3.0
    };
    picture.iter().zip(full).map(of_pixel).sum::<f64>() / picture.len().max(1) as f64
}

/// Where two pictures differ, in the colours of `brt compare --heat-map`.
pub(crate) fn difference_map(picture: &[[f32; 3]], full: &[[f32; 3]]) -> Vec<[f32; 3]> {
    let greatest = |(a, b): (&[f32; 3], &[f32; 3])| {
        let (a, b) = (levels(*a), levels(*b));
        (0..3).map(|i| (a[i] - b[i]).abs()).fold(0.0, f64::max)
    };
    picture.iter().zip(full).map(|pair| heat_color(greatest(pair))).collect()
}

/// An `<img>` with the picture inside. `shown` is its width on the page.
pub(crate) fn image_element(
    colors: &[[f32; 3]],
    width: u32,
    shown: u32,
    text: &str,
) -> Result<String, PaperError> {
    let size = PictureSize::new(width, colors.len() as u32 / width);
    let address = png_address(colors, size)?;
    let class = if shown > width { " class=\"magnified\"" } else { "" };
    Ok(format!("<img{class} width=\"{shown}\" alt=\"{text}\" src=\"{address}\">"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_papers_error_is_that_of_compare() {
        let full = [[0.0, 0.5, 1.0], [0.2, 0.2, 0.2]];
        let picture = [[4.0 / 255.0, 0.5, 2.0], [0.2, 8.0 / 255.0, 0.2]];
        // (4 + 0 + 0)/3 and (0 + |8 − 51| + 0)/3, over two pixels.
        assert!((papers_error(&picture, &full) - (4.0 + 43.0) / 6.0).abs() < 1e-9);
        assert!((error(&picture, &full).mean_error - papers_error(&picture, &full)).abs() < 1e-9);
    }

    #[test]
    fn pictures_stand_in_the_page_as_png() {
        let image = image_element(&[[0.5; 3]; 6], 3, 30, "grey").unwrap();
        assert!(image.contains("class=\"magnified\" width=\"30\" alt=\"grey\""));
        // The signature of PNG.
        assert!(image.contains("base64,iVBORw0KGgo"));
    }
}
