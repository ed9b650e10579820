//! Neutral File Format (Haines, "A Proposal for Standard Graphics Environments", 1987).
//!
//! How its words become ours: `f r g b Kd Ks Shine T ior` gives diffuse = Kd, specular and reflection = Ks,
//! exponent = Shine, transmission = T; ambient is 0; transparent things cast no shadow. A light without colour is
//! white of √n/n for n lights. `hither` is ignored, as ray tracers do. Words may be spread over lines freely.

mod fill;
mod finish;
mod patches;
mod polygon;
mod reader;

use brt_scene::framing::Up;
use brt_scene::{CheckedScene, Diagnostic, Place, Report};

use super::sniff::{first_line, words};
use super::{FileReader, Importer, Likeness};
use crate::common::{Budget, Format, ParseError};
use crate::import::Beside;
use reader::Reader;

/// What there is to know of the format.
pub(super) const IMPORTER: Importer =
    Importer { format: Format::Nff, sniff, reader: FileReader::Scene { up: Up::PlusZ, read } };

/// A view stands alone; a vertex of OBJ has three numbers.
fn sniff(bytes: &[u8]) -> Likeness {
    const FIRST: [&[u8]; 8] = [b"b", b"l", b"f", b"s", b"c", b"p", b"pp", b"from"];
    let mut words = words(first_line(bytes));
    let first = words.next().unwrap_or_default();
    Likeness::Line.only_if(FIRST.contains(&first) || (first == b"v" && words.next().is_none()))
}

/// Reads a scene.
fn read<'b>(
    bytes: &'b [u8],
    _: &mut Beside<'b>,
    budget: &'b Budget<'b>,
) -> Result<(CheckedScene, Report), ParseError> {
    let mut reader = Reader::new(bytes, budget);
    reader.read_commands()?;
    let (scene, places, mut problems) = finish::finish(reader);
    // What is wrong with the file comes first: a scene that is only half read has faults that it has not.
    if problems.has_errors() {
        return Err(ParseError::Malformed(problems.into_report()));
    }
    match scene.checked() {
        Ok(scene) => Ok((scene, problems.into_report())),
        Err(found) => {
            for problem in found {
                let span = match problem.place {
                    Place::Scene(_) => places.size.clone(),
                    Place::Camera(_) => places.view.clone(),
                    Place::Light(i, _) => places.lights.get(i).cloned(),
                    Place::Material(i, _) => places.materials.get(i).cloned(),
                    Place::Object(i, _) => places.objects.get(i).cloned(),
                };
                problems.push(Diagnostic::error(problem.message, span).expecting(problem.expected));
            }
            Err(ParseError::Malformed(problems.into_report()))
        }
    }
}
