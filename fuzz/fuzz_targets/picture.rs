//! Any bytes as a picture on a surface: no panic, and no more texels than the limit allows.
#![no_main]
use base64::Engine as _;
use brt_formats::{Format, Limits, parse};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let data = base64::engine::general_purpose::STANDARD.encode(bytes);
    let text = format!(
        "[camera]\neye = [0, 0, 1]\nlook_at = [0, 0, 0]\nfov_deg = 45\n\
         [materials.m]\ncolor = [1, 1, 1]\ntexture = {{ data = \"{data}\" }}\n"
    );
    let limits = Limits { texture_pixels: 1 << 20, ..Limits::default() };
    if let Ok((scene, _)) = parse(Format::Toml, text.as_bytes(), &limits) {
        assert_eq!(scene.check(), []);
    }
});
