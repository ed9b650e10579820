//! Files that are not complete yet: hidden beside their targets, and locked as long as somebody writes them.
//!
//! A process that is killed leaves its part files behind, but the system takes its locks away. So a part file whose lock
//! can be had belongs to nobody, and whoever writes into its folder next removes it.

use std::ffi::OsStr;
use std::fs::{self, File, OpenOptions, Permissions, TryLockError};
use std::io;
use std::path::Path;

use tempfile::{Builder, NamedTempFile, TempPath};

use super::place::Place;

/// Between the target's name and random letters: tells our part files from those of other programs.
const MARK: &str = ".brt-";
const RANDOM_LETTERS: usize = 8;
const SUFFIX: &str = ".part";
/// Bytes of the target's name that are kept. Names of files may have 255 bytes, and in some folders fewer.
const KEPT_NAME_BYTES: usize = 100;
/// Another process can take a new file for an orphan only in the moment before it is locked.
const MOST_TRIES: usize = 16;

/// A new part file for a target, locked as long as the file is open. It is removed when its path is dropped.
pub(super) fn create(place: &Place, permissions: Option<Permissions>) -> io::Result<(File, TempPath)> {
    for _ in 0..MOST_TRIES {
        let (file, path) = new_file(place)?.into_parts();
        let is_ours = match file.try_lock() {
            Ok(()) => is_at(&file, &path),
            // Where there are no locks, nobody takes it for an orphan.
            Err(TryLockError::Error(_)) => true,
            Err(TryLockError::WouldBlock) => false,
        };
        if is_ours {
            if let Some(permissions) = permissions {
                file.set_permissions(permissions)?;
            }
            return Ok((file, path));
        }
    }
    Err(io::Error::other("another process removes what is begun"))
}

/// Opened here and not by the library, whose files only the owner can read, and whose errors name a hidden path.
fn new_file(place: &Place) -> io::Result<NamedTempFile> {
    let prefix = prefix(place.name());
    let open = |path: &Path| OpenOptions::new().read(true).write(true).create_new(true).open(path);
    builder(&prefix).make_in(place.folder(), open)
}

/// A second name for the file that is at a place now; it is removed when dropped.
pub(super) fn second_name(place: &Place) -> io::Result<TempPath> {
    let prefix = prefix(place.name());
    let made = builder(&prefix).make_in(place.folder(), |path| fs::hard_link(place.path(), path));
    Ok(made?.into_temp_path())
}

fn builder(prefix: &str) -> Builder<'_, 'static> {
    let mut builder = Builder::new();
    builder.prefix(prefix).rand_bytes(RANDOM_LETTERS).suffix(SUFFIX);
    builder
}

/// `.NAME.brt-`
fn prefix(name: &OsStr) -> String {
    let name = name.to_string_lossy();
    format!(".{}{MARK}", &name[..name.floor_char_boundary(KEPT_NAME_BYTES)])
}

/// Removes the part files in a folder that nobody writes. What cannot be looked at or removed stays.
pub(super) fn sweep(folder: &Path) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    for entry in entries.flatten() {
        if is_part_name(&entry.file_name()) && entry.file_type().is_ok_and(|kind| kind.is_file()) {
            remove_orphan(&entry.path());
        }
    }
}

fn remove_orphan(path: &Path) {
    let Ok(file) = OpenOptions::new().write(true).open(path) else { return };
    if file.try_lock().is_ok() && is_at(&file, path) {
        // Another process may have been faster.
        let _ = fs::remove_file(path);
    }
}

fn is_part_name(name: &OsStr) -> bool {
    let random = || {
        let name = name.to_str()?.strip_prefix('.')?.strip_suffix(SUFFIX)?;
        name.rsplit_once(MARK).map(|(_, random)| random)
    };
    random().is_some_and(|random| {
        random.len() == RANDOM_LETTERS && random.bytes().all(|byte| byte.is_ascii_alphanumeric())
    })
}

/// Is the open file still the one of this name?
#[cfg(unix)]
fn is_at(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let id = |metadata: fs::Metadata| (metadata.dev(), metadata.ino());
    match (file.metadata(), fs::symlink_metadata(path)) {
        (Ok(open), Ok(named)) => id(open) == id(named),
        _ => false,
    }
}

/// Open files keep their names here.
#[cfg(not(unix))]
fn is_at(_: &File, _: &Path) -> bool {
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    fn files(folder: &Path) -> usize {
        fs::read_dir(folder).unwrap().count()
    }

    #[test]
    fn part_files_that_nobody_writes_are_swept_and_others_stay() {
        let folder = tempfile::tempdir().unwrap();
        let place = Place::of(&folder.path().join("a.png")).unwrap();
        let (file, path) = create(&place, None).unwrap();
        let orphan = {
            let (file, path) = create(&place, None).unwrap();
            drop(file);
            path.keep().unwrap()
        };
        for others in
            [".a.png.part", ".a.brt-12345678", "a.brt-12345678.part", ".a.brt-1234567.part", "a.png"]
        {
            fs::write(folder.path().join(others), "").unwrap();
        }
        sweep(folder.path());
        assert!(path.exists() && !orphan.exists());
        assert_eq!(files(folder.path()), 6);
        drop(file);
        sweep(folder.path());
        assert!(!path.exists());
    }

    #[test]
    fn names_may_be_as_long_as_the_system_lets_them() {
        let folder = tempfile::tempdir().unwrap();
        for name in ["a".repeat(255), "ä".repeat(127)] {
            let place = Place::of(&folder.path().join(name)).unwrap();
            let (_file, path) = create(&place, None).unwrap();
            assert!(is_part_name(path.file_name().unwrap()));
        }
    }
}
