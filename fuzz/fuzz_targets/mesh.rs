//! Any bytes as a mesh that a scene imports: no panic, and a scene that is returned is good.
#![no_main]

const EXTENSIONS: [&str; 4] = ["ply", "stl", "off", "obj"];

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let Some((&first, bytes)) = bytes.split_first() else { return };
    let name = format!("fuzzed.{}", EXTENSIONS[usize::from(first) % EXTENSIONS.len()]);
    brt_fuzz::beside(&name, bytes);
    let scene = format!(
        "[camera]\neye = [0, 0, 1]\nlook_at = [0, 0, 0]\nfov_deg = 45\n[materials.m]\ncolor = [1, 1, 1]\n\
         [[object]]\ntype = \"mesh\"\nmaterial = \"m\"\nimport = \"{name}\"\n"
    );
    brt_fuzz::read(brt_formats::Format::Toml, scene.as_bytes());
});
