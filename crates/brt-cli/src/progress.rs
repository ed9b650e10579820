//! How far a rendering is: a bar on a terminal, and the place of a panic.

use brt::{Progress, Window};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::output;

/// Rows that are finished. Disappears when dropped.
pub(crate) struct Bar(ProgressBar);

/// Hears of panics where no bar is seen.
pub(crate) struct NoBar;

impl Bar {
    /// A bar of so many rows.
    pub(crate) fn new(rows: u32) -> Self {
        let bar =
            ProgressBar::with_draw_target(Some(u64::from(rows)), ProgressDrawTarget::stderr_with_hz(10));
        let template = "{bar:40} {percent:>3} % · {elapsed} · {eta} left";
        if let Ok(style) = ProgressStyle::with_template(template) {
            bar.set_style(style);
        }
        Self(bar)
    }
}

impl Progress for Bar {
    fn advance(&self, rows: u32) {
        self.0.inc(u64::from(rows));
    }

    fn panicked_in(&self, pixels: Window) {
        note_panic(pixels);
    }
}

impl Progress for NoBar {
    fn advance(&self, _rows: u32) {}

    fn panicked_in(&self, pixels: Window) {
        note_panic(pixels);
    }
}

fn note_panic(Window { x, y, width, height }: Window) {
    let place = format!("{width}×{height} pixels from {x},{y} on");
    output::note(&format!("It happened in the {place}; `--pixel {x},{y}` renders no others."));
}

impl Drop for Bar {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
