//! Our own scene format (`docs/scene-format.md`).
//!
//! The file is parsed to a tree of values with positions, which a small typed reader walks. Nesting is bounded by
//! the `toml` crate (80 levels).

mod fields;
mod files;
mod light;
mod material;
mod mesh;
mod scene;
mod shape;
mod texture;
mod unseen;
mod value;

use brt_scene::framing::Up;
use brt_scene::{CheckedScene, Diagnostic, Report};
use toml::de::DeTable;

use super::sniff::first_line;
use super::{FileReader, Importer, Likeness};
use crate::common::{Budget, Cost, Format, ParseError, Problems};
use crate::import::Beside;

use files::Files;

/// What there is to know of the format.
pub(super) const IMPORTER: Importer =
    Importer { format: Format::Toml, sniff, reader: FileReader::Scene { up: Up::PlusY, read } };

/// A table, or a field.
fn sniff(bytes: &[u8]) -> Likeness {
    let line = first_line(bytes);
    Likeness::Line.only_if(line.starts_with(b"[") || line.contains(&b'='))
}

/// Reads a scene.
fn read<'b>(
    bytes: &'b [u8],
    beside: &mut Beside<'b>,
    budget: &'b Budget<'b>,
) -> Result<(CheckedScene, Report), ParseError> {
    let text =
        std::str::from_utf8(bytes).map_err(|error| ParseError::NotUtf8 { position: error.valid_up_to() })?;
    budget.spend(Cost::Word, most_words(bytes))?;
    let mut problems = Problems::default();
    let root = match DeTable::parse(text) {
        Ok(root) => root,
        Err(error) => {
            problems.push(syntax_error(&error));
            return Err(ParseError::Malformed(problems.into_report()));
        }
    };
    let mut files = Files::new(beside, budget);
    let scene::Read { scene, places } = scene::read_scene(root.get_ref(), &mut files, budget, &mut problems)?;
    let checked = scene.checked();
    for problem in checked.as_ref().err().into_iter().flatten() {
        let span = places.span(problem.place);
        problems.push(Diagnostic::error(problem.message.clone(), span).expecting(problem.expected));
    }
    match checked {
        Ok(scene) if !problems.has_errors() => {
            unseen::note_textures(&scene, &places, &mut problems);
            Ok((scene, problems.into_report()))
        }
        _ => Err(ParseError::Malformed(problems.into_report())),
    }
}

/// An upper bound on the number of tokens: the tree of values costs memory for each of them.
fn most_words(bytes: &[u8]) -> u64 {
    #[derive(Clone, Copy, PartialEq)]
    enum Kind {
        Word,
        Blank,
        Mark,
    }
    let kind = |byte: u8| match byte {
        b' ' | b'\t' => Kind::Blank,
        b'_' | b'-' | b'+' | 0x80.. => Kind::Word,
        _ if byte.is_ascii_alphanumeric() => Kind::Word,
        _ => Kind::Mark,
    };
    let mut previous = Kind::Mark;
    let mut count = 0;
    for &byte in bytes {
        let kind = kind(byte);
        // Words and blanks count once a run, every mark by itself.
        count += u64::from(kind == Kind::Mark || kind != previous);
        previous = kind;
    }
    count
}

fn syntax_error(error: &toml::de::Error) -> Diagnostic {
    let message = match error.message().split_once(", expected ") {
        Some((message, expected)) => {
            return Diagnostic::error(message, error.span()).expecting(expected);
        }
        None => error.message(),
    };
    Diagnostic::error(message, error.span())
}
