//! Wavefront OBJ with its materials.
//!
//! Not by a library: those that are kept (`tobj`) leave out smoothing groups and know no lines of errors. Faces of one
//! object, group and material are one mesh. Where the file gives no normals, its smoothing groups decide what is
//! smooth, and where it has none of those either, the angle. +y is up.

mod face;
mod map;
mod material;
mod reader;

use brt_scene::framing::Up;

use crate::ParseError;
use crate::budget::Budget;
use crate::import::{Beside, Draft};
use crate::load::Imported;
pub(crate) use reader::read as read_file;

/// Reads a scene.
pub(crate) fn read<'b>(
    bytes: &'b [u8],
    beside: &mut Beside<'b>,
    budget: &'b Budget<'b>,
) -> Result<Imported, ParseError> {
    let mut draft = Draft::new(budget, Up::PlusY);
    match read_file(bytes, beside, &mut draft) {
        Ok(()) => draft.finish(),
        Err(stop) => Err(draft.stopped(stop)),
    }
}
