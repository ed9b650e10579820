//! Meshes of files, for scenes that import them: geometry without materials.

use std::path::Path;

use super::{FileReader, Importer, check_content, format_of};
use crate::common::Budget;
use crate::import::{Beside, Draft, Meshes};

/// Reads the meshes of a file: one, or several where parts of it are smooth and others flat. The error fits behind the
/// file's name.
pub(super) fn read<'b>(name: &str, bytes: &'b [u8], budget: &'b Budget<'b>) -> Result<Meshes, String> {
    check_content(bytes).map_err(|error| error.to_string())?;
    let format = format_of(Path::new(name), bytes).ok_or("its format is not known")?;
    let Some(Importer { reader: FileReader::Model { read, is_for_scenes: true, .. }, .. }) =
        Importer::of(format)
    else {
        return Err(format!("it is a {}", format.name()));
    };
    let mut draft = Draft::bare(budget);
    // Materials are not wanted, so no further files are.
    match read(bytes, &mut Beside::new(None, budget), &mut draft) {
        Ok(()) => Ok(draft.into_meshes()),
        Err(stop) => Err(draft.stopped(stop).to_string()),
    }
}
