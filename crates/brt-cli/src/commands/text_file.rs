//! Text files that appear only when complete.

use std::path::Path;

use brt::image::Sink;
use brt::{FileSet, Target};

use crate::exit::Failure;
use crate::output;
use crate::scene_input::is_dash;

/// Opens a file of a set, or standard output if it is named `-`, so that what cannot be written is known before the work
/// is done.
pub(crate) fn open(path: &Path, files: &FileSet) -> Result<Box<dyn Sink>, Failure> {
    if !is_dash(path) {
        return Ok(files.open(&Target::File(path.to_owned()))?);
    }
    check_stdout()?;
    Ok(files.open(&Target::Stdout)?)
}

/// Refuses to write to a standard output that is not there.
pub(crate) fn check_stdout() -> Result<(), Failure> {
    output::check_open().map_err(|error| Failure::CouldNot {
        error: error.into(),
        hint: Some("to throw it away, `> /dev/null`".to_owned()),
    })
}

/// Writes all of a file and completes it.
pub(crate) fn write(mut file: Box<dyn Sink>, text: &str) -> Result<(), Failure> {
    file.write_all(text.as_bytes()).and_then(|()| file.commit()).map_err(Failure::of_writing)
}
