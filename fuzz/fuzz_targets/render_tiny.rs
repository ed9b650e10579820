//! Any bytes as a small scene at the limits of what can be computed, rendered by all exact methods and `certified`: they
//! end, and agree as they promise.
#![no_main]
use libfuzzer_sys::Corpus;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| -> Corpus { brt_fuzz::render_tiny(bytes) });
