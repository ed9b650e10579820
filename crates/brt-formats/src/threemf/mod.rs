//! 3D Manufacturing Format: a zip file with an XML model.
//!
//! Objects, components, transforms, base materials and colour groups (sRGB) are read; the colours of a triangle's corners
//! are mixed across it. +z is up.

mod build;
mod package;
mod xml;

use brt_scene::framing::Up;

use crate::ParseError;
use crate::budget::Budget;
use crate::import::Draft;
use crate::load::Imported;

/// Reads a scene.
pub(crate) fn read(bytes: &[u8], budget: &Budget) -> Result<Imported, ParseError> {
    let mut draft = Draft::new(budget, Up::PlusZ);
    let read = package::read_model(bytes, budget, |part| xml::read(part, &mut draft))
        .and_then(|model| build::build(&model, &mut draft));
    match read {
        Ok(()) => draft.finish(),
        Err(stop) => Err(draft.stopped(stop)),
    }
}
