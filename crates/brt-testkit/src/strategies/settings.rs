//! Random settings, and how property tests are run.

use brt_render::{BorderSettings, DeviationDelta, DifferenceDelta, Judge, Regions, VarianceDelta};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// A run of `cases` cases that are the same every time; `BRT_SOAK=n` in the environment makes them n times as many.
pub fn seeded(seed: u64, cases: u32) -> ProptestConfig {
    let soak = std::env::var("BRT_SOAK").ok().and_then(|n| n.parse().ok()).unwrap_or(1);
    ProptestConfig {
        cases: cases.saturating_mul(soak),
        rng_seed: RngSeed::Fixed(seed),
        failure_persistence: None,
        max_shrink_iters: 300,
        ..ProptestConfig::default()
    }
}

/// One of the three judgements, with any Δ.
pub fn any_judge() -> impl Strategy<Value = Judge> {
    let delta = prop_oneof![Just(0.0), 0.0..10.0, 10.0..130.0, Just(f64::INFINITY)];
    (delta, 0..3).prop_map(|(delta, kind)| match kind {
        0 => Judge::Variance(VarianceDelta(delta)),
        1 => Judge::Deviation(DeviationDelta(delta)),
        _ => Judge::Difference(DifferenceDelta(delta)),
    })
}

/// Any settings of border ray tracing.
pub fn any_border() -> impl Strategy<Value = BorderSettings> {
    let block = prop_oneof![1_u32..40, Just(16), Just(128)];
    let regions = prop::sample::select(vec![Regions::Separate, Regions::Together]);
    (block, any_judge(), regions).prop_map(|(block, judge, regions)| BorderSettings { block, judge, regions })
}
