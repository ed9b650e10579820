//! What becomes of a file that was read.

use std::path::PathBuf;

use brt_scene::framing::Up;
use brt_scene::{CheckedScene, MaterialId, Report};

/// A scene that was made of bytes.
#[derive(Clone, Debug)]
pub struct Imported {
    /// The scene.
    pub scene: CheckedScene,
    /// Warnings; positions are offsets in the bytes.
    pub report: Report,
    /// What the file itself says about how it is looked at.
    pub given: Given,
    /// The other files that were read for it: buffers, materials, pictures, meshes.
    pub files: Vec<PathBuf>,
}

/// What a file says about how it is looked at; the rest was chosen by [`brt_scene::framing`] and may be chosen anew.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Given {
    /// Has it a camera?
    pub camera: bool,
    /// Has it lights?
    pub lights: bool,
    /// Has it a background?
    pub background: bool,
    /// The material of everything that the file gives no colour, if there is such a thing.
    pub plain: Option<MaterialId>,
    /// What is up, as its format or program has it.
    pub up: Up,
}

impl Given {
    /// A file that shows things and says nothing about how.
    pub(crate) fn nothing() -> Self {
        Self { camera: false, lights: false, background: false, plain: None, up: Up::PlusZ }
    }

    /// A file that says everything.
    pub(crate) fn everything(up: Up) -> Self {
        Self { camera: true, lights: true, background: true, plain: None, up }
    }
}
