//! Meshes of files, for scenes that import them: geometry without materials.

use std::path::Path;
use std::sync::Arc;

use brt_scene::{Mesh, Report};

use crate::budget::Budget;
use crate::import::{Beside, Draft};
use crate::load::format_of;
use crate::{Format, obj, off, ply, stl};

/// Meshes, and what was not understood.
pub(crate) struct Meshes {
    pub(crate) meshes: Vec<Arc<Mesh>>,
    pub(crate) report: Report,
}

/// Reads the meshes of a file: one, or several where parts of it are smooth and others flat. The error fits behind the
/// file's name.
pub(crate) fn read<'b>(name: &str, bytes: &'b [u8], budget: &'b Budget<'b>) -> Result<Meshes, String> {
    let mut draft = Draft::bare(budget);
    // Materials are not wanted, so no further files are.
    let mut nothing = Beside::new(None, budget);
    let read = match format_of(Path::new(name), bytes) {
        Some(Format::Ply) => ply::read_file(bytes, &mut nothing, &mut draft),
        Some(Format::Stl) => stl::read_file(bytes, &mut draft),
        Some(Format::Off) => off::read_file(bytes, &mut draft),
        Some(Format::Obj) => obj::read_file(bytes, &mut nothing, &mut draft),
        Some(other) => return Err(format!("it is a {}", other.name())),
        None => return Err("its format is not known".to_owned()),
    };
    match read {
        Ok(()) => Ok(draft.into_meshes()),
        Err(stop) => Err(draft.stopped(stop).to_string()),
    }
}
