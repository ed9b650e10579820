//! A scene file and the files beside it: all appear, or none.

use std::fs;
use std::path::{Path, PathBuf};

use brt::{FileBeside, FileSet, Written};

use crate::commands::text_file;
use crate::exit::Failure;
use crate::scene_input::check_distinct;

/// Writes a scene that was read from `input` to `path`, and its files beside it.
pub(super) fn put(input: &Path, path: &Path, written: &Written, files: &FileSet) -> Result<(), Failure> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let beside: Vec<PathBuf> = written.files.iter().map(|file| folder.join(&file.name)).collect();
    let all: Vec<PathBuf> = beside.iter().cloned().chain([path.to_owned()]).collect();
    check_distinct(input, &all)?;
    let earlier = earlier_scene(path);
    for (path, file) in beside.iter().zip(&written.files) {
        check_ours(path, file, &earlier)?;
    }
    let contents = written.files.iter().map(|file| file.bytes.as_slice()).chain([written.text.as_bytes()]);
    for (path, content) in all.iter().zip(contents) {
        let mut file = text_file::open(path, files)?;
        file.write_all(content).and_then(|()| file.commit()).map_err(Failure::of_writing)?;
    }
    Ok(files.commit()?)
}

/// The scene that a file of this path holds now; nothing where there is none.
fn earlier_scene(path: &Path) -> String {
    let is_file = fs::metadata(path).is_ok_and(|metadata| metadata.is_file());
    let text = is_file.then(|| fs::read_to_string(path).ok()).flatten();
    text.unwrap_or_default()
}

/// A file that is there already may only be replaced if the earlier scene of this name wrote it.
fn check_ours(path: &Path, file: &FileBeside, earlier: &str) -> Result<(), Failure> {
    let is_named = || earlier.contains(&format!("\"{}\"", file.name));
    let is_same = || fs::read(path).is_ok_and(|bytes| bytes == file.bytes);
    if !path.exists() || is_named() || is_same() {
        return Ok(());
    }
    Err(Failure::CouldNot {
        error: anyhow::anyhow!("{}: another file is there, and would be overwritten", path.display()),
        hint: Some("move it away, or write the scene under another name".to_owned()),
    })
}
