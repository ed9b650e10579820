//! 3D Manufacturing Format: a zip file with an XML model.
//!
//! Objects, components, transforms, base materials and colour groups (sRGB) are read; the colours of a triangle's corners
//! are mixed across it. +z is up.

mod build;
mod package;
mod xml;

use brt_scene::framing::Up;

use crate::import::Draft;
use crate::load::Imported;
use crate::{Limits, ParseError};

/// Reads a scene.
pub(crate) fn read(bytes: &[u8], limits: &Limits) -> Result<Imported, ParseError> {
    let mut draft = Draft::new(limits, Up::PlusZ);
    let read = package::model_part(bytes, limits).and_then(|part| {
        let model = xml::read(&part, &mut draft)?;
        build::build(&model, &mut draft)
    });
    match read {
        Ok(()) => draft.finish(),
        Err(stop) => Err(draft.stopped(stop)),
    }
}
