//! Where a picture goes: a file that appears only when complete, a device, or standard output.

use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use super::file_set::FileSet;
use super::sink::Sink;

/// Large enough that system calls cost nothing beside encoding.
pub(super) const BUFFER_BYTES: usize = 1 << 18;

/// Where a picture goes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Target {
    /// Standard output, as it comes.
    Stdout,
    /// A file, replaced when the picture is complete; a device or pipe is written directly.
    File(PathBuf),
}

impl Target {
    /// Opens a single target for writing: a [`FileSet`] of its own, committed with the sink.
    ///
    /// # Errors
    /// See [`FileSet::open`].
    pub fn open(&self) -> io::Result<Box<dyn Sink>> {
        let set = FileSet::new();
        let sink = set.open(self)?;
        Ok(Box::new(Alone { sink, set }))
    }
}

/// The same error with the path in its message.
pub(super) fn naming(path: &Path, error: &io::Error) -> io::Error {
    naming_text(&path.display().to_string(), error)
}

fn naming_text(name: &str, error: &io::Error) -> io::Error {
    let what = match error.kind() {
        io::ErrorKind::FileTooLarge => "the limit for sizes of files is reached: ",
        _ => "",
    };
    io::Error::new(error.kind(), format!("cannot write {name}: {what}{error}"))
}

/// A file that appears by itself.
struct Alone {
    sink: Box<dyn Sink>,
    set: FileSet,
}

impl Write for Alone {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.sink.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.sink.flush()
    }
}

impl Sink for Alone {
    fn can_patch(&self) -> bool {
        self.sink.can_patch()
    }

    fn patch(&mut self, offset: u64, bytes: &[u8]) -> io::Result<()> {
        self.sink.patch(offset, bytes)
    }

    fn commit(self: Box<Self>) -> io::Result<()> {
        self.sink.commit()?;
        self.set.commit()
    }
}

/// A device, pipe or socket.
#[derive(Debug)]
pub(super) struct Device<W: Write> {
    /// For messages.
    name: String,
    out: BufWriter<W>,
}

impl<W: Write> Device<W> {
    pub(super) fn new(name: String, out: W) -> Self {
        Self { name, out: BufWriter::with_capacity(BUFFER_BYTES, out) }
    }
}

impl<W: Write> Write for Device<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.out.write(bytes).map_err(|error| naming_text(&self.name, &error))
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush().map_err(|error| naming_text(&self.name, &error))
    }
}

impl<W: Write + Send> Sink for Device<W> {
    fn commit(mut self: Box<Self>) -> io::Result<()> {
        self.flush()
    }
}

const STANDARD_OUTPUT: &str = "standard output";

/// Past the library's buffer for lines, which would hold some bytes back until the process ends, where an error would be
/// lost and a full pipe could no longer be left.
#[cfg(unix)]
pub(super) fn standard_output() -> io::Result<Box<dyn Sink>> {
    use std::os::fd::AsFd;
    let out = io::stdout().as_fd().try_clone_to_owned();
    let out = out.map_err(|error| naming_text(STANDARD_OUTPUT, &error))?;
    Ok(Box::new(Device::new(STANDARD_OUTPUT.to_owned(), File::from(out))))
}

#[cfg(not(unix))]
pub(super) fn standard_output() -> io::Result<Box<dyn Sink>> {
    Ok(Box::new(Device::new(STANDARD_OUTPUT.to_owned(), io::stdout())))
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn nothing_is_left_when_a_file_is_given_up() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.png");
        fs::write(&path, "old").unwrap();
        let mut file = Target::File(path.clone()).open().unwrap();
        file.write_all(b"half").unwrap();
        file.flush().unwrap();
        drop(file);
        assert_eq!(fs::read(&path).unwrap(), b"old");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    fn a_committed_file_replaces_the_old_one_whole() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.png");
        fs::write(&path, "older and longer").unwrap();
        let mut file = Target::File(path.clone()).open().unwrap();
        file.write_all(b"0123456789").unwrap();
        file.patch(3, b"xyz").unwrap();
        file.write_all(b"!").unwrap();
        file.commit().unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"012xyz6789!");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    fn errors_name_the_path() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("missing").join("a.png");
        let Err(error) = Target::File(path.clone()).open() else { panic!("opened") };
        assert!(error.to_string().contains(&path.display().to_string()), "{error}");
        let Err(error) = Target::File(folder.path().to_owned()).open() else { panic!("opened") };
        assert!(error.to_string().contains("directory"), "{error}");
    }

    #[cfg(unix)]
    #[test]
    fn new_files_are_as_readable_as_any_other() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        let mode = |p: &Path| fs::metadata(p).unwrap().permissions().mode() & 0o777;
        let (plain, ours) = (folder.path().join("plain"), folder.path().join("ours"));
        fs::write(&plain, "").unwrap();
        Target::File(ours.clone()).open().unwrap().commit().unwrap();
        assert_eq!(mode(&ours), mode(&plain));

        fs::set_permissions(&ours, fs::Permissions::from_mode(0o640)).unwrap();
        Target::File(ours.clone()).open().unwrap().commit().unwrap();
        assert_eq!(mode(&ours), 0o640);
    }

    #[cfg(unix)]
    #[test]
    fn links_stay_links_and_devices_stay_devices() {
        let folder = tempfile::tempdir().unwrap();
        let (real, link) = (folder.path().join("real"), folder.path().join("link"));
        fs::write(&real, "old").unwrap();
        std::os::unix::fs::symlink(&real, &link).unwrap();
        let mut file = Target::File(link.clone()).open().unwrap();
        file.write_all(b"new").unwrap();
        file.commit().unwrap();
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(fs::read(&real).unwrap(), b"new");

        let mut null = Target::File("/dev/null".into()).open().unwrap();
        assert!(!null.can_patch());
        null.write_all(b"gone").unwrap();
        null.commit().unwrap();
        assert!(!fs::metadata("/dev/null").unwrap().is_file());
    }
}
