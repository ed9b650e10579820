//! From a scene to the text of a file, and what lies beside it.

mod dat;
mod losses;
mod numerals;
mod ply;
mod pov;
mod toml;
mod view;

use std::borrow::Cow;
use std::cell::RefCell;
use std::path::Path;

use brt_scene::{Report, Scene, Texels};

use crate::common::{Budget, Format, Limits, OnlyRead};
use crate::import::{Beside, Pictures};

pub use toml::write_toml;

/// The text of a scene file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Written {
    /// All of the file.
    pub text: String,
    /// Files that the text names and that belong beside it.
    pub files: Vec<FileBeside>,
    /// What the format cannot express and was replaced or left out.
    pub report: Report,
}

/// A file beside a scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FileBeside {
    /// Its name in the scene's folder.
    pub name: String,
    /// Its content.
    pub bytes: Vec<u8>,
}

impl Format {
    /// Can it be written?
    pub fn writes(self) -> bool {
        matches!(self, Self::Toml | Self::Pov | Self::Dat)
    }
}

/// Writes a scene that passed [`Scene::check`] as one text. Formats of other programs get the scene's picture size, or
/// 1024×1024.
///
/// # Errors
/// If the format can only be read.
pub fn write(format: Format, scene: &Scene) -> Result<Written, OnlyRead> {
    match format {
        Format::Toml => Ok(alone(write_toml(scene), Report::default())),
        Format::Pov => Ok(pov::write(scene)),
        Format::Dat => Ok(dat::write(scene)),
        _ => Err(OnlyRead(format)),
    }
}

/// Writes a scene as [`write()`] does, for a path: in our own format large meshes and pictures become files beside it,
/// whose names start with that of the scene. A picture that lies in the folder already is only named.
///
/// Nothing is written to disk.
///
/// # Errors
/// If the format can only be read.
pub fn write_beside(format: Format, scene: &Scene, path: &Path) -> Result<Written, OnlyRead> {
    if format != Format::Toml {
        return write(format, scene);
    }
    let stem = path.file_stem().map_or_else(|| "scene".into(), |stem| stem.to_string_lossy());
    let folder =
        path.parent().map(|folder| if folder.as_os_str().is_empty() { Path::new(".") } else { folder });
    let budget = Budget::new(&Limits::default());
    let found = RefCell::new((Beside::new(folder, &budget), Pictures::new(&budget)));
    let lies_there = |texels: &Texels| {
        let (beside, pictures) = &mut *found.borrow_mut();
        let there = pictures.get(&texels.name, || beside.read(&texels.name).map(Cow::Owned));
        there.is_ok_and(|there| *there == *texels)
    };
    let (text, files) = toml::write_beside(scene, &stem, &lies_there);
    Ok(Written { text, files, report: Report::default() })
}

/// A text that needs no other files.
fn alone(text: String, report: Report) -> Written {
    Written { text, files: Vec::new(), report }
}
