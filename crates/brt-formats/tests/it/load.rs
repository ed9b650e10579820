//! Files, and things that are no files.

use std::fs;
use std::path::Path;

use crate::common::{EVERYTHING, NFF};
use brt_formats::{Format, Limits, LoadError, load};

#[test]
fn the_format_is_known_by_extension_or_content() {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in [("a.toml", EVERYTHING), ("a.TXT", EVERYTHING), ("b.nff", NFF), ("b", NFF)] {
        let path = folder.path().join(name);
        fs::write(&path, text).unwrap();
        let loaded = load(&path, &Limits::default()).unwrap();
        assert_eq!(loaded.text, text);
        assert!(loaded.scene.objects.len() >= 5);
    }
    assert!(
        Format::ALL
            .iter()
            .all(|format| (format.reads() || format.writes()) && !format.extensions().is_empty())
    );
}

#[test]
fn each_fault_has_its_error() {
    let folder = tempfile::tempdir().unwrap();
    let error = |name: &str, bytes: &[u8], limits: &Limits| {
        let path = folder.path().join(name);
        fs::write(&path, bytes).unwrap();
        load(&path, limits).unwrap_err()
    };
    let all = Limits::default();
    assert!(matches!(load(folder.path(), &all), Err(LoadError::Io { .. })));
    assert!(matches!(load(&folder.path().join("none"), &all), Err(LoadError::Io { .. })));
    assert!(matches!(error("a.txt", b"hello", &all), LoadError::UnknownFormat { .. }));
    assert!(matches!(error("a", b"", &all), LoadError::Malformed { .. }));
    // JSON of others is no glTF.
    assert!(matches!(error("a.cjson", b"{\"chemicalJson\": 1}", &all), LoadError::UnknownFormat { .. }));
    assert!(matches!(error("a.toml", b"\xff", &all), LoadError::NotUtf8 { position: 0, .. }));
    let small = Limits { memory: 24, ..all };
    assert!(matches!(error("a.toml", b"abcd", &small), LoadError::LimitExceeded { .. }));
    let LoadError::Malformed { report, text, .. } = error("b.nff", b"# \xfc\ns 1 x", &all) else {
        panic!("it is malformed")
    };
    let span = report.diagnostics.iter().find_map(|d| d.expected.as_ref().and(d.span.clone())).unwrap();
    assert_eq!((&text[span], text.len()), ("x", 9));
}

#[test]
#[cfg(target_os = "linux")]
fn a_device_without_an_end_is_not_read_for_ever() {
    let limits = Limits { memory: 1 << 23, ..Limits::default() };
    assert!(matches!(load(Path::new("/dev/zero"), &limits), Err(LoadError::LimitExceeded { .. })));
    assert!(matches!(load(Path::new("/dev/null"), &limits), Err(LoadError::Malformed { .. })));
}

#[test]
#[cfg(target_os = "linux")]
fn a_named_pipe_is_not_waited_for() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("pipe.toml");
    let made = std::process::Command::new("mkfifo").arg(&path).status();
    assert!(made.is_ok_and(|status| status.success()));
    assert!(matches!(load(&path, &Limits::default()), Err(LoadError::Io { .. })));
}
