//! Answers over a whole block: certainly true, certainly false, or neither.

use std::ops::{BitAnd, BitOr, Not};

use crate::numbers::Mask;

/// What is known of a comparison over a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Trilean {
    pub(crate) possible: bool,
    pub(crate) certain: bool,
}

impl Mask for Trilean {
    const TRUE: Self = Self { possible: true, certain: true };
    const FALSE: Self = Self { possible: false, certain: false };
    #[inline(always)]
    fn any(self) -> bool {
        self.possible
    }
    #[inline(always)]
    fn all(self) -> bool {
        self.certain
    }
}

impl BitAnd for Trilean {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, o: Self) -> Self {
        Self { possible: self.possible && o.possible, certain: self.certain && o.certain }
    }
}

impl BitOr for Trilean {
    type Output = Self;
    #[inline(always)]
    fn bitor(self, o: Self) -> Self {
        Self { possible: self.possible || o.possible, certain: self.certain || o.certain }
    }
}

impl Not for Trilean {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        Self { possible: !self.certain, certain: !self.possible }
    }
}
