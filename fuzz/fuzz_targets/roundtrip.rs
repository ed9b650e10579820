//! A file whose content tells its format: written as ours and read again, it is the same scene; all others can be
//! written, too.
#![no_main]
use brt_formats::{Format, write, write_toml};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let Some(scene) = brt_fuzz::read_file(&brt_fuzz::beside("fuzzed", bytes)) else { return };
    let again = brt_fuzz::read(Format::Toml, write_toml(&scene).as_bytes());
    assert_eq!(again.expect("what we write we can read"), scene);
    for format in Format::ALL.into_iter().filter(|format| format.writes()) {
        write(format, &scene).expect("it is written");
    }
});
