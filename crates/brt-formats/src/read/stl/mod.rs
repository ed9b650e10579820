//! STL: triangles without anything else (3D Systems 1989).
//!
//! Stored normals are not used: many programs write zeros or leave them wrong, and the order of the points says the
//! same. +z is up. Points at the same place are one point, and faces that meet at a small angle become smooth.

mod ascii;
mod binary;

use brt_scene::framing::Up;

use super::sniff::text;
use super::{FileReader, Importer, Likeness};
use crate::common::Format;
use crate::import::{Beside, CREASE_DEG, Crease, Draft, Geometry, Stop, Weld};

use binary::is_binary;

/// What there is to know of the format.
pub(super) const IMPORTER: Importer = Importer {
    format: Format::Stl,
    sniff: |bytes| {
        // No text has this size: a count of letters is that of more than half a billion triangles.
        let binary = Likeness::Mark.only_if(is_binary(bytes));
        binary.max(Likeness::Start.only_if(text(bytes).starts_with(b"solid")))
    },
    reader: FileReader::Model { up: |_| Up::PlusZ, read, is_for_scenes: true },
};

/// Reads a file into a model.
fn read<'b>(bytes: &'b [u8], _: &mut Beside<'b>, draft: &mut Draft<'b>) -> Result<(), Stop> {
    if is_text(bytes) { ascii::read(bytes, draft) } else { binary::read(bytes, draft) }
}

/// Binary files may begin with `solid`, too: their size tells.
fn is_text(bytes: &[u8]) -> bool {
    bytes.trim_ascii_start().starts_with(b"solid") && !is_binary(bytes)
}

/// Triangles of one solid under construction.
#[derive(Default)]
struct Solid {
    name: Option<String>,
    weld: Weld,
    triangles: Vec<[u32; 3]>,
}

impl Solid {
    fn add_to(self, draft: &mut Draft) -> Result<(), Stop> {
        let Self { name, weld: Weld { positions, .. }, triangles } = self;
        let geometry = Geometry { positions, triangles, ..Geometry::default() };
        let material = draft.plain();
        Ok(draft.add_geometry(geometry, Some(&Crease::new(CREASE_DEG)), material, name.as_deref())?)
    }
}
