//! How much a scene file may ask for.

use std::fmt;

use crate::LimitExceeded;

/// Bounds on what is read, so that a broken or hostile file ends in an error instead of an exhausted machine.
///
/// The defaults let scenes of millions of objects through; raise them for more.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Greatest size of the file, in bytes.
    pub bytes: u64,
    /// Greatest number of words and marks in a TOML file (numbers, names, commas, brackets, line ends). Each costs
    /// up to 100 bytes of memory while it is read.
    pub words: u64,
    /// Greatest number of primitives, every triangle of a mesh counted.
    pub objects: u64,
    /// Greatest number of points of all polygons and meshes together.
    pub points: u64,
    /// Greatest number of pixels that the file's picture size may ask for.
    pub max_picture_pixels: u64,
    /// Greatest number of pixels of all pictures on surfaces together; each takes 4 bytes of memory.
    pub texture_pixels: u64,
    /// May a file name others outside of its own folder? They are read as far as [`bytes`](Self::bytes) goes.
    pub files_outside: bool,
}

impl Limits {
    /// Default of [`bytes`](Self::bytes): 1 GiB.
    pub const DEFAULT_BYTES: u64 = 1 << 30;
    /// Default of [`words`](Self::words): a mesh of 8 million triangles, at most 10 GB of memory while it is read.
    pub const DEFAULT_WORDS: u64 = 100_000_000;
    /// Default of [`objects`](Self::objects).
    pub const DEFAULT_OBJECTS: u64 = 50_000_000;
    /// Default of [`points`](Self::points).
    pub const DEFAULT_POINTS: u64 = 100_000_000;
    /// Default of [`max_picture_pixels`](Self::max_picture_pixels): a picture of 131072 × 131072.
    pub const DEFAULT_PICTURE_PIXELS: u64 = 1 << 34;
    /// Default of [`texture_pixels`](Self::texture_pixels): 16 pictures of 4096 × 4096.
    pub const DEFAULT_TEXTURE_PIXELS: u64 = 1 << 28;
    /// Groups, nodes and components may nest this deep; no real file comes near it.
    pub(crate) const NESTING: usize = 64;

    pub(crate) fn allows(&self, kind: LimitKind, count: u64) -> Result<(), LimitExceeded> {
        let limit = match kind {
            LimitKind::Bytes => self.bytes,
            LimitKind::Words => self.words,
            LimitKind::Objects => self.objects,
            LimitKind::Points => self.points,
            LimitKind::PicturePixels => self.max_picture_pixels,
            LimitKind::TexturePixels => self.texture_pixels,
        };
        if count > limit { Err(LimitExceeded { what: kind, limit }) } else { Ok(()) }
    }
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            bytes: Self::DEFAULT_BYTES,
            words: Self::DEFAULT_WORDS,
            objects: Self::DEFAULT_OBJECTS,
            points: Self::DEFAULT_POINTS,
            max_picture_pixels: Self::DEFAULT_PICTURE_PIXELS,
            texture_pixels: Self::DEFAULT_TEXTURE_PIXELS,
            files_outside: false,
        }
    }
}

/// Which of the [`Limits`] was met.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LimitKind {
    /// [`Limits::bytes`]
    Bytes,
    /// [`Limits::words`]
    Words,
    /// [`Limits::objects`]
    Objects,
    /// [`Limits::points`]
    Points,
    /// [`Limits::max_picture_pixels`]
    PicturePixels,
    /// [`Limits::texture_pixels`]
    TexturePixels,
}

impl fmt::Display for LimitKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Bytes => "bytes in the file",
            Self::Words => "words and marks in the file",
            Self::Objects => "primitives",
            Self::Points => "points of polygons and meshes",
            Self::PicturePixels => "pixels in the picture",
            Self::TexturePixels => "pixels of pictures on surfaces",
        })
    }
}

/// Primitives and points counted while a file is read.
pub(crate) struct Counter {
    limits: Limits,
    objects: u64,
    points: u64,
}

impl Counter {
    pub(crate) fn new(limits: &Limits) -> Self {
        Self { limits: *limits, objects: 0, points: 0 }
    }

    pub(crate) fn objects(&mut self, count: usize) -> Result<(), LimitExceeded> {
        self.objects = self.objects.saturating_add(count as u64);
        self.limits.allows(LimitKind::Objects, self.objects)
    }

    pub(crate) fn points(&mut self, count: usize) -> Result<(), LimitExceeded> {
        self.points = self.points.saturating_add(count as u64);
        self.limits.allows(LimitKind::Points, self.points)
    }

    pub(crate) fn picture(&self, [width, height]: [u32; 2]) -> Result<(), LimitExceeded> {
        self.limits.allows(LimitKind::PicturePixels, u64::from(width) * u64::from(height))
    }
}
