//! Where a picture goes.

use std::path::{Path, PathBuf};

use brt_image::{Encoding, PictureFormat, Target};
use thiserror::Error;

use crate::layers::PictureLayer;

/// Where a picture goes, and how it is stored.
#[derive(Clone, Debug, PartialEq)]
pub struct Output {
    /// The picture's file, or standard output; `None` if it is not kept: for timing and checking.
    pub target: Option<Target>,
    /// Format, depth and transfer function.
    pub encoding: Encoding,
    /// Layers that are written too: inside the file if it is EXR, else as `out.depth.png` beside `out.png`.
    pub layers: Vec<PictureLayer>,
}

/// Why a picture cannot be written where it was asked for.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum OutputError {
    /// The file's extension names no format that is written.
    #[error("{}: not the name of a picture that can be written, expected `.png`, `.ppm` or `.exr`", path.display())]
    UnknownExtension {
        /// The file asked for.
        path: PathBuf,
    },
}

impl Output {
    /// A picture in the format that the path's extension names: 8 bits, sRGB, no layers.
    ///
    /// # Errors
    /// If the extension names no format.
    pub fn to_file(path: &Path) -> Result<Self, OutputError> {
        let format = PictureFormat::from_path(path)
            .ok_or_else(|| OutputError::UnknownExtension { path: path.to_owned() })?;
        let encoding = Encoding { format, ..Encoding::default() };
        Ok(Self { target: Some(Target::File(path.to_owned())), encoding, layers: Vec::new() })
    }

    /// A PNG on standard output: 8 bits, sRGB, no layers.
    pub fn to_stdout() -> Self {
        Self { target: Some(Target::Stdout), encoding: Encoding::default(), layers: Vec::new() }
    }

    /// A picture that is not kept: 8 bits, sRGB, no layers.
    pub fn nowhere() -> Self {
        Self { target: None, encoding: Encoding::default(), layers: Vec::new() }
    }

    /// All files that are written, the picture first.
    pub fn files(&self) -> Vec<PathBuf> {
        let Some(Target::File(path)) = &self.target else { return Vec::new() };
        let mut files = vec![path.clone()];
        if self.encoding.format != PictureFormat::Exr {
            files.extend(self.layers.iter().map(|&layer| layer_path(path, layer)));
        }
        files
    }
}

/// `a/out.png` becomes `a/out.depth.png`.
pub(crate) fn layer_path(picture: &Path, layer: PictureLayer) -> PathBuf {
    let extension = picture.extension().unwrap_or_default().to_string_lossy();
    picture.with_extension(format!("{}.{extension}", layer.name()))
}
