//! Text files that appear only when complete.

use std::path::Path;

use brt::{Target, image::Sink};

use crate::exit::Failure;
use crate::scene_input::is_dash;

/// A text file that is open, so that what cannot be written is known before the work is done.
pub(crate) struct TextFile(Box<dyn Sink>);

impl TextFile {
    /// Opens a file, or standard output if it is named `-`.
    pub(crate) fn open(path: &Path) -> Result<Self, Failure> {
        let target = if is_dash(path) { Target::Stdout } else { Target::File(path.to_owned()) };
        Ok(Self(target.open()?))
    }

    /// Writes all of it and puts it in place.
    pub(crate) fn write(mut self, text: &str) -> Result<(), Failure> {
        self.0.write_all(text.as_bytes())?;
        Ok(self.0.commit()?)
    }
}
