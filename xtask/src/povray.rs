//! Do our pictures of the seed scenes agree with POV-Ray's?

use std::path::Path;

use anyhow::{Context, Result, ensure};
use brt_image::{PictureLimits, read_picture};

use crate::scenes::{SEED, open, render_whole, square};

/// Greatest mean error in levels, and greatest share of pixels off by more than 2 levels.
const LIMITS: (f64, f64) = (0.4, 0.005);

pub(crate) fn run(pictures: &Path) -> Result<()> {
    for (name, letter) in SEED.into_iter().zip(["a", "b", "c"]) {
        let path = pictures.join(format!("povray-{letter}-512-linear.ppm"));
        let theirs = read_picture(&path, PictureLimits::default())
            .with_context(|| format!("cannot read {}", path.display()))?;
        let (ours, ..) = render_whole(&open(name)?, &square(512, &[]))?;
        let (mut sum, mut over) = (0.0, 0_u32);
        for (i, color) in ours.iter().enumerate() {
            // As written to 8 bits with --linear.
            let level = |c: f32| f64::from((c.clamp(0.0, 1.0) * 255.0).round());
            let reference = theirs.levels(i);
            let error: [f64; 3] = std::array::from_fn(|c| (level(color[c]) - reference[c]).abs());
            sum += error.iter().sum::<f64>() / 3.0;
            over += u32::from(error.iter().any(|&e| e > 2.0));
        }
        let (mean, share) = (sum / ours.len() as f64, f64::from(over) / ours.len() as f64);
        println!(
            "{name}: mean error {mean:.3} levels, {:.4} % of the pixels off by more than 2",
            100.0 * share
        );
        ensure!(mean <= LIMITS.0 && share <= LIMITS.1, "{name} differs from POV-Ray's picture");
    }
    Ok(())
}
