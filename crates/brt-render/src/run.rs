//! How it is rendered: nothing here changes a byte of the picture.

use std::io;
use std::ops::Deref;
use std::sync::atomic::{AtomicBool, Ordering};

use brt_geometry::SimdLevel;
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::settings::Window;

/// How the work is done.
#[derive(Clone, Copy, Default)]
pub struct Run<'a> {
    /// Number of threads; 0 for one per processor.
    pub threads: usize,
    /// Threads that are there already, whose number counts then. [`thread_pool`] starts some that fit.
    pub pool: Option<&'a ThreadPool>,
    /// Hears how much is done.
    pub progress: Option<&'a (dyn Progress + 'a)>,
    /// Stops the work when set.
    pub cancel: Option<&'a AtomicBool>,
    /// In which order tiles of a band are begun; for tests that it does not matter.
    pub order: TileOrder,
    /// How `full` follows rays.
    pub rays: RayOrder,
    /// Vector instructions to use; where the machine lacks them, the next lower ones.
    pub simd: SimdLevel,
}

/// Bytes of a thread's stack: a thousand bounces nest, and each takes about 2 KiB.
const STACK: usize = 16 << 20;

/// Threads with the stacks that deep ray trees need; 0: one per processor.
///
/// # Errors
/// If the machine has no more threads to give.
pub fn thread_pool(threads: usize) -> io::Result<ThreadPool> {
    ThreadPoolBuilder::new().num_threads(threads).stack_size(STACK).build().map_err(io::Error::other)
}

/// Threads to work on.
pub(crate) enum Pool<'a> {
    Own(ThreadPool),
    Lent(&'a ThreadPool),
}

impl Deref for Pool<'_> {
    type Target = ThreadPool;

    fn deref(&self) -> &ThreadPool {
        match self {
            Self::Own(pool) => pool,
            Self::Lent(pool) => pool,
        }
    }
}

/// How full ray tracing follows rays, unless ray histories are wanted as a layer, which need single ones.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum RayOrder {
    /// Those of up to 64 samples together, level by level.
    #[default]
    Bundled,
    /// One after the other, as the paper's methods do that are compared with it.
    Single,
}

/// In which order the tiles of a band are begun.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TileOrder {
    /// Left to right.
    #[default]
    Sorted,
    /// Shuffled by this seed.
    Shuffled(u64),
}

/// Hears how much is done.
pub trait Progress: Sync {
    /// `rows` more rows of the window are finished.
    fn advance(&self, rows: u32);

    /// A thread panics while it renders these pixels of the picture. Rendering one of them alone should panic, too.
    fn panicked_in(&self, _pixels: Window) {}
}

/// Asked in every loop that may take long: has the caller set his flag? What a cancelled loop leaves is never shown.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cancel<'a>(Option<&'a AtomicBool>);

impl Cancel<'_> {
    /// Of what nobody cancels.
    #[cfg(test)]
    pub(crate) const NEVER: Self = Self(None);

    /// `None` once the flag is set.
    pub(crate) fn go_on(self) -> Option<()> {
        (!self.is_set()).then_some(())
    }

    #[inline(always)]
    pub(crate) fn is_set(self) -> bool {
        self.0.is_some_and(|flag| flag.load(Ordering::Relaxed))
    }
}

impl<'a> Run<'a> {
    /// The threads that are lent, else new ones.
    pub(crate) fn threads_to_use(&self) -> io::Result<Pool<'a>> {
        Ok(match self.pool {
            Some(pool) => Pool::Lent(pool),
            None => Pool::Own(thread_pool(self.threads)?),
        })
    }

    pub(crate) fn cancel(&self) -> Cancel<'a> {
        Cancel(self.cancel)
    }

    pub(crate) fn is_cancelled(&self) -> bool {
        self.cancel().is_set()
    }
}

impl TileOrder {
    /// Sorts tiles, whose numbers are given by `number`, into this order.
    pub(crate) fn arrange<T>(self, tiles: &mut [T], number: impl Fn(&T) -> usize) {
        if let Self::Shuffled(seed) = self {
            tiles.sort_by_key(|tile| {
                (number(tile) as u64 ^ seed).wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(31)
            });
        }
    }
}
