//! Reads a whole picture, whatever its format.

use std::fs::File;
use std::io::{BufRead, BufReader, Cursor, Read, Seek};
use std::path::Path;

use super::error::{DecodeError, DecodeProblem};
use super::{exr_read, png_read, pnm_read};
use crate::{Picture, PictureSize};

/// What a reader may spend.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PictureLimits {
    /// Most pixels of a picture; asked before memory is taken.
    pub pixels: u64,
}

impl Default for PictureLimits {
    /// A gigapixel picture of 32768².
    fn default() -> Self {
        Self { pixels: 1 << 30 }
    }
}

impl PictureLimits {
    /// The number of pixels of a picture, if it is allowed and not empty.
    pub(crate) fn check(self, size: PictureSize, format: &'static str) -> Result<usize, DecodeProblem> {
        if size.pixels() == 0 {
            return Err(DecodeProblem::malformed(format, "the picture has no pixels"));
        }
        let exceeded = DecodeProblem::LimitExceeded { size, limit: self.pixels };
        if size.pixels() > self.pixels {
            return Err(exceeded);
        }
        usize::try_from(size.pixels()).map_err(|_| exceeded)
    }
}

/// Reads a PNG, PPM, PGM or EXR file, known by its first bytes.
///
/// # Errors
/// If the file cannot be read, is damaged, of another format, or larger than the limits allow.
pub fn read_picture(path: &Path, limits: PictureLimits) -> Result<Picture, DecodeError> {
    let read = || decode(BufReader::new(File::open(path)?), limits);
    read().map_err(|problem| DecodeError { path: path.to_owned(), problem })
}

/// Like [`read_picture`], from the bytes of a file.
///
/// # Errors
/// If the bytes are damaged, of another format, or larger than the limits allow.
pub fn decode_picture(bytes: &[u8], limits: PictureLimits) -> Result<Picture, DecodeProblem> {
    decode(Cursor::new(bytes), limits)
}

fn decode<R: BufRead + Seek>(mut source: R, limits: PictureLimits) -> Result<Picture, DecodeProblem> {
    let mut magic = Vec::with_capacity(4);
    source.by_ref().take(4).read_to_end(&mut magic)?;
    source.rewind()?;
    match &magic[..] {
        [0x89, b'P', b'N', b'G'] => png_read::read(source, limits),
        [b'P', b'5' | b'6', ..] => pnm_read::read(source, limits),
        [0x76, 0x2f, 0x31, 0x01] => exr_read::read(source, limits),
        _ => Err(DecodeProblem::UnknownFormat),
    }
}

/// Reads exactly `count` bytes, taking memory only as they come: a short file that claims to be
/// large costs little.
pub(crate) fn read_bytes(source: &mut impl Read, count: usize) -> Result<Vec<u8>, DecodeProblem> {
    let mut bytes = Vec::new();
    let got = source.take(count as u64).read_to_end(&mut bytes)?;
    if got == count { Ok(bytes) } else { Err(std::io::Error::from(std::io::ErrorKind::UnexpectedEof).into()) }
}
