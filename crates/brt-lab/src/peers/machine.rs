//! Where and when it was measured.

use std::fs;
use std::thread::available_parallelism;
use std::time::{SystemTime, UNIX_EPOCH};

/// The processor, as far as the system tells.
pub(super) fn processor() -> String {
    let model = fs::read_to_string("/proc/cpuinfo").ok().and_then(|text| model_name(&text));
    let model = model.unwrap_or_else(|| std::env::consts::ARCH.to_owned());
    let count = available_parallelism().map_or(1, std::num::NonZero::get);
    let s = if count == 1 { "" } else { "s" };
    format!("{model}, {count} processor{s}, {}", std::env::consts::OS)
}

/// How many programs wanted to run in the last minute, in the middle.
pub(super) fn load() -> Option<f64> {
    fs::read_to_string("/proc/loadavg").ok()?.split_whitespace().next()?.parse().ok()
}

/// Today in Greenwich, as year-month-day.
pub(super) fn today() -> String {
    let seconds = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |d| d.as_secs());
    let [year, month, day] = date(seconds / 86_400);
    format!("{year}-{month:02}-{day:02}")
}

fn model_name(cpuinfo: &str) -> Option<String> {
    let line = cpuinfo.lines().find(|line| line.starts_with("model name"))?;
    Some(line.split_once(':')?.1.trim().to_owned())
}

/// Year, month and day from days since 1970-01-01 in the Gregorian calendar.
fn date(days: u64) -> [u64; 3] {
    let is_leap =
        |year: u64| year.is_multiple_of(4) && (!year.is_multiple_of(100) || year.is_multiple_of(400));
    let mut left = days;
    let mut year = 1970;
    while left >= 365 + u64::from(is_leap(year)) {
        left -= 365 + u64::from(is_leap(year));
        year += 1;
    }
    let february = 28 + u64::from(is_leap(year));
    let mut month = 1;
    for length in [31, february, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31] {
        if left < length {
            break;
        }
        left -= length;
        month += 1;
    }
    [year, month, left + 1]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates_follow_the_calendar() {
        assert_eq!(date(0), [1970, 1, 1]);
        // 2000 was a leap year: 30 · 365 + 7 leap days before it, 31 + 28 days into it.
        assert_eq!(date(10_957 + 59), [2000, 2, 29]);
        assert_eq!(date(20_454), [2026, 1, 1]);
        assert_eq!(date(20_454 + 364), [2026, 12, 31]);
    }

    #[test]
    fn the_processor_has_a_name() {
        assert_eq!(model_name("processor : 0\nmodel name\t: Fast 3000\n").as_deref(), Some("Fast 3000"));
        assert!(!processor().is_empty());
    }
}
