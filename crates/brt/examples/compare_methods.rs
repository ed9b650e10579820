//! The methods of 1986 and 1987 and ours, against exhaustive ray tracing:
//! `cargo run --release -p brt --example compare_methods scenes/seed/c.toml`.

use std::error::Error;
use std::path::Path;

use brt::{
    BorderSettings, CertifiedSettings, Limits, Method, PixelSelectedSettings, Renderer, Rows, Run, Settings,
    load,
};

#[allow(clippy::print_stdout, reason = "an example shows what it did")]
fn main() -> Result<(), Box<dyn Error>> {
    let scene = std::env::args().nth(1).ok_or("usage: compare_methods SCENE")?;
    let renderer = Renderer::new(load(Path::new(&scene), &Limits::default())?.scene);
    let draw = |method| -> Result<_, Box<dyn Error>> {
        let settings = Settings { method, ..Settings::new([512, 512]) };
        let mut rows: Vec<Rows> = Vec::new();
        let stats = renderer.render(
            &renderer.scene().camera,
            settings.whole()?,
            &settings,
            &Run::default(),
            &mut rows,
        )?;
        Ok((rows.into_iter().flat_map(|rows| rows.colors).collect::<Vec<_>>(), stats))
    };
    let (right, _) = draw(Method::Full)?;
    for method in [
        Method::PixelSelected(PixelSelectedSettings::default()),
        Method::Border(BorderSettings::default()),
        Method::Certified(CertifiedSettings::default()),
    ] {
        let (colors, stats) = draw(method)?;
        let error =
            |a: &[f32; 3], b: &[f32; 3]| (0..3).map(|c| 255.0 * (a[c] - b[c]).abs()).fold(0.0, f32::max);
        let errors = colors.iter().zip(&right).map(|(a, b)| error(a, b));
        println!(
            "{:14} {:4.1} % traced, greatest error {:6.2} levels, {} pixels above 1",
            method.name(),
            100.0 * stats.pixels.traced as f64 / stats.pixels.total as f64,
            errors.clone().fold(0.0, f32::max),
            errors.filter(|error| *error > 1.0).count()
        );
    }
    Ok(())
}
