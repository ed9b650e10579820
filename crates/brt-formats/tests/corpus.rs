//! Files that others wrote: all that `BRT_CORPUS` holds.

#![allow(clippy::print_stderr, reason = "a skipped test says so")]

use std::path::Path;

use brt_formats::{Limits, load, parse, write_toml};

#[test]
fn every_nff_file_of_the_corpus_is_a_scene() {
    let Some(corpus) = std::env::var_os("BRT_CORPUS") else {
        eprintln!("SKIPPED: BRT_CORPUS is not set, no files of others are read");
        return;
    };
    let mut count = 0;
    for entry in std::fs::read_dir(Path::new(&corpus).join("nff")).expect("the corpus has a folder nff") {
        let path = entry.unwrap().path();
        let loaded = load(&path, &Limits::default()).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(loaded.scene.check(), [], "{}", path.display());
        assert!(!loaded.scene.objects.is_empty(), "{}", path.display());
        let again =
            parse(brt_formats::Format::Toml, write_toml(&loaded.scene).as_bytes(), &Limits::default());
        assert_eq!(again.unwrap().0, loaded.scene, "{}", path.display());
        eprintln!(
            "{}: {} objects, {} warnings",
            path.display(),
            loaded.scene.objects.len(),
            loaded.report.diagnostics.len()
        );
        count += 1;
    }
    assert!(count > 0, "the corpus has no NFF files");
}
