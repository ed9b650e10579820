//! Files that a scene file names: found beside it, and only there unless others are allowed.

use std::fs::{self, File};
use std::io::{self, Read};
use std::path::{Component, Path, PathBuf};

use crate::common::Budget;

/// The folder of the scene file, and what may be read from it.
#[derive(Debug)]
pub(crate) struct Beside<'b> {
    folder: Option<PathBuf>,
    budget: &'b Budget<'b>,
    /// Files that were read, and those that were not, but belong to the scene all the same.
    used: Vec<PathBuf>,
}

impl<'b> Beside<'b> {
    /// `folder` is `None` where the scene does not come from a file.
    pub(crate) fn new(folder: Option<&Path>, budget: &'b Budget<'b>) -> Self {
        Self { folder: folder.map(Path::to_owned), budget, used: Vec::new() }
    }

    /// Reads a file by the name that the scene has for it. The error says why not, fit to follow the name.
    pub(crate) fn read(&mut self, name: &str) -> Result<Vec<u8>, String> {
        let path = self.find(name)?;
        let metadata = fs::metadata(&path).map_err(|error| words_of(&error))?;
        if !metadata.is_file() {
            return Err("it is not a file".to_owned());
        }
        let size = metadata.len();
        self.budget.file(size).map_err(|halt| halt.text())?;
        let file = File::open(&path).map_err(|error| words_of(&error))?;
        let mut bytes =
            self.budget.list(size as usize, || "the file".to_owned()).map_err(|halt| halt.text())?;
        file.take(size).read_to_end(&mut bytes).map_err(|error| words_of(&error))?;
        self.used.push(path);
        Ok(bytes)
    }

    /// A file that the scene names and that is not read; nobody may write over it.
    pub(crate) fn leave(&mut self, name: &str) {
        /// A scene of more pictures is not one that anybody made.
        const MOST: usize = 1 << 16;
        if self.used.len() < MOST
            && let Ok(path) = self.find(name)
        {
            self.used.push(path);
        }
    }

    /// The files that the scene is made of.
    pub(crate) fn into_files(self) -> Vec<PathBuf> {
        self.used
    }

    fn find(&self, name: &str) -> Result<PathBuf, String> {
        const OUTSIDE: &str = "it is outside the scene's folder; `--allow-outside` permits it";
        let outside = self.budget.limits().files_outside;
        let Some(folder) = &self.folder else {
            return Err("the scene has no folder".to_owned());
        };
        // Windows' exporters write `\`.
        let name = name.replace('\\', "/");
        let relative = Path::new(&name);
        let is_plain = |c: Component| matches!(c, Component::Normal(_) | Component::CurDir);
        if !outside && !relative.components().all(is_plain) {
            return Err(OUTSIDE.to_owned());
        }
        let path = folder.join(relative);
        // Links may lead outside, too.
        let (real, home) = match (path.canonicalize(), folder.canonicalize()) {
            (Ok(real), Ok(home)) => (real, home),
            (Err(error), _) | (_, Err(error)) => return Err(words_of(&error)),
        };
        if outside || real.starts_with(home) { Ok(real) } else { Err(OUTSIDE.to_owned()) }
    }
}

fn words_of(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound => "no such file".to_owned(),
        _ => error.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::common::Limits;

    #[test]
    fn only_files_of_the_folder_are_read() {
        let root = tempfile::tempdir().unwrap();
        let folder = root.path().join("scene");
        fs::create_dir(&folder).unwrap();
        fs::write(root.path().join("secret"), "s").unwrap();
        fs::write(folder.join("a b.bin"), "x").unwrap();
        let budget = Budget::new(&Limits::default());
        let mut beside = Beside::new(Some(&folder), &budget);
        assert_eq!(beside.read("a b.bin").unwrap(), b"x");
        assert_eq!(beside.read(".\\a b.bin").unwrap(), b"x");
        for name in ["../secret", "/etc/hostname", "a/../../secret"] {
            assert!(beside.read(name).unwrap_err().contains("--allow-outside"), "{name}");
        }
        assert_eq!(beside.read("none").unwrap_err(), "no such file");
        assert_eq!(beside.read(".").unwrap_err(), "it is not a file");
        let limits = Limits { files_outside: true, ..Limits::default() };
        assert_eq!(Beside::new(Some(&folder), &Budget::new(&limits)).read("../secret").unwrap(), b"s");
    }

    #[cfg(unix)]
    #[test]
    fn links_do_not_lead_outside() {
        let root = tempfile::tempdir().unwrap();
        let folder = root.path().join("scene");
        fs::create_dir(&folder).unwrap();
        fs::write(root.path().join("secret"), "s").unwrap();
        std::os::unix::fs::symlink("../secret", folder.join("link")).unwrap();
        let budget = Budget::new(&Limits::default());
        assert!(Beside::new(Some(&folder), &budget).read("link").is_err());
    }

    #[test]
    fn all_files_share_one_limit() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("a"), [0; 100]).unwrap();
        let budget = Budget::new(&Limits { memory: 850, ..Limits::default() });
        let mut beside = Beside::new(Some(folder.path()), &budget);
        (0..8).for_each(|_| drop(beside.read("a").unwrap()));
        assert!(beside.read("a").unwrap_err().contains("--max-memory"));
    }
}
