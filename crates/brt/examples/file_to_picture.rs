//! Any file that can be read, to a picture beside a layer that shows what was proven:
//! `cargo run --release -p brt --example file_to_picture scenes/seed/a.toml a.png`.

use std::error::Error;
use std::path::Path;

use brt::{
    CertifiedSettings, CheckedPixels, Limits, Method, Output, PictureLayer, Run, Settings, load,
    render_to_files,
};

#[allow(clippy::print_stdout, clippy::print_stderr, reason = "an example shows what it did")]
fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [scene, picture] = &arguments[..] else { return Err("usage: file_to_picture SCENE OUT.png".into()) };
    // Models get a camera and lights; `given` tells what the file has itself.
    let loaded = load(Path::new(scene), &Limits::default())?;
    for warning in &loaded.report.diagnostics {
        eprintln!("warning: {}", warning.message);
    }
    let settings = Settings {
        method: Method::Certified(CertifiedSettings::default()),
        checked: CheckedPixels::All,
        ..Settings::new(loaded.scene.size.unwrap_or([1024, 1024]))
    };
    let output = Output { layers: vec![PictureLayer::State], ..Output::to_file(Path::new(picture))? };
    let rendered = render_to_files(&loaded.scene, &settings, &Run::default(), &output)?;
    let pixels = rendered.stats.pixels;
    println!("{} of {} pixels traced", pixels.traced, pixels.total);
    if let Some(found) = rendered.verification {
        println!(
            "greatest error {:.3} levels, {} above {}",
            found.comparison.max_error, found.above, found.limit
        );
    }
    Ok(())
}
