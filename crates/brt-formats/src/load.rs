//! From a path or bytes to a scene.

use std::fs::{self, File};
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use brt_scene::{CheckedScene, Report};

use crate::common::{Budget, Foreign, Format, Halt, Limits, LoadError, ParseError};
use crate::import::{Beside, Given, Imported};
use crate::read::{check_content, format_of, read, sure_format};

/// A scene file that was read.
#[derive(Clone, Debug)]
pub struct Loaded {
    /// The scene.
    pub scene: CheckedScene,
    /// Warnings; positions are byte offsets in `text`.
    pub report: Report,
    /// What the file itself says about how it is looked at.
    pub given: Given,
    /// The other files that were read for it: buffers, materials, pictures, meshes.
    pub files: Vec<PathBuf>,
    /// The file's text, for whoever draws the report; empty for binary files.
    pub text: String,
}

/// Reads a scene file; its format is known by its content where that is sure, else by its extension.
///
/// # Errors
/// See [`LoadError`]. Not more is read than an eighth of [`Limits::memory`], from devices without an end, too. A named
/// pipe is refused, since opening it may wait for ever.
pub fn load(path: &Path, limits: &Limits) -> Result<Loaded, LoadError> {
    load_as(path, None, limits)
}

/// Reads a scene file in a format, or as [`load`] does where none is named.
///
/// # Errors
/// See [`load`].
pub fn load_as(path: &Path, format: Option<Format>, limits: &Limits) -> Result<Loaded, LoadError> {
    let bytes = read_file(path, limits)?;
    let Some(found) = format.or_else(|| format_of(path, &bytes)) else {
        return Err(unknown(path, bytes));
    };
    // The folder of a bare name is the current one.
    let folder =
        path.parent().map(|folder| if folder.as_os_str().is_empty() { Path::new(".") } else { folder });
    match import(found, &bytes, folder, limits) {
        Ok(Imported { scene, report, given, files }) => {
            let text = text_for(&report, bytes);
            Ok(Loaded { scene, report, given, files, text })
        }
        Err(error) => {
            let is_broken = matches!(error, ParseError::Malformed(_) | ParseError::NotUtf8 { .. });
            let content = sure_format(&bytes).filter(|content| *content != found);
            Err(match content.filter(|_| is_broken && format.is_none()) {
                Some(content) => LoadError::Misnamed { path: path.to_owned(), named: found, content },
                None => with_path(error, path, bytes),
            })
        }
    }
}

/// Why a file is not read whose format nothing tells.
fn unknown(path: &Path, bytes: Vec<u8>) -> LoadError {
    match (Foreign::of(path, &bytes), check_content(&bytes)) {
        (Some(foreign), _) => LoadError::Foreign { path: path.to_owned(), foreign },
        (None, Err(empty)) => with_path(empty, path, bytes),
        (None, Ok(())) => LoadError::UnknownFormat { path: path.to_owned() },
    }
}

/// Reads a scene from bytes. Positions in the report are offsets in `bytes`. Other files that the scene names are not
/// read: see [`import`].
///
/// # Errors
/// See [`ParseError`].
pub fn parse(format: Format, bytes: &[u8], limits: &Limits) -> Result<(CheckedScene, Report), ParseError> {
    import(format, bytes, None, limits).map(|Imported { scene, report, .. }| (scene, report))
}

/// Reads a scene from bytes, and the files that it names from a folder.
///
/// # Errors
/// See [`ParseError`].
pub fn import(
    format: Format,
    bytes: &[u8],
    folder: Option<&Path>,
    limits: &Limits,
) -> Result<Imported, ParseError> {
    let budget = Budget::new(limits);
    budget.file(bytes.len() as u64)?;
    let mut beside = Beside::new(folder, &budget);
    let imported = read(format, bytes, &mut beside, &budget)?;
    Ok(Imported { files: beside.into_files(), ..imported })
}

