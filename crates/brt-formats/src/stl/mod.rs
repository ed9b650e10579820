//! STL: triangles without anything else (3D Systems 1989).
//!
//! Stored normals are not used: many programs write zeros or leave them wrong, and the order of the points says the
//! same. +z is up. Points at the same place are one point, and faces that meet at a small angle become smooth.

mod ascii;
mod binary;

use brt_scene::framing::Up;

use crate::ParseError;
use crate::budget::Budget;
use crate::import::{CREASE_DEG, Crease, Draft, Geometry, Stop, Weld};
use crate::load::Imported;

pub(crate) use binary::is_binary;

/// Reads a scene.
pub(crate) fn read(bytes: &[u8], budget: &Budget) -> Result<Imported, ParseError> {
    let mut draft = Draft::new(budget, Up::PlusZ);
    match read_file(bytes, &mut draft) {
        Ok(()) => draft.finish(),
        Err(stop) => Err(draft.stopped(stop)),
    }
}

/// Reads a file into a model.
pub(crate) fn read_file(bytes: &[u8], draft: &mut Draft) -> Result<(), Stop> {
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
