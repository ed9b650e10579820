//! Files that others wrote: all that `BRT_CORPUS` holds.

use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

use brt_formats::{Format, Limits, import, load, parse, write_beside, write_toml};
use brt_scene::Scene;

/// The corpus, if there is one.
fn corpus() -> Option<PathBuf> {
    let corpus = std::env::var_os("BRT_CORPUS").map(PathBuf::from);
    if corpus.is_none() {
        let test = std::thread::current().name().unwrap_or_default().to_owned();
        // What `eprintln` writes is hidden where a test passes. If this cannot be seen either, nobody looks.
        let _ = writeln!(
            std::io::stderr(),
            "skipped: {test}: BRT_CORPUS is not set, no files of others are read"
        );
    }
    corpus
}

fn files_below(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder of the corpus") {
        let path = entry.unwrap().path();
        if path.is_dir() { files_below(&path, files) } else { files.push(path) }
    }
    files.sort();
}

#[test]
fn every_good_file_of_the_corpus_is_a_scene() {
    let Some(corpus) = corpus() else { return };
    let mut files = Vec::new();
    files_below(&corpus, &mut files);
    let mut failed = Vec::new();
    let mut count = 0;
    for path in files.iter().filter(|path| !path.starts_with(corpus.join("hostile"))) {
        if !Format::from_path(path).is_some_and(Format::reads) {
            continue;
        }
        count += 1;
        match load(path, &Limits::default()) {
            Ok(loaded) => {
                assert_eq!(loaded.scene.check(), [], "{}", path.display());
                assert!(!loaded.scene.objects.is_empty(), "{}", path.display());
                let again = parse(Format::Toml, write_toml(&loaded.scene).as_bytes(), &Limits::default());
                assert_eq!(again.unwrap().0, loaded.scene, "{}", path.display());
                comes_back_with_files(loaded.scene.into_inner(), path);
            }
            Err(error) => failed.push(error.to_string()),
        }
    }
    assert!(failed.is_empty(), "{} of {count} files are not read:\n{}", failed.len(), failed.join("\n"));
    assert!(count > 0, "the corpus has no files that are read");
}

/// Written with files beside it and read again it is the same scene, but for the names of its pictures.
fn comes_back_with_files(mut scene: Scene, path: &Path) {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out.toml");
    let written = write_beside(Format::Toml, &scene, &out).unwrap();
    fs::write(&out, &written.text).unwrap();
    for file in &written.files {
        fs::write(folder.path().join(&file.name), &file.bytes).unwrap();
    }
    let again = load(&out, &Limits::default()).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let mut scene_again = again.scene.into_inner();
    for texture in
        scene.materials.iter_mut().chain(&mut scene_again.materials).filter_map(|m| m.texture.as_mut())
    {
        Arc::make_mut(&mut texture.picture).name.clear();
    }
    assert_eq!(scene_again, scene, "{}", path.display());
    assert!(again.report.diagnostics.is_empty(), "{}: {:?}", path.display(), again.report);
}

/// A scene whose only material has this picture.
fn with_picture(path: &Path) -> Result<Scene, String> {
    let name = path.file_name().unwrap().to_str().unwrap();
    let text = format!(
        "[camera]\neye = [0, 0, 5]\nlook_at = [0, 0, 0]\nfov_deg = 45\n\
         [materials.m]\ncolor = [1, 1, 1]\ntexture = {{ file = \"{name}\" }}\n"
    );
    let read = import(Format::Toml, text.as_bytes(), path.parent(), &Limits::default());
    read.map(|imported| imported.scene.into_inner()).map_err(|error| error.to_string())
}

fn is_picture(path: &Path) -> bool {
    path.extension().is_some_and(|e| ["png", "jpg", "jpeg"].iter().any(|known| e.eq_ignore_ascii_case(known)))
}

#[test]
fn every_picture_of_the_corpus_is_decoded_or_refused() {
    let Some(corpus) = corpus() else { return };
    let mut files = Vec::new();
    files_below(&corpus, &mut files);
    let mut count = 0;
    for path in files.iter().filter(|path| is_picture(path)) {
        let start = Instant::now();
        let read = with_picture(path);
        assert!(start.elapsed() < Duration::from_secs(10), "{}", path.display());
        let is_hostile = path.starts_with(corpus.join("hostile"));
        match read {
            Ok(scene) => assert_eq!(scene.check(), [], "{}", path.display()),
            Err(error) => {
                assert!(is_hostile && error.contains("cannot be read"), "{}: {error}", path.display());
            }
        }
        count += 1;
    }
    assert!(count > 0, "the corpus has no pictures");
}

#[test]
fn every_hostile_file_of_the_corpus_ends_in_time() {
    let Some(corpus) = corpus() else { return };
    let mut files = Vec::new();
    files_below(&corpus.join("hostile"), &mut files);
    for path in &files {
        let start = Instant::now();
        match load(path, &Limits::default()) {
            Ok(loaded) => assert_eq!(loaded.scene.check(), [], "{}", path.display()),
            Err(error) => assert!(error.to_string().contains(&path.display().to_string()), "{error}"),
        }
        assert!(start.elapsed() < Duration::from_secs(10), "{}", path.display());
    }
    assert!(!files.is_empty(), "the corpus has no hostile files");
}
