//! Where a picture goes: a file that appears only when complete, or standard output.

use std::ffi::OsStr;
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

use super::sink::{PlainSink, Sink};

/// Large enough that system calls cost nothing beside encoding.
const BUFFER_BYTES: usize = 1 << 18;

/// Where a picture goes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Target {
    /// Standard output, as it comes.
    Stdout,
    /// A file, replaced when the picture is complete; a device or pipe is written directly.
    File(PathBuf),
}

impl Target {
    /// Opens the target for writing.
    ///
    /// # Errors
    /// If it cannot be opened or its folder not be written; the message names the path.
    pub fn open(&self) -> io::Result<Box<dyn Sink>> {
        match self {
            Self::Stdout => Ok(Box::new(PlainSink(BufWriter::with_capacity(BUFFER_BYTES, io::stdout())))),
            Self::File(path) => open_file(path).map_err(|e| naming(path, &e)),
        }
    }
}

fn open_file(path: &Path) -> io::Result<Box<dyn Sink>> {
    match fs::metadata(path) {
        Ok(existing) if existing.is_dir() => Err(io::ErrorKind::IsADirectory.into()),
        // Renaming over a device would replace the device.
        Ok(existing) if !existing.is_file() => {
            let file = OpenOptions::new().write(true).open(path)?;
            Ok(Box::new(Device { path: path.to_owned(), file: BufWriter::with_capacity(BUFFER_BYTES, file) }))
        }
        _ => Ok(Box::new(AtomicFile::create_unnamed_errors(path)?)),
    }
}

/// The same error with the path in its message.
fn naming(path: &Path, error: &io::Error) -> io::Error {
    io::Error::new(error.kind(), format!("cannot write {}: {error}", path.display()))
}

/// A file written beside its target under another name, and renamed when complete.
///
/// Dropped without [`Sink::commit`] it is removed, and the target is as it was.
#[derive(Debug)]
pub struct AtomicFile {
    /// As the caller wrote it, for messages.
    path: PathBuf,
    /// With symbolic links followed, so that a link stays a link.
    destination: PathBuf,
    file: BufWriter<NamedTempFile>,
}

impl AtomicFile {
    /// Starts a file that will become `path`.
    ///
    /// # Errors
    /// If its folder does not exist or cannot be written; the message names the path.
    pub fn create(path: &Path) -> io::Result<Self> {
        Self::create_unnamed_errors(path).map_err(|e| naming(path, &e))
    }

    fn create_unnamed_errors(path: &Path) -> io::Result<Self> {
        let destination = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
        let name = destination.file_name().ok_or(io::ErrorKind::InvalidFilename)?;
        let folder = match destination.parent() {
            Some(folder) if folder != Path::new("") => folder,
            _ => Path::new("."),
        };
        let file = create_temporary(folder, name)?;
        // A file that is replaced hands on its permissions.
        if let Ok(existing) = fs::metadata(&destination) {
            file.as_file().set_permissions(existing.permissions())?;
        }
        let file = BufWriter::with_capacity(BUFFER_BYTES, file);
        Ok(Self { path: path.to_owned(), destination, file })
    }

    fn patch_unnamed_errors(&mut self, offset: u64, bytes: &[u8]) -> io::Result<()> {
        // Seeking flushes the buffer first.
        self.file.seek(SeekFrom::Start(offset))?;
        self.file.write_all(bytes)?;
        self.file.seek(SeekFrom::End(0)).map(drop)
    }
}

/// A new hidden file in `folder` with the permissions of an ordinary new file.
fn create_temporary(folder: &Path, name: &OsStr) -> io::Result<NamedTempFile> {
    let mut prefix = OsStr::new(".").to_owned();
    prefix.push(name);
    let mut builder = tempfile::Builder::new();
    builder.prefix(&prefix).suffix(".part");
    // The default, readable by the owner alone, suits secrets. The umask still applies.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    // What went wrong without the random name that it went wrong with.
    builder
        .tempfile_in(folder)
        .map_err(|error| error.raw_os_error().map_or(error, io::Error::from_raw_os_error))
}

impl Write for AtomicFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes).map_err(|e| naming(&self.path, &e))
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush().map_err(|e| naming(&self.path, &e))
    }
}

impl Sink for AtomicFile {
    fn can_patch(&self) -> bool {
        true
    }

    fn patch(&mut self, offset: u64, bytes: &[u8]) -> io::Result<()> {
        self.patch_unnamed_errors(offset, bytes).map_err(|e| naming(&self.path, &e))
    }

    fn commit(self: Box<Self>) -> io::Result<()> {
        let Self { path, destination, file } = *self;
        let file = file.into_inner().map_err(|e| naming(&path, e.error()))?;
        file.persist(&destination).map(drop).map_err(|e| naming(&path, &e.error))
    }
}

/// A device, pipe or socket with a path.
#[derive(Debug)]
struct Device {
    path: PathBuf,
    file: BufWriter<File>,
}

impl Write for Device {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes).map_err(|e| naming(&self.path, &e))
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush().map_err(|e| naming(&self.path, &e))
    }
}

impl Sink for Device {
    fn commit(mut self: Box<Self>) -> io::Result<()> {
        self.flush()
    }
}

#[cfg(test)]
mod tests {
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
        Box::new(AtomicFile::create(&ours).unwrap()).commit().unwrap();
        assert_eq!(mode(&ours), mode(&plain));

        fs::set_permissions(&ours, fs::Permissions::from_mode(0o640)).unwrap();
        Box::new(AtomicFile::create(&ours).unwrap()).commit().unwrap();
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
