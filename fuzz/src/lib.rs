//! What targets share. Importers: bytes are read as `brt` reads a file, from a folder with others beside it, under the
//! limits that are shipped. Renderers: bytes are choices of a scene and of how it is rendered.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use base64::Engine as _;
use brt_formats::{Format, Limits, ParseError, import, load};
use brt_scene::{Report, Scene};
use brt_testkit::{broken_promise, tiny_trial};
use libfuzzer_sys::Corpus;

/// A PNG of 2 × 2 pixels.
const PNG: &str = "iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAYAAABytg0kAAAAE0lEQVR42mP4z8DwHwyBNAg0AABJSQl4nFEXkgAAAABJRU5ErkJggg==";
const MTL: &str = "newmtl a\nKd 1 0 0\nmap_Kd a.png\nnewmtl b\nKd 0 1 0\nd 0.5\n";
const OFF: &str = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

/// The folder of the files: `a.png`, `a.mtl` and `a.off` lie in it. One per process, in that for temporary files.
pub fn folder() -> &'static Path {
    static FOLDER: OnceLock<PathBuf> = OnceLock::new();
    FOLDER.get_or_init(|| {
        let folder = std::env::temp_dir().join(format!("brt-fuzz-{}", std::process::id()));
        fs::create_dir_all(&folder).expect("a folder for temporary files");
        let png = base64::engine::general_purpose::STANDARD.decode(PNG).expect("base64");
        for (name, bytes) in [("a.png", &png[..]), ("a.mtl", MTL.as_bytes()), ("a.off", OFF.as_bytes())] {
            write(&folder.join(name), bytes);
        }
        folder
    })
}

/// Puts a file into the folder and returns its path.
pub fn beside(name: &str, bytes: &[u8]) -> PathBuf {
    let path = folder().join(name);
    write(&path, bytes);
    path
}

fn write(path: &Path, bytes: &[u8]) {
    fs::write(path, bytes).expect("the folder can be written to");
}

/// Reads bytes. A scene that is returned is good, an error says something and its places are in the file.
pub fn read(format: Format, bytes: &[u8]) -> Option<Scene> {
    match import(format, bytes, Some(folder()), &Limits::default()) {
        Ok(imported) => {
            assert!(!imported.report.has_errors());
            check_places(&imported.report, bytes);
            Some(imported.scene.into_inner())
        }
        Err(ParseError::Malformed(report)) => {
            assert!(report.has_errors());
            check_places(&report, bytes);
            None
        }
        Err(error) => {
            assert!(!error.to_string().is_empty());
            None
        }
    }
}

/// Reads a file of the folder, whose format its name or content tells.
pub fn read_file(path: &Path) -> Option<Scene> {
    match load(path, &Limits::default()) {
        Ok(loaded) => Some(loaded.scene.into_inner()),
        Err(error) => {
            assert!(!error.to_string().is_empty());
            None
        }
    }
}

fn check_places(report: &Report, bytes: &[u8]) {
    for diagnostic in &report.diagnostics {
        assert!(!diagnostic.message.is_empty());
        if let Some(span) = &diagnostic.span {
            assert!(span.start <= span.end && span.end <= bytes.len(), "{span:?} of {}", bytes.len());
        }
    }
}

/// Renders the scene that these bytes stand for by all methods that are exact or within a tolerance, and holds them
/// against each other. What is not fit to be rendered is not kept.
///
/// # Panics
/// If they differ; the message holds the scene as a file.
pub fn render_tiny(bytes: &[u8]) -> Corpus {
    let Some((scene, trial)) = tiny_trial(bytes) else { return Corpus::Reject };
    if let Some(broken) = broken_promise(&scene, &trial) {
        panic!("{broken}");
    }
    Corpus::Keep
}
