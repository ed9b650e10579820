//! Any bytes as ThreeMf: no panic, and a scene that is returned is good.
#![no_main]
use brt_formats::Format;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    brt_fuzz::read(Format::ThreeMf, bytes);
});
