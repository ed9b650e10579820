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

use brt_scene::{CheckedScene, Diagnostic, Place, Report};

use crate::ParseError;
use crate::budget::Budget;
use reader::Reader;

/// Reads a scene.
pub(crate) fn read(bytes: &[u8], budget: &Budget) -> Result<(CheckedScene, Report), ParseError> {
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
