//! Memory, spent while it is reserved.
//!
//! What is counted is what a scene costs at its worst moment, which is while it is prepared for rendering: by then what the
//! reader kept for itself is gone, and that is never more. The costs below are such that their sum is above the peak of resident
//! memory (x86-64) of `brt render` on each of ten files of a third to a million primitives: smooth and rough sheets, with
//! colours, with normals and texture coordinates, loose triangles, balls, polygons, meshes in text, meshes used 100,000
//! times. Most reach 0.85 to 0.97 of it; text with its words and many uses of a few triangles about half.

use std::cell::Cell;
use std::io::{self, Read};
use std::sync::atomic::Ordering;

use super::{LimitExceeded, Limits};

/// What costs memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Cost {
    /// A triangle that is shown: read, made smooth, prepared.
    Triangle,
    /// A triangle of a mesh that others show.
    Listed,
    /// A point of a mesh or polygon, with all that is known of it.
    Point,
    /// A shape other than a mesh.
    Shape,
    /// An object that shows a mesh.
    Use,
    /// A material.
    Material,
    /// A word or mark of a file whose values are kept until it is read.
    Word,
    /// A node of a file, with its fields.
    Node,
    /// A number in a list.
    Number,
}

impl Cost {
    const COUNT: usize = 9;

    /// In bytes.
    pub(crate) const fn bytes(self) -> u64 {
        match self {
            Self::Triangle => 640,
            Self::Shape => 800,
            Self::Use | Self::Material | Self::Node => 512,
            Self::Word => 96,
            Self::Point => 64,
            Self::Listed => 32,
            Self::Number => 16,
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Triangle | Self::Listed => "triangles",
            Self::Shape => "shapes",
            Self::Use => "objects",
            Self::Material => "materials",
            Self::Word => "words and marks",
            Self::Node => "nodes",
            Self::Point => "points",
            Self::Number => "numbers",
        }
    }
}

/// Why reading ends although the file may be good.
#[derive(Debug)]
pub(crate) enum Halt {
    /// It asks for too much.
    Limit(LimitExceeded),
    /// Nobody waits for it any more.
    Cancelled,
}

impl From<LimitExceeded> for Halt {
    fn from(limit: LimitExceeded) -> Self {
        Self::Limit(limit)
    }
}

impl Halt {
    /// What is said where it only keeps one file of several from being read.
    pub(crate) fn text(&self) -> String {
        match self {
            Self::Limit(limit) => limit.to_string(),
            Self::Cancelled => "reading was cancelled".to_owned(),
        }
    }
}

/// What all that reads one scene may spend together.
#[derive(Debug)]
pub(crate) struct Budget<'c> {
    limits: Limits<'c>,
    spent: Cell<u64>,
    /// Bytes of files.
    read: Cell<u64>,
    counts: [Cell<u64>; Cost::COUNT],
}

impl<'c> Budget<'c> {
    pub(crate) fn new(limits: &Limits<'c>) -> Self {
        Self {
            limits: *limits,
            spent: Cell::new(0),
            read: Cell::new(0),
            counts: std::array::from_fn(|_| Cell::new(0)),
        }
    }

    pub(crate) fn limits(&self) -> &Limits<'c> {
        &self.limits
    }

    /// Is anybody still waiting? Loops ask that run longer than a moment and spend nothing.
    pub(crate) fn go_on(&self) -> Result<(), Halt> {
        match self.limits.cancel {
            Some(cancel) if cancel.load(Ordering::Relaxed) => Err(Halt::Cancelled),
            _ => Ok(()),
        }
    }

    /// Spends what so many more cost.
    pub(crate) fn spend(&self, cost: Cost, count: u64) -> Result<(), Halt> {
        let total = &self.counts[cost as usize];
        total.set(total.get().saturating_add(count));
        self.take(cost.bytes().saturating_mul(count), || format!("{} {}", counted(total.get()), cost.name()))
    }

    /// Spends bytes that have a name of their own.
    pub(crate) fn take(&self, bytes: u64, what: impl Fn() -> String) -> Result<(), Halt> {
        self.go_on()?;
        let needed = self.spent.get().saturating_add(bytes);
        self.allows(needed, what)?;
        self.spent.set(needed);
        Ok(())
    }

    /// Would there be so many bytes more?
    pub(crate) fn has(&self, bytes: u128, what: impl Fn() -> String) -> Result<(), Halt> {
        let bytes = u64::try_from(bytes).unwrap_or(u64::MAX);
        Ok(self.allows(self.spent.get().saturating_add(bytes), what)?)
    }

    /// Gives bytes back that are no longer used.
    pub(crate) fn give_back(&self, bytes: u64) {
        self.spent.set(self.spent.get().saturating_sub(bytes));
    }

    /// Counts a file before it is read.
    pub(crate) fn file(&self, bytes: u64) -> Result<(), Halt> {
        self.limits.allow_file(bytes)?;
        self.read.set(self.read.get().saturating_add(bytes));
        self.take(bytes, || "its files".to_owned())
    }

    /// An empty list with room for so many, which are spent already.
    pub(crate) fn list<T>(&self, count: usize, what: impl Fn() -> String) -> Result<Vec<T>, Halt> {
        let mut list = Vec::new();
        match list.try_reserve_exact(count) {
            Ok(()) => Ok(list),
            Err(_) => {
                let needed = (count as u64).saturating_mul(size_of::<T>() as u64);
                Err(LimitExceeded::Machine { what: what(), needed }.into())
            }
        }
    }

    fn allows(&self, needed: u64, what: impl Fn() -> String) -> Result<(), LimitExceeded> {
        /// So much is nothing to speak of.
        const SMALL: u64 = 512 << 20;
        /// A scene of many uses of few meshes needs thousands of times its file.
        const MOST_TIMES: u64 = 10_000;
        let Limits { memory: allowed, any_expansion, .. } = self.limits;
        let read = self.read.get();
        if needed > allowed {
            Err(LimitExceeded::Memory { what: what(), needed, allowed })
        } else if !any_expansion && needed > SMALL && needed / MOST_TIMES > read {
            Err(LimitExceeded::Expansion { what: what(), needed, read })
        } else {
            Ok(())
        }
    }
}

