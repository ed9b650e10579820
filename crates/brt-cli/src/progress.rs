//! A progress bar on a terminal.

use brt::Progress;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Rows that are finished. Disappears when dropped.
pub(crate) struct Bar(ProgressBar);

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
}

impl Drop for Bar {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
