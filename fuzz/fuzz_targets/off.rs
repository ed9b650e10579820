//! Any bytes as Off: no panic, and a scene that is returned is good.
#![no_main]
use brt_formats::{Format, Limits, parse};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    if let Ok((scene, _)) = parse(Format::Off, bytes, &Limits::default()) {
        assert_eq!(scene.check(), []);
    }
});
