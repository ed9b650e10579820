//! The files of one task: all of them appear, or none.
//!
//! Each is written beside its target. Once all are complete and on the disk, they are renamed, one after the other. What
//! can keep a rename from working is looked for before anything is written. If one fails after all, the earlier ones are
//! taken back.

use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, TryLockError};
use std::time::{Duration, Instant};

use tempfile::TempPath;

use super::part_file;
use super::place::Place;
use super::replace::{Part, check_renaming, check_target, new_permissions, replace_all};
use super::sink::Sink;
use super::target::{BUFFER_BYTES, Device, Target, naming, standard_output};

/// Files that appear together. Dropped without [`FileSet::commit`], none does.
#[derive(Debug, Default)]
pub struct FileSet(Arc<Mutex<Staged>>);

/// Gives the files of a [`FileSet`] up, from any thread.
#[derive(Clone, Debug)]
pub struct AbortHandle(Arc<Mutex<Staged>>);

/// What is known about the files of a set.
#[derive(Debug, Default)]
struct Staged {
    files: Vec<StagedFile>,
    begun: u64,
    /// Folders in which nothing of killed processes is left.
    swept: Vec<PathBuf>,
    /// Files that were given up before they were complete, and not begun again.
    lost: Vec<Lost>,
    was_committed: bool,
    was_aborted: bool,
}

#[derive(Debug)]
struct Lost {
    target: PathBuf,
    place: Place,
}

#[derive(Debug)]
struct StagedFile {
    id: u64,
    /// As the caller wrote it, for messages.
    target: PathBuf,
    place: Place,
    path: TempPath,
    /// Once all is written; open, since that keeps the lock.
    complete: Option<File>,
}

impl FileSet {
    /// No files yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Opens a file, a device or standard output. A file appears when its sink and then the set are committed; what is
    /// written to the others goes out at once.
    ///
    /// # Errors
    /// If it cannot be opened or replaced, its folder not be written, or the set has it already; the message names it.
    pub fn open(&self, target: &Target) -> io::Result<Box<dyn Sink>> {
        match target {
            Target::Stdout => standard_output(),
            Target::File(path) => self.open_file(path).map_err(|error| naming(path, &error)),
        }
    }

    fn open_file(&self, path: &Path) -> io::Result<Box<dyn Sink>> {
        match fs::metadata(path) {
            Ok(existing) if existing.is_dir() => Err(io::ErrorKind::IsADirectory.into()),
            // Renaming over a device would replace the device. Opening a pipe may wait: nothing is locked meanwhile.
            Ok(existing) if !existing.is_file() => {
                let file = OpenOptions::new().write(true).open(path)?;
                Ok(Box::new(Device::new(path.display().to_string(), file)))
            }
            Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
            _ => Ok(Box::new(self.stage(path)?)),
        }
    }

    fn stage(&self, path: &Path) -> io::Result<PartSink> {
        let place = Place::of(path)?;
        let existing = fs::metadata(place.path()).ok();
        if let Some(existing) = &existing {
            check_target(&place, existing)?;
        }
        // Locked until the file is known, so that none begins after an abort.
        let mut staged = self.locked();
        staged.check_not_aborted()?;
        if staged.files.iter().any(|file| file.place == place) {
            return Err(io::Error::new(io::ErrorKind::AlreadyExists, "it would be written twice"));
        }
        if !staged.swept.iter().any(|folder| folder == place.folder()) {
            part_file::sweep(place.folder());
            staged.swept.push(place.folder().to_owned());
        }
        let (file, part) = part_file::create(&place, existing.as_ref().and_then(new_permissions))?;
        if let Some(existing) = &existing {
            check_renaming(&place, existing, &file)?;
        }
        staged.lost.retain(|file| file.place != place);
        let id = staged.begun;
        staged.begun += 1;
        staged.files.push(StagedFile { id, target: path.to_owned(), place, path: part, complete: None });
        let claim = Claim { set: Arc::clone(&self.0), id };
        Ok(PartSink { target: path.to_owned(), file: BufWriter::with_capacity(BUFFER_BYTES, file), claim })
    }

