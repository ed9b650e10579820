//! What primitives are parts of.

/// The whole plane, sphere, cylinder or cone that a primitive is a part of.
///
/// Primitives that coincide have one carrier: rays meet it at one distance for all of them, and a ray that leaves one of them
/// does not meet the others where it starts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct Carrier(u32);

impl Carrier {
    /// Among all carriers of a scene, before duplicates are removed: the place of the primitive that it belongs to.
    pub(crate) fn index(self) -> usize {
        self.0 as usize
    }

    /// What rays leave that start in empty space.
    pub(crate) const NOWHERE: Self = Self(u32::MAX);

    /// The carrier with this number, which is below `u32::MAX`.
    pub(crate) fn new(number: u32) -> Self {
        Self(number)
    }

    /// Its number as lanes compare it: exact.
    #[inline(always)]
    pub(crate) fn as_number(self) -> f64 {
        f64::from(self.0)
    }

    /// The carrier of a number from [`Self::as_number`].
    #[inline(always)]
    pub(crate) fn of_number(number: f64) -> Self {
        Self(number as u32)
    }
}
