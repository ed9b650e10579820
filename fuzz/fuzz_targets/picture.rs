//! Any bytes as a picture beside a scene: no panic, and a scene that is returned is good.
#![no_main]

const SCENE: &str = "[camera]\neye = [0, 0, 1]\nlook_at = [0, 0, 0]\nfov_deg = 45\n\
                     [materials.m]\ncolor = [1, 1, 1]\ntexture = { file = \"fuzzed.png\" }\n";

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    brt_fuzz::beside("fuzzed.png", bytes);
    brt_fuzz::read(brt_formats::Format::Toml, SCENE.as_bytes());
});
