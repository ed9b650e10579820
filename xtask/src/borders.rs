//! How much of a picture is border?

use anyhow::Result;
use brt_render::{Layer, LayerRows};

use crate::scenes::{SEED, layer, open, render_whole, square};

pub(crate) fn run(size: u32, names: &[String]) -> Result<()> {
    let names = if names.is_empty() { SEED.map(String::from).to_vec() } else { names.to_vec() };
    for name in &names {
        let (_, rows, stats) = render_whole(&open(name)?, &square(size, &[Layer::History]))?;
        let histories = layer(&rows, 0, |l| if let LayerRows::History(v) = l { Some(v) } else { None });
        let pixels = histories.len() as f64;
        let per_pixel = |count: u64| count as f64 / pixels;
        println!(
            "{name}: {:.3} rays per pixel (mirror {:.3}, shadow {:.3}), border share {:.2} %",
            per_pixel(stats.rays.total()),
            per_pixel(stats.rays.mirror),
            per_pixel(stats.rays.shadow),
            100.0 * borders(&histories, size as usize) as f64 / pixels,
        );
    }
    Ok(())
}

/// Pixels whose value differs from that of one of their four neighbours.
fn borders<T: PartialEq>(values: &[T], width: usize) -> usize {
    let differs = |i: &usize| {
        let (x, here) = (i % width, &values[*i]);
        let left = x > 0 && values[i - 1] != *here;
        let right = x + 1 < width && values[i + 1] != *here;
        let above = *i >= width && values[i - width] != *here;
        let below = i + width < values.len() && values[i + width] != *here;
        left || right || above || below
    };
    (0..values.len()).filter(differs).count()
}
