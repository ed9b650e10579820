//! From a path or bytes to a scene.

use std::fs::{self, File};
use std::io::{self, Read};
use std::path::Path;

use brt_scene::{Report, Scene};

use crate::{Format, LimitExceeded, LimitKind, Limits, LoadError, ParseError, nff, toml};

/// A scene file that was read.
#[derive(Clone, Debug)]
pub struct Loaded {
    /// The scene; its check finds nothing.
    pub scene: Scene,
    /// Warnings; positions are byte offsets in `text`.
    pub report: Report,
    /// The file's text, for whoever draws the report.
    pub text: String,
}

/// Reads a scene file; its format is known by its extension, else by its content.
///
/// # Errors
/// See [`LoadError`]. At most [`Limits::bytes`] + 1 bytes are read, from devices without an end, too. A named pipe
/// is refused, since opening it may wait for ever.
pub fn load(path: &Path, limits: &Limits) -> Result<Loaded, LoadError> {
    let bytes =
        read_file(path, limits.bytes).map_err(|source| LoadError::Io { path: path.to_owned(), source })?;
    if let Err(exceeded) = limits.allows(LimitKind::Bytes, bytes.len() as u64) {
        return Err(LoadError::LimitExceeded { path: path.to_owned(), exceeded });
    }
    let Some(format) = Format::from_path(path).or_else(|| Format::from_content(&bytes)) else {
        return Err(LoadError::UnknownFormat { path: path.to_owned() });
    };
    match parse(format, &bytes, limits) {
        Ok((scene, report)) => Ok(Loaded { scene, report, text: text_of(bytes) }),
        Err(error) => Err(with_path(error, path, bytes)),
    }
}

/// Reads a scene from bytes. Positions in the report are offsets in `bytes`.
///
/// # Errors
/// See [`ParseError`].
pub fn parse(format: Format, bytes: &[u8], limits: &Limits) -> Result<(Scene, Report), ParseError> {
    limits.allows(LimitKind::Bytes, bytes.len() as u64)?;
    match format {
        Format::Toml => toml::read(bytes, limits),
        Format::Nff => nff::read(bytes, limits),
        Format::Pov | Format::Dat => Err(ParseError::OnlyWritten(format)),
    }
}

fn read_file(path: &Path, limit: u64) -> io::Result<Vec<u8>> {
    let metadata = fs::metadata(path)?;
    if metadata.is_dir() {
        return Err(io::Error::new(io::ErrorKind::IsADirectory, "it is a directory"));
    }
    if may_wait_for_ever(path, &metadata) {
        return Err(io::Error::new(io::ErrorKind::InvalidInput, "it is a named pipe"));
    }
    let mut bytes = Vec::new();
    File::open(path)?.take(limit.saturating_add(1)).read_to_end(&mut bytes)?;
    Ok(bytes)
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
        ParseError::NotUtf8 { position } => LoadError::NotUtf8 { path, position },
        ParseError::Malformed(report) => LoadError::Malformed { path, report, text: text_of(bytes) },
        ParseError::LimitExceeded(LimitExceeded { what, limit }) => {
            LoadError::LimitExceeded { path, exceeded: LimitExceeded { what, limit } }
        }
    }
}

/// The bytes as text of the same length: old files have comments in old encodings, and positions must stay.
fn text_of(bytes: Vec<u8>) -> String {
    String::from_utf8(bytes).unwrap_or_else(|error| {
        error.into_bytes().iter().map(|&b| if b.is_ascii() { char::from(b) } else { '?' }).collect()
    })
}
