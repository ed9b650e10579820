//! Which format a file is of.

use std::path::Path;

use super::{FileReader, IMPORTERS, Importer};
use crate::common::{Foreign, Format};

/// How much a file looks like one of a format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Likeness {
    None,
    /// Its first line that is neither blank nor a comment could be of it.
    Line,
    /// It begins as files of the format do, and as text of other formats may.
    Start,
    /// It begins as nothing else does.
    Mark,
}

impl Format {
    /// The format that content looks like: by what the format demands at its start, else by the first line that is
    /// neither blank nor a comment.
    pub fn from_content(bytes: &[u8]) -> Option<Self> {
        likest(bytes).map(|(format, _)| format)
    }
}

/// The first format that content looks like most.
fn likest(bytes: &[u8]) -> Option<(Format, Likeness)> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let all = IMPORTERS.iter().rev().map(|importer| (importer.format, (importer.sniff)(bytes)));
    all.filter(|(_, likeness)| *likeness > Likeness::None).max_by_key(|(_, likeness)| *likeness)
}

/// The format that content is surely of.
pub(crate) fn sure_format(bytes: &[u8]) -> Option<Format> {
    likest(bytes).filter(|(_, likeness)| *likeness == Likeness::Mark).map(|(format, _)| format)
}

/// A model's name is often wrong (`.obj` for anything), so what is sure by content comes first; text that could be
/// anything is what its name says.
pub(crate) fn format_of(path: &Path, bytes: &[u8]) -> Option<Format> {
    match Format::from_path(path) {
        // Scenes are read as what they are called: their errors are better than a guess.
        Some(named) if is_scene(named) => Some(named),
        Some(named) => sure_format(bytes).or(Some(named)),
        // Many formats are zip files: there the name is surer.
        None if Foreign::of(path, bytes).is_some() => {
            sure_format(bytes).filter(|format| *format != Format::ThreeMf)
        }
        None => Format::from_content(bytes),
    }
}

/// Are files of a format whole scenes?
fn is_scene(format: Format) -> bool {
    Importer::of(format).is_some_and(|importer| matches!(importer.reader, FileReader::Scene { .. }))
}

/// What comes after white space.
pub(super) fn text(bytes: &[u8]) -> &[u8] {
    bytes.trim_ascii_start()
}

/// The first line that says something; empty if none does.
pub(super) fn first_line(bytes: &[u8]) -> &[u8] {
    let mut lines = bytes.split(|&b| b == b'\n' || b == b'\r').map(<[u8]>::trim_ascii);
    lines.find(|line| !line.is_empty() && !line.starts_with(b"#")).unwrap_or_default()
}

/// Its words.
pub(super) fn words(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty())
}

impl Likeness {
    /// This, if it is so.
    pub(super) fn only_if(self, is_so: bool) -> Self {
        if is_so { self } else { Self::None }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn content_is_told_by_its_first_line() {
        assert_eq!(Format::from_content(b"# x\n\n size = [1, 2]"), Some(Format::Toml));
        assert_eq!(Format::from_content(b"# x\r\n[camera]"), Some(Format::Toml));
        assert_eq!(Format::from_content(b"#x\nb 1 2 3"), Some(Format::Nff));
        assert_eq!(Format::from_content(b"v\nfrom 1 2 3"), Some(Format::Nff));
        assert_eq!(Format::from_content(b"# x\nv 1 2 3"), Some(Format::Obj));
        assert_eq!(Format::from_content(b"mtllib a.mtl"), Some(Format::Obj));
        assert_eq!(Format::from_content(b"solid cube"), Some(Format::Stl));
        assert_eq!(Format::from_content(b"#VRML V2.0 utf8"), Some(Format::Vrml));
        assert_eq!(Format::from_content(b"{ \"asset\": {} }"), Some(Format::Gltf));
        assert_eq!(Format::from_content(b"{ \"chemicalJson\": 1 }"), None);
        assert_eq!(Format::from_content(b"ply\nformat ascii 1.0"), Some(Format::Ply));
        assert_eq!(Format::from_content(b"\xef\xbb\xbfply\nformat ascii 1.0"), Some(Format::Ply));
        assert_eq!(Format::from_content(b""), None);
        assert_eq!(Format::from_content(b"hello"), None);
        assert_eq!(Format::from_content(&[0; 100]), None);
    }

    #[test]
    fn what_is_sure_by_content_overrules_the_name_of_a_model() {
        let of = |name: &str, bytes: &[u8]| format_of(Path::new(name), bytes);
        assert_eq!(of("a.obj", b"ply\nformat"), Some(Format::Ply));
        assert_eq!(of("a.off", b"PK\x03\x04"), Some(Format::ThreeMf));
        assert_eq!(of("a.ply", b"solid a"), Some(Format::Ply));
        assert_eq!(of("a.toml", b"ply\nformat"), Some(Format::Toml));
        assert_eq!(of("a", b"glTF"), Some(Format::Gltf));
        assert_eq!(of("a.step", b"solid a"), None);
        assert_eq!(of("a.fcstd", b"PK\x03\x04"), None);
        let mut binary = vec![0; 134];
        binary[80] = 1;
        for name in ["a.obj", "a.ply", "a.step", "a.pov", "a"] {
            assert_eq!(of(name, &binary), Some(Format::Stl), "{name}");
        }
        assert_eq!(of("a.toml", &binary), Some(Format::Toml));
        assert_eq!(of("a.obj", &binary[1..]), Some(Format::Obj));
    }
}
