//! Any bytes as the materials beside an OBJ: no panic, and a scene that is returned is good.
#![no_main]

const OBJ: &str = "mtllib fuzzed.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n\
                   usemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 3/3 2/2 1/1\n";

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    brt_fuzz::beside("fuzzed.mtl", bytes);
    brt_fuzz::read(brt_formats::Format::Obj, OBJ.as_bytes());
});
