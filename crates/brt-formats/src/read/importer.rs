//! What there is to know of a format that is read.

use brt_scene::framing::Up;
use brt_scene::{CheckedScene, Diagnostic, Report};

use super::{IMPORTERS, Likeness};
use crate::common::{Budget, Format, ParseError};
use crate::import::{Beside, Draft, Given, Imported, Stop};

/// One format that is read.
pub(crate) struct Importer {
    pub(crate) format: Format,
    /// How much a file, without a byte order mark, looks like one of its own.
    pub(crate) sniff: fn(&[u8]) -> Likeness,
    pub(crate) reader: FileReader,
}

/// What a file of a format holds, and how it is read.
pub(crate) enum FileReader {
    /// A whole scene, with its camera and its lights.
    Scene { up: Up, read: ReadScene },
    /// Things to be looked at.
    Model {
        /// What is up in this file.
        up: fn(&[u8]) -> Up,
        read: ReadModel,
        /// May scenes of other formats have its meshes?
        is_for_scenes: bool,
    },
}

type ReadScene =
    for<'b> fn(&'b [u8], &mut Beside<'b>, &'b Budget<'b>) -> Result<(CheckedScene, Report), ParseError>;

type ReadModel = for<'b> fn(&'b [u8], &mut Beside<'b>, &mut Draft<'b>) -> Result<(), Stop>;

impl Importer {
    /// That of a format, if it is read.
    pub(crate) fn of(format: Format) -> Option<&'static Self> {
        IMPORTERS.iter().copied().find(|importer| importer.format == format)
    }
}

impl Format {
    /// Can it be read?
    pub fn reads(self) -> bool {
        Importer::of(self).is_some()
    }
}

/// Refuses a file that holds nothing.
pub(crate) fn check_content(bytes: &[u8]) -> Result<(), ParseError> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    if !bytes.trim_ascii().is_empty() {
        return Ok(());
    }
    Err(ParseError::Malformed(Report { diagnostics: vec![Diagnostic::error("the file is empty", None)] }))
}

/// Reads a file of a format.
pub(crate) fn read<'b>(
    format: Format,
    bytes: &'b [u8],
    beside: &mut Beside<'b>,
    budget: &'b Budget<'b>,
) -> Result<Imported, ParseError> {
    check_content(bytes)?;
    match Importer::of(format).map(|importer| &importer.reader) {
        None if format.is_only_written() => Err(ParseError::OnlyWritten(format)),
        None => Err(ParseError::LeftOut(format)),
        Some(FileReader::Scene { up, read }) => {
            let (scene, report) = read(bytes, beside, budget)?;
            Ok(Imported { scene, report, given: Given::everything(*up), files: Vec::new() })
        }
        Some(FileReader::Model { up, read, .. }) => {
            let mut draft = Draft::new(budget, up(bytes));
            match read(bytes, beside, &mut draft) {
                Ok(()) => draft.finish(),
                Err(stop) => Err(draft.stopped(stop)),
            }
        }
    }
}
