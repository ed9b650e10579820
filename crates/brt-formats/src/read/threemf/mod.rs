//! 3D Manufacturing Format: a zip file with an XML model.
//!
//! Objects, components, transforms, base materials and colour groups (sRGB) are read; the colours of a triangle's corners
//! are mixed across it. +z is up.

mod build;
mod package;
mod xml;

use brt_scene::framing::Up;

use super::{FileReader, Importer, Likeness};
use crate::common::Format;
use crate::import::{Beside, Draft, Stop};

/// What there is to know of the format.
pub(super) const IMPORTER: Importer = Importer {
    format: Format::ThreeMf,
    sniff: |bytes| Likeness::Mark.only_if(bytes.starts_with(b"PK\x03\x04")),
    reader: FileReader::Model { up: |_| Up::PlusZ, read, is_for_scenes: false },
};

/// Reads a file into a model.
fn read<'b>(bytes: &'b [u8], _: &mut Beside<'b>, draft: &mut Draft<'b>) -> Result<(), Stop> {
    let model = package::read_model(bytes, draft.budget, |part| xml::read(part, draft))?;
    build::build(&model, draft)
}
