//! Text files that appear only when complete.

use std::io::Write;
use std::path::Path;

use brt::Target;

use crate::exit::Failure;
use crate::scene_input::is_dash;

/// Writes text to a file, or to standard output if it is named `-`.
pub(crate) fn write(path: &Path, text: &str) -> Result<(), Failure> {
    let target = if is_dash(path) { Target::Stdout } else { Target::File(path.to_owned()) };
    let mut sink = target.open()?;
    sink.write_all(text.as_bytes())?;
    Ok(sink.commit()?)
}
