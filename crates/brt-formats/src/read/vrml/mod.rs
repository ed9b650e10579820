//! VRML97 as KiCad, PyMOL and CAD programs write it.
//!
//! Read: groups and transforms, DEF and USE, shapes (sets of faces, spheres, cylinders, cones, boxes), materials with
//! sRGB colours, colours per point and per face, viewpoints. Scripts, prototypes, lines, textures and lights are ignored
//! and reported. +y is up, but +z in KiCad's.

mod build;
mod faces;
mod shape;
mod syntax;

use brt_scene::framing::Up;

use super::sniff::text;
use super::{FileReader, Importer, Likeness};
use crate::common::Format;
use crate::import::{Beside, Draft, Stop};

/// What there is to know of the format.
pub(super) const IMPORTER: Importer = Importer {
    format: Format::Vrml,
    sniff: |bytes| Likeness::Mark.only_if(text(bytes).starts_with(b"#VRML")),
    reader: FileReader::Model { up, read, is_for_scenes: false },
};

/// KiCad's models stand on their boards: z is up there.
fn up(bytes: &[u8]) -> Up {
    let head = bytes.get(..200).unwrap_or(bytes).to_ascii_lowercase();
    if head.windows(5).any(|word| word == b"kicad") { Up::PlusZ } else { Up::PlusY }
}

/// Reads a file into a model.
fn read<'b>(bytes: &'b [u8], _: &mut Beside<'b>, draft: &mut Draft<'b>) -> Result<(), Stop> {
    let nodes = syntax::parse(bytes, draft)?;
    build::build(&nodes, draft)
}
