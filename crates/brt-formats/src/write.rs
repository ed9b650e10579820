//! From a scene to the text of a file.

use brt_scene::{Report, Scene};

use crate::{Format, OnlyRead, dat, pov, write_toml};

/// The text of a scene file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Written {
    /// All of the file.
    pub text: String,
    /// What the format cannot express and was replaced or left out.
    pub report: Report,
}

/// Writes a scene that passed [`Scene::check`]. Formats of other programs get the scene's picture size, or 1024×1024.
///
/// # Errors
/// If the format can only be read.
pub fn write(format: Format, scene: &Scene) -> Result<Written, OnlyRead> {
    match format {
        Format::Toml => Ok(Written { text: write_toml(scene), report: Report::default() }),
        Format::Pov => Ok(pov::write(scene)),
        Format::Dat => Ok(dat::write(scene)),
        _ => Err(OnlyRead(format)),
    }
}