    /// Puts all files in place. The set is empty then, and can be used again.
    ///
    /// # Errors
    /// If the set was aborted, the sink of a file was dropped or not committed yet, or a file cannot be put in place; then none is, or
    /// the message says which ones are.
    pub fn commit(&self) -> io::Result<()> {
        let mut staged = self.locked();
        staged.check_not_aborted()?;
        let open = staged.files.iter().find(|file| file.complete.is_none()).map(|file| &file.target);
        if let Some(target) = open.or(staged.lost.first().map(|file| &file.target)) {
            return Err(naming(target, &io::Error::other("it is not complete")));
        }
        let files = std::mem::take(&mut staged.files);
        // Still locked: an abort comes before the first file is in place, or after the last.
        let replaced = replace_all(files.into_iter().map(StagedFile::into_part).collect());
        staged.was_committed |= replaced.as_ref().map_or_else(|failed| failed.some_are, |()| true);
        replaced.map_err(|failed| failed.error)
    }

    /// A handle to give the files up with.
    pub fn abort_handle(&self) -> AbortHandle {
        AbortHandle(Arc::clone(&self.0))
    }

    fn locked(&self) -> MutexGuard<'_, Staged> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Drop for FileSet {
    /// Handles and sinks may live on.
    fn drop(&mut self) {
        self.locked().files.clear();
    }
}

impl AbortHandle {
    /// Removes what was begun. From then on the set opens and commits nothing. Returns whether nothing was put in place
    /// before.
    ///
    /// Waits no longer than `patience` for a file that is being opened or put in place at this moment.
    pub fn abort(&self, patience: Duration) -> bool {
        let begin = Instant::now();
        loop {
            let locked = match self.0.try_lock() {
                Ok(staged) => Some(staged),
                Err(TryLockError::Poisoned(poisoned)) => Some(poisoned.into_inner()),
                Err(TryLockError::WouldBlock) => None,
            };
            if let Some(mut staged) = locked {
                staged.was_aborted = true;
                staged.files.clear();
                return !staged.was_committed;
            }
            if begin.elapsed() >= patience {
                return false;
            }
            std::thread::sleep(Duration::from_millis(1));
        }
    }
}

impl Staged {
    fn check_not_aborted(&self) -> io::Result<()> {
        if self.was_aborted { Err(io::Error::other("given up")) } else { Ok(()) }
    }
}

impl StagedFile {
    fn into_part(self) -> Part {
        Part { target: self.target, place: self.place, path: self.path, _lock: self.complete }
    }
}

/// A file of a set while it is written.
#[derive(Debug)]
struct PartSink {
    /// As the caller wrote it, for messages.
    target: PathBuf,
    file: BufWriter<File>,
    claim: Claim,
}

/// Removes its file from the set if that is not complete.
#[derive(Debug)]
struct Claim {
    set: Arc<Mutex<Staged>>,
    id: u64,
}

impl Claim {
    fn complete(&self, file: File) {
        let mut staged = self.set.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(own) = staged.files.iter_mut().find(|own| own.id == self.id) {
            own.complete = Some(file);
        }
    }
}

impl Drop for Claim {
    fn drop(&mut self) {
        let mut staged = self.set.lock().unwrap_or_else(PoisonError::into_inner);
        let is_lost = |file: &mut StagedFile| file.id == self.id && file.complete.is_none();
        let lost =
            staged.files.extract_if(.., is_lost).map(|file| Lost { target: file.target, place: file.place });
        let lost: Vec<Lost> = lost.collect();
        staged.lost.extend(lost);
    }
}

impl PartSink {
    fn named<R>(&self, result: io::Result<R>) -> io::Result<R> {
        result.map_err(|error| naming(&self.target, &error))
    }

    fn patch_unnamed_errors(&mut self, offset: u64, bytes: &[u8]) -> io::Result<()> {
        // Seeking flushes the buffer first.
        self.file.seek(SeekFrom::Start(offset))?;
        self.file.write_all(bytes)?;
        self.file.seek(SeekFrom::End(0)).map(drop)
    }
}

impl Write for PartSink {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.file.write(bytes);
        self.named(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        let flushed = self.file.flush();
        self.named(flushed)
    }
}

impl Sink for PartSink {
    fn can_patch(&self) -> bool {
        true
    }

    fn patch(&mut self, offset: u64, bytes: &[u8]) -> io::Result<()> {
        let patched = self.patch_unnamed_errors(offset, bytes);
        self.named(patched)
    }

    fn commit(self: Box<Self>) -> io::Result<()> {
        let Self { target, file, claim } = *self;
        let file = file.into_inner().map_err(|error| naming(&target, error.error()))?;
        // Whatever closing could report, on a network or over a quota, is reported here. The file stays open for its lock.
        file.sync_all().map_err(|error| naming(&target, &error))?;
        claim.complete(file);
        Ok(())
    }
}