impl Limits<'_> {
    pub(crate) fn allow_file(&self, bytes: u64) -> Result<(), LimitExceeded> {
        let allowed = self.file_bytes();
        if bytes > allowed { Err(LimitExceeded::File { bytes, allowed }) } else { Ok(()) }
    }

    pub(crate) fn allow_picture(&self, [width, height]: [u32; 2]) -> Result<(), LimitExceeded> {
        let pixels = u64::from(width) * u64::from(height);
        let allowed = self.max_picture_pixels;
        if pixels > allowed { Err(LimitExceeded::PicturePixels { pixels, allowed }) } else { Ok(()) }
    }
}

/// A number that may be very large.
pub(crate) fn counted(count: impl Into<u128>) -> String {
    /// Beyond this nobody reads digits.
    const LONGEST: u128 = 1_000_000_000_000;
    let count = count.into();
    if count >= LONGEST {
        return format!("{:.0e}", count as f64);
    }
    let digits = count.to_string();
    let groups: Vec<&str> =
        digits.as_bytes().rchunks(3).rev().filter_map(|g| str::from_utf8(g).ok()).collect();
    groups.join(",")
}

/// Reads packed or otherwise slow content while somebody waits for it, up to the limits.
pub(crate) struct Watched<'b, R> {
    inner: R,
    budget: &'b Budget<'b>,
    name: &'b str,
    packed: u64,
    unpacked: u64,
    /// Why it ended.
    pub(crate) halt: Option<Halt>,
}

impl<'b, R> Watched<'b, R> {
    /// `packed` is how many bytes the content takes in its file.
    pub(crate) fn new(inner: R, budget: &'b Budget<'b>, name: &'b str, packed: u64) -> Self {
        Self { inner, budget, name, packed, unpacked: 0, halt: None }
    }

    /// May there be so many bytes?
    pub(crate) fn allow(&self, unpacked: u64) -> Result<(), Halt> {
        const SMALL: u64 = 16 << 20;
        const MOST_TIMES: u64 = 100;
        self.budget.go_on()?;
        self.budget.limits.allow_file(unpacked)?;
        let is_bomb = unpacked > SMALL && unpacked / MOST_TIMES > self.packed;
        if is_bomb && !self.budget.limits.any_expansion {
            let (name, packed) = (self.name.to_owned(), self.packed);
            return Err(LimitExceeded::Unpacking { name, packed, times: MOST_TIMES }.into());
        }
        Ok(())
    }
}

impl<R: Read> Read for Watched<'_, R> {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        let count = self.inner.read(bytes)?;
        self.unpacked += count as u64;
        match self.allow(self.unpacked) {
            Ok(()) => Ok(count),
            Err(halt) => {
                let error = io::Error::other(halt.text());
                self.halt = Some(halt);
                Err(error)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::AtomicBool;

    use super::*;

    fn limits(memory: u64) -> Limits<'static> {
        Limits { memory, ..Limits::default() }
    }

    #[test]
    fn what_is_too_much_is_named_before_it_is_spent() {
        let limits = limits(10_000);
        let budget = Budget::new(&limits);
        budget.spend(Cost::Triangle, 10).unwrap();
        let Err(Halt::Limit(limit)) = budget.spend(Cost::Triangle, 8) else { panic!("too many") };
        assert_eq!(
            limit.to_string(),
            "with 18 triangles it needs 11.2 KiB of memory, but 9.8 KiB are allowed: `--max-memory SIZE` allows more"
        );
        budget.give_back(2000);
        budget.spend(Cost::Triangle, 8).unwrap();
    }

    #[test]
    fn small_files_do_not_need_much_memory() {
        let limits = limits(8 << 30);
        let budget = Budget::new(&limits);
        budget.file(100_000).unwrap();
        budget.take(500 << 20, || "few".to_owned()).unwrap();
        let Err(Halt::Limit(limit)) = budget.take(600 << 20, || "uses of meshes".to_owned()) else {
            panic!("it is a bomb")
        };
        assert!(limit.to_string().contains("`--allow-expansion`"), "{limit}");
        let trusted = Limits { any_expansion: true, ..limits };
        Budget::new(&trusted).take(1100 << 20, || "uses of meshes".to_owned()).unwrap();
    }

    #[test]
    fn numbers_can_be_read() {
        assert_eq!([0_u32, 999, 1000, 1_234_567].map(counted), ["0", "999", "1,000", "1,234,567"]);
        assert_eq!(counted(10_u128.pow(30)), "1e30");
    }

    #[test]
    fn watched_content_ends_when_nobody_waits() {
        let cancel = AtomicBool::new(false);
        let limits = Limits { cancel: Some(&cancel), ..limits(1 << 30) };
        let budget = Budget::new(&limits);
        let mut endless = Watched::new(io::repeat(0), &budget, "x", 1 << 40);
        endless.read_exact(&mut [0; 100]).unwrap();
        cancel.store(true, Ordering::Relaxed);
        endless.read_exact(&mut [0; 100]).unwrap_err();
        assert!(matches!(endless.halt, Some(Halt::Cancelled)));
    }
}
