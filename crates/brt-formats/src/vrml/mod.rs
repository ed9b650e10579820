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

use crate::ParseError;
use crate::budget::Budget;
use crate::import::Draft;
use crate::load::Imported;

/// Reads a scene.
pub(crate) fn read<'b>(bytes: &'b [u8], budget: &'b Budget<'b>) -> Result<Imported, ParseError> {
    // KiCad's models stand on their boards: z is up there.
    let head = bytes.get(..200).unwrap_or(bytes).to_ascii_lowercase();
    let up = if head.windows(5).any(|word| word == b"kicad") { Up::PlusZ } else { Up::PlusY };
    let mut draft = Draft::new(budget, up);
    let read = syntax::parse(bytes, &mut draft).and_then(|nodes| build::build(&nodes, &mut draft));
    match read {
        Ok(()) => draft.finish(),
        Err(stop) => Err(draft.stopped(stop)),
    }
}
