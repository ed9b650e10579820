//! Which file a path means, whether it is there yet or not.

use std::ffi::{OsStr, OsString};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Links that are followed before they count as a circle, as many as Linux follows.
const MOST_LINKS: usize = 40;

/// A file in its folder. Two paths that mean one file have one place: `a`, `./a`, `sub/../a` and links to it.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Place {
    /// Without links and dots.
    folder: PathBuf,
    name: OsString,
}

impl Place {
    /// The place that writing to a path would write to. Symbolic links are followed, also those that lead to nothing yet.
    ///
    /// # Errors
    /// If the folder is not there, the path has no name, or links lead in a circle.
    pub fn of(path: &Path) -> io::Result<Self> {
        let mut path = path.to_owned();
        for _ in 0..MOST_LINKS {
            let folder = match path.parent() {
                Some(folder) if folder != Path::new("") => folder,
                _ => Path::new("."),
            };
            let Ok(next) = fs::read_link(&path) else {
                let name = path.file_name().ok_or(io::ErrorKind::InvalidFilename)?;
                return Ok(Self { folder: folder.canonicalize()?, name: name.to_owned() });
            };
            path = folder.join(next);
        }
        Err(io::Error::other("too many symbolic links"))
    }

    /// The folder.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// The name in the folder.
    pub fn name(&self) -> &OsStr {
        &self.name
    }

    /// Folder and name.
    pub fn path(&self) -> PathBuf {
        self.folder.join(&self.name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_file_has_one_place_before_it_is_there_and_after() {
        let root = tempfile::tempdir().unwrap();
        fs::create_dir(root.path().join("sub")).unwrap();
        let same = ["a.png", "./a.png", "sub/../a.png", "sub/.././a.png"];
        for exists in [false, true] {
            if exists {
                fs::write(root.path().join("a.png"), "").unwrap();
            }
            for path in same {
                let [a, b] = ["a.png", path].map(|path| Place::of(&root.path().join(path)).unwrap());
                assert_eq!(a, b, "{path}");
            }
            assert_ne!(
                Place::of(&root.path().join("a.png")).unwrap(),
                Place::of(&root.path().join("b")).unwrap()
            );
        }
        assert!(Place::of(&root.path().join("no/a.png")).is_err());
    }

    #[cfg(unix)]
    #[test]
    fn links_are_followed_to_what_is_not_there_yet_and_circles_are_refused() {
        use std::os::unix::fs::symlink;
        let root = tempfile::tempdir().unwrap();
        let at = |name: &str| root.path().join(name);
        fs::create_dir(at("sub")).unwrap();
        symlink("sub/real", at("link")).unwrap();
        symlink("link", at("link2")).unwrap();
        assert_eq!(Place::of(&at("link2")).unwrap(), Place::of(&at("sub/real")).unwrap());
        symlink("y", at("x")).unwrap();
        symlink("x", at("y")).unwrap();
        assert!(Place::of(&at("x")).is_err());
    }
}
