//! How much a scene file may ask for.

use std::sync::atomic::AtomicBool;

use super::machine;

/// Bounds on what is read, so that a broken or hostile file ends in an error instead of an exhausted machine.
///
/// Memory is counted while it is reserved, with what rendering will need for each primitive: a file that asks for too much
/// ends before it has it.
#[derive(Clone, Copy, Debug)]
pub struct Limits<'c> {
    /// Greatest memory for the scene, in bytes: files, pictures, meshes, their uses, and what is prepared of them. No
    /// single file may be larger than an eighth of it, since no format's content is smaller than that in memory.
    pub memory: u64,
    /// May a small file need much memory? If not, what needs more than 512 MiB may need 10,000 times the bytes that were
    /// read, and an entry of a zip file may unpack to 16 MiB or 100 times its size. Models that people make stay far below
    /// (STL 15 times, 3MF 60 times, its entries unpack to 20 times their size).
    pub any_expansion: bool,
    /// Greatest number of pixels that the file's picture size may ask for.
    pub max_picture_pixels: u64,
    /// May a file name others outside of its own folder?
    pub files_outside: bool,
    /// Reading ends soon after this becomes true. `None`: never.
    pub cancel: Option<&'c AtomicBool>,
}

impl Limits<'_> {
    /// Most that the default of [`memory`](Self::memory) is: 8 GiB.
    pub const GREATEST_DEFAULT_MEMORY: u64 = 8 << 30;
    /// Default of [`max_picture_pixels`](Self::max_picture_pixels): a picture of 131072 × 131072.
    pub const DEFAULT_PICTURE_PIXELS: u64 = 1 << 34;
    /// Groups, nodes and components may nest this deep; no real file comes near it.
    pub(crate) const NESTING: usize = 64;

    /// Greatest size of a file, in bytes: an eighth of [`memory`](Self::memory).
    pub fn file_bytes(&self) -> u64 {
        self.memory / 8
    }
}

impl Default for Limits<'_> {
    /// Half of the memory that this process may have, at most [`GREATEST_DEFAULT_MEMORY`](Self::GREATEST_DEFAULT_MEMORY).
    fn default() -> Self {
        Self {
            memory: (machine::memory() / 2).min(Self::GREATEST_DEFAULT_MEMORY),
            any_expansion: false,
            max_picture_pixels: Self::DEFAULT_PICTURE_PIXELS,
            files_outside: false,
            cancel: None,
        }
    }
}
