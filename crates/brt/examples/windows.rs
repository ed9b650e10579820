//! Windows of a picture that is far too large to be rendered whole, of a scene that is prepared once:
//! `cargo run --release -p brt --example windows scenes/seed/c.toml`.

use std::error::Error;
use std::path::Path;
use std::time::Instant;

use brt::{CertifiedSettings, Limits, Method, Renderer, Rows, Run, Settings, Window, load, thread_pool};

#[allow(clippy::print_stdout, reason = "an example shows what it did")]
fn main() -> Result<(), Box<dyn Error>> {
    const SIDE: u64 = 1_000_000;
    let scene = std::env::args().nth(1).ok_or("usage: windows SCENE")?;
    let renderer = Renderer::new(load(Path::new(&scene), &Limits::default())?.scene);
    let settings = Settings {
        method: Method::Certified(CertifiedSettings::default()),
        ..Settings::of_virtual([SIDE, SIDE])
    };
    // Windows share the threads, too.
    let pool = thread_pool(0)?;
    let run = Run { pool: Some(&pool), ..Run::default() };
    for i in 0..20 {
        let (x, y) = (SIDE * (2 * i + 1) / 40, SIDE * (39 - 2 * i) / 40);
        let window = Window { x, y, width: 256, height: 256 };
        let mut rows: Vec<Rows> = Vec::new();
        let begin = Instant::now();
        let stats = renderer.render(&renderer.scene().camera, window, &settings, &run, &mut rows)?;
        println!(
            "{window}: began after {:.2} ms, there after {:.1} ms, {} of {} pixels traced",
            1e3 * stats.seconds.prepare,
            1e3 * begin.elapsed().as_secs_f64(),
            stats.pixels.traced,
            stats.pixels.total
        );
    }
    Ok(())
}
