//! Time that work takes, summed over the threads that do it.

use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Instant;

/// Sums up time. While a thread waits for others it may do other work, so a clock around all of it would lie.
#[derive(Debug, Default)]
pub struct WorkClock {
    nanoseconds: AtomicU64,
}

impl WorkClock {
    /// Does some work, which must not wait for other threads, and adds its time.
    pub fn time<R>(&self, work: impl FnOnce() -> R) -> R {
        let begin = Instant::now();
        let result = work();
        self.nanoseconds.fetch_add(begin.elapsed().as_nanos() as u64, Ordering::Relaxed);
        result
    }

    /// The sum so far.
    pub fn seconds(&self) -> f64 {
        self.nanoseconds.load(Ordering::Relaxed) as f64 * 1e-9
    }
}