fn read_file(path: &Path, limits: &Limits) -> Result<Vec<u8>, LoadError> {
    let failed = |source| LoadError::Io { path: path.to_owned(), source };
    let metadata = fs::metadata(path).map_err(failed)?;
    if metadata.is_dir() {
        return Err(failed(io::Error::new(io::ErrorKind::IsADirectory, "it is a directory")));
    }
    if may_wait_for_ever(path, &metadata) {
        return Err(failed(io::Error::new(io::ErrorKind::InvalidInput, "it is a named pipe")));
    }
    let file = File::open(path).map_err(failed)?;
    let size = if metadata.is_file() { Some(metadata.len()) } else { None };
    match read_stream(file, size, limits) {
        Ok(bytes) => Ok(bytes),
        Err(ReadError::Io(source)) => Err(failed(source)),
        Err(ReadError::Halt(Halt::Limit(exceeded))) => {
            Err(LoadError::LimitExceeded { path: path.to_owned(), exceeded })
        }
        Err(ReadError::Halt(Halt::Cancelled)) => Err(LoadError::Cancelled { path: path.to_owned() }),
    }
}

enum ReadError {
    Io(io::Error),
    Halt(Halt),
}

/// Reads a stream to its end, in pieces between which it may be cancelled.
fn read_stream(mut stream: impl Read, size: Option<u64>, limits: &Limits) -> Result<Vec<u8>, ReadError> {
    const PIECE: u64 = 1 << 22;
    let budget = Budget::new(limits);
    budget.file(size.unwrap_or(0)).map_err(ReadError::Halt)?;
    let size = size.and_then(|size| usize::try_from(size).ok()).unwrap_or(0);
    let mut bytes = budget.list(size, || "the file".to_owned()).map_err(ReadError::Halt)?;
    loop {
        let count = stream.by_ref().take(PIECE).read_to_end(&mut bytes).map_err(ReadError::Io)?;
        budget.go_on().map_err(ReadError::Halt)?;
        limits.allow_file(bytes.len() as u64).map_err(|limit| ReadError::Halt(limit.into()))?;
        if count == 0 {
            return Ok(bytes);
        }
    }
}

/// A named pipe that nobody writes to blocks already in `open`. Pipes of this process (`/dev/stdin`, a shell's
/// `<(command)`) are open already.
#[cfg(unix)]
fn may_wait_for_ever(path: &Path, metadata: &fs::Metadata) -> bool {
    use std::os::unix::fs::FileTypeExt;
    metadata.file_type().is_fifo() && !path.starts_with("/dev") && !path.starts_with("/proc")
}

#[cfg(not(unix))]
fn may_wait_for_ever(_: &Path, _: &fs::Metadata) -> bool {
    false
}

fn with_path(error: ParseError, path: &Path, bytes: Vec<u8>) -> LoadError {
    let path = path.to_owned();
    match error {
        ParseError::OnlyWritten(format) => LoadError::OnlyWritten { path, format },
        ParseError::LeftOut(format) => LoadError::LeftOut { path, format },
        ParseError::NotUtf8 { position } => LoadError::NotUtf8 { path, position },
        ParseError::Malformed(report) => {
            let text = text_for(&report, bytes);
            LoadError::Malformed { path, report, text }
        }
        ParseError::LimitExceeded(exceeded) => LoadError::LimitExceeded { path, exceeded },
        ParseError::Cancelled => LoadError::Cancelled { path },
    }
}

/// The text that a report's positions are in. Binary formats have neither; text is not copied.
fn text_for(report: &Report, bytes: Vec<u8>) -> String {
    let has_places = report.diagnostics.iter().any(|d| d.span.is_some());
    match String::from_utf8(bytes) {
        Ok(text) => text,
        Err(error) if has_places => text_of(error.into_bytes()),
        Err(_) => String::new(),
    }
}

/// The bytes as text of the same length: old files have comments in old encodings, and positions must stay.
fn text_of(bytes: Vec<u8>) -> String {
    String::from_utf8(bytes).unwrap_or_else(|error| {
        error.into_bytes().iter().map(|&b| if b.is_ascii() { char::from(b) } else { '?' }).collect()
    })
}
