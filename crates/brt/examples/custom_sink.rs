//! Rows as they are finished, to something of one's own, here a histogram of brightness:
//! `cargo run --release -p brt --example custom_sink scenes/seed/b.toml`.

use std::error::Error;
use std::path::Path;

use brt::{CertifiedSettings, Limits, Method, Rows, Run, Settings, Sink, SinkError, Transfer, load, render};

/// Counts pixels by brightness; holds no picture.
#[derive(Default)]
struct Histogram {
    bins: [u64; 16],
}

impl Sink for Histogram {
    /// What is promised of colours is promised of them as they are stored: here as they are.
    fn transfer(&self) -> Transfer {
        Transfer::Linear
    }

    fn take(&mut self, rows: &Rows) -> Result<(), SinkError> {
        for [r, g, b] in &rows.colors {
            let brightness = (r + g + b) / 3.0;
            self.bins[(16.0 * brightness.clamp(0.0, 0.999)) as usize] += 1;
        }
        Ok(())
    }
}

#[allow(clippy::print_stdout, reason = "an example shows what it did")]
fn main() -> Result<(), Box<dyn Error>> {
    let scene = std::env::args().nth(1).ok_or("usage: custom_sink SCENE")?;
    let scene = load(Path::new(&scene), &Limits::default())?.scene;
    let settings =
        Settings { method: Method::Certified(CertifiedSettings::default()), ..Settings::new([512, 512]) };
    let mut histogram = Histogram::default();
    render(&scene, &settings, &Run::default(), &mut histogram)?;
    let most = histogram.bins.into_iter().max().unwrap_or(1).max(1);
    for (bin, count) in histogram.bins.iter().enumerate() {
        println!("{:4.2} {:7} {}", bin as f64 / 16.0, count, "#".repeat((60 * count / most) as usize));
    }
    Ok(())
}
