//! A scene in any format, written and read again, is the same scene.
#![no_main]
use brt_formats::{Format, Limits, parse, write_toml};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    for format in Format::ALL {
        if let Ok((scene, _)) = parse(format, bytes, &Limits::default()) {
            let again = parse(Format::Toml, write_toml(&scene).as_bytes(), &Limits::default());
            assert_eq!(again.expect("what we write we can read").0, scene);
        }
    }
});
