//! Puts complete files in the places of older ones: all, or none.

use std::fs::{self, File, Metadata, OpenOptions, Permissions};
use std::io;
use std::path::PathBuf;

use tempfile::TempPath;

use super::part_file;
use super::place::Place;
use super::target::naming;

/// A complete file beside its target.
pub(super) struct Part {
    /// As the caller wrote it, for messages.
    pub(super) target: PathBuf,
    pub(super) place: Place,
    pub(super) path: TempPath,
    /// Open until the file is in place: so long its lock is held.
    pub(super) _lock: Option<File>,
}

/// Refuses to replace a file that is protected from writing.
///
/// Renaming would replace what the owner protected: a file that cannot be written is not replaced either, not even by
/// those whom permissions do not bind.
pub(super) fn check_target(place: &Place, existing: &Metadata) -> io::Result<()> {
    if existing.permissions().readonly() {
        return Err(io::Error::new(io::ErrorKind::PermissionDenied, "it is write-protected"));
    }
    match OpenOptions::new().write(true).open(place.path()) {
        // A program that runs can be replaced.
        Err(error) if error.kind() != io::ErrorKind::ExecutableFileBusy => Err(error),
        _ => Ok(()),
    }
}

/// Refuses to replace what cannot be renamed over. `own` is a file of ours in the folder.
pub(super) fn check_renaming(place: &Place, existing: &Metadata, own: &File) -> io::Result<()> {
    check_folder(place, existing, own)?;
    match part_file::second_name(place) {
        // What is mounted over a single file has no other names, and nothing can be renamed over it.
        Err(error) if error.kind() == io::ErrorKind::CrossesDevices => {
            Err(io::Error::new(error.kind(), "it is mounted by itself and cannot be replaced"))
        }
        _ => Ok(()),
    }
}

/// Refuses to replace a file in a folder that only lets owners do so, such as `/tmp`. There, a second name for the file
/// could not be taken away again either.
#[cfg(unix)]
fn check_folder(place: &Place, existing: &Metadata, own: &File) -> io::Result<()> {
    use std::os::unix::fs::MetadataExt;
    let (folder, user) = (fs::metadata(place.folder())?, own.metadata()?.uid());
    if may_replace(user, [existing.uid(), folder.uid()], folder.mode()) {
        return Ok(());
    }
    Err(io::Error::new(io::ErrorKind::PermissionDenied, "its folder lets only its owner replace it"))
}

/// May a user replace a file, given the owners of file and folder, and the folder's mode?
#[cfg(unix)]
fn may_replace(user: u32, owners: [u32; 2], mode: u32) -> bool {
    const STICKY: u32 = 0o1000;
    const ROOT: u32 = 0;
    mode & STICKY == 0 || user == ROOT || owners.contains(&user)
}

#[cfg(not(unix))]
fn check_folder(_: &Place, _: &Metadata, _: &File) -> io::Result<()> {
    Ok(())
}

/// A file that is replaced hands on who may read, write and run it, but not as whom it runs.
#[cfg(unix)]
pub(super) fn new_permissions(existing: &Metadata) -> Option<Permissions> {
    use std::os::unix::fs::PermissionsExt;
    Some(Permissions::from_mode(existing.permissions().mode() & 0o777))
}

#[cfg(not(unix))]
pub(super) fn new_permissions(existing: &Metadata) -> Option<Permissions> {
    Some(existing.permissions())
}

/// Why not all files are in place.
pub(super) struct NotReplaced {
    pub(super) error: io::Error,
    /// Are some in place, which could not be taken back?
    pub(super) some_are: bool,
}

impl From<io::Error> for NotReplaced {
    fn from(error: io::Error) -> Self {
        Self { error, some_are: false }
    }
}

/// Puts files in place. If one cannot be, those before it are taken back.
pub(super) fn replace_all(parts: Vec<Part>) -> Result<(), NotReplaced> {
    for part in &parts {
        if part.place.path().is_dir() {
            return Err(naming(&part.target, &io::ErrorKind::IsADirectory.into()).into());
        }
    }
    let is_alone = parts.len() == 1;
    let mut done: Vec<Replaced> = Vec::with_capacity(parts.len());
    for Part { target, place, path, _lock } in parts {
        let before = if is_alone { Before::Unknown } else { Before::of(&place) };
        if let Err(error) = path.persist(place.path()) {
            let kept: Vec<String> = done.into_iter().rev().filter_map(Replaced::take_back).collect();
            let new =
                if kept.is_empty() { String::new() } else { format!("; new already: {}", kept.join(", ")) };
            let message = format!("{}{new}", naming(&target, &error.error));
            return Err(NotReplaced {
                error: io::Error::new(error.error.kind(), message),
                some_are: !kept.is_empty(),
            });
        }
        done.push(Replaced { target, place, before });
    }
    Ok(())
}

/// A file that is in place.
struct Replaced {
    target: PathBuf,
    place: Place,
    before: Before,
}

/// What was there before.
enum Before {
    Nothing,
    /// Under a second name now, and locked so that nobody takes it for an orphan.
    File(TempPath, #[expect(dead_code, reason = "holds the lock")] Option<File>),
    /// It could not be kept: there are folders without second names.
    Unknown,
}

impl Before {
    fn of(place: &Place) -> Self {
        if !place.path().exists() {
            return Self::Nothing;
        }
        let lock = File::open(place.path()).ok().filter(|file| file.try_lock().is_ok());
        part_file::second_name(place).map_or(Self::Unknown, |name| Self::File(name, lock))
    }
}

impl Replaced {
    /// Puts back what was there before; where that cannot be, returns the name of the file.
    fn take_back(self) -> Option<String> {
        let path = self.place.path();
        let is_back = match self.before {
            Before::Nothing => fs::remove_file(&path).is_ok(),
            Before::File(name, _) => name.persist(&path).is_ok(),
            Before::Unknown => false,
        };
        (!is_back).then(|| self.target.display().to_string())
    }
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn sticky_folders_let_owners_alone_replace() {
        let [sticky, plain] = [0o1777, 0o777];
        assert!(may_replace(7, [8, 9], plain));
        assert!(!may_replace(7, [8, 9], sticky));
        assert!(
            may_replace(7, [7, 9], sticky)
                && may_replace(7, [8, 7], sticky)
                && may_replace(0, [8, 9], sticky)
        );
    }
}
