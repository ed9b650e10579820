//! JSON for scripts: keys are a promise.

use serde::Serialize;

/// The value as indented text.
pub(crate) fn text(value: &impl Serialize) -> Result<String, serde_json::Error> {
    serde_json::to_string_pretty(value)
}

/// The measures of a comparison, in levels of 255.
#[derive(Debug, Serialize)]
pub(crate) struct ComparisonJson {
    pixels: u64,
    mean_error: f64,
    max_error: f64,
    over_1: u64,
    over_2: u64,
    over_10: u64,
}

impl From<&brt::Comparison> for ComparisonJson {
    fn from(c: &brt::Comparison) -> Self {
        let brt::Comparison { pixels, mean_error, max_error, over_1, over_2, over_10 } = *c;
        Self { pixels, mean_error, max_error, over_1, over_2, over_10 }
    }
}
