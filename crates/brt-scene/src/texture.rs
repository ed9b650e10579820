//! Pictures laid on meshes.

use std::sync::Arc;

/// A picture that a material's colour is multiplied with, laid on meshes by the texture coordinates of their points.
///
/// Coordinates (0, 0) are the picture's upper left corner, (1, 1) its lower right one. On whatever has none the picture
/// is not seen.
#[derive(Clone, Debug, PartialEq)]
pub struct Texture {
    /// The picture; materials may share it.
    pub picture: Arc<Texels>,
    /// Where coordinates (u, v) lie in the picture: at `(m[0]·(u, v, 1), m[1]·(u, v, 1))`.
    pub transform: [[f64; 3]; 2],
    /// What lies beyond the picture's left and right, and beyond its top and bottom.
    pub wrap: [Wrap; 2],
    /// What is seen between the middles of texels.
    pub filter: TextureFilter,
    /// What the picture's alpha is for.
    pub alpha: TextureAlpha,
}

impl Texture {
    /// Coordinates that are the picture's own.
    pub const PLAIN: [[f64; 3]; 2] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

    /// A picture as it is: repeated, filtered, its alpha ignored.
    pub fn new(picture: Arc<Texels>) -> Self {
        Self {
            picture,
            transform: Self::PLAIN,
            wrap: [Wrap::Repeat; 2],
            filter: TextureFilter::Linear,
            alpha: TextureAlpha::Ignored,
        }
    }
}

/// A decoded picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Texels {
    /// The file that it comes from, as the scene's file names it; for messages, and for files that name it again.
    pub name: String,
    /// Texels in a row, at least 1.
    pub width: u32,
    /// Rows, at least 1.
    pub height: u32,
    /// Red, green and blue as sRGB stores them, and alpha, row after row from the top.
    pub rgba: Vec<[u8; 4]>,
}

/// What lies beyond a picture's edge.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Wrap {
    /// The picture again.
    #[default]
    Repeat,
    /// The picture mirrored, then again.
    Mirror,
    /// The texels of the edge.
    Clamp,
}

/// What is seen between the middles of texels.
///
/// Small pictures of large textures are smoothed by the samples of their pixels and by nothing else.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TextureFilter {
    /// The nearest texel: sharp squares.
    Nearest,
    /// Four texels, mixed in linear light.
    #[default]
    Linear,
}

/// What a picture's alpha is for.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum TextureAlpha {
    /// For nothing.
    #[default]
    Ignored,
    /// The material's opacity is multiplied with it.
    Blend,
    /// Nothing is there where it is below this, in [0, 1]; all that the material's opacity says elsewhere.
    Mask(f64),
}
