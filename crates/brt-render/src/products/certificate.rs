//! What certified ray tracing proves of blocks, and how often that succeeds.

use std::ops::{AddAssign, Index, IndexMut};

/// Something to be proven of a block. Where a sample was not filled, that which failed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(u8)]
pub enum Certificate {
    /// All rays meet one primitive, or nothing.
    Visibility,
    /// A light is seen from all points, or from none.
    Shadow,
    /// All rays come to the surface from one side, and its shading is known to bounds: no glass, no smooth normals but on
    /// fine meshes.
    Surface,
    /// All points lie in one square of a pattern.
    Checker,
    /// A linear colour is within the tolerance.
    Color,
    /// There are enough samples for proofs to pay.
    Size,
}

impl Certificate {
    /// All of them.
    pub const ALL: [Self; 6] =
        [Self::Visibility, Self::Shadow, Self::Surface, Self::Checker, Self::Color, Self::Size];

    /// Its name in statistics.
    pub fn name(self) -> &'static str {
        match self {
            Self::Visibility => "visibility",
            Self::Shadow => "shadow",
            Self::Surface => "surface",
            Self::Checker => "checker",
            Self::Color => "color",
            Self::Size => "size",
        }
    }
}

/// How often a certificate was tried.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tries {
    /// With success.
    pub proven: u64,
    /// Without.
    pub failed: u64,
}

/// Counts by certificate. What a block inherits from the one it is a part of is not tried again.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CertificateCounts([Tries; 6]);

impl CertificateCounts {
    /// Counts a trial and passes its outcome on.
    #[inline]
    pub(crate) fn note(&mut self, certificate: Certificate, is_proven: bool) -> bool {
        let tries = &mut self[certificate];
        if is_proven {
            tries.proven += 1;
        } else {
            tries.failed += 1;
        }
        is_proven
    }
}

impl Index<Certificate> for CertificateCounts {
    type Output = Tries;
    fn index(&self, certificate: Certificate) -> &Tries {
        &self.0[certificate as usize]
    }
}

impl IndexMut<Certificate> for CertificateCounts {
    fn index_mut(&mut self, certificate: Certificate) -> &mut Tries {
        &mut self.0[certificate as usize]
    }
}

impl AddAssign for CertificateCounts {
    fn add_assign(&mut self, other: Self) {
        for (sum, tries) in self.0.iter_mut().zip(other.0) {
            sum.proven += tries.proven;
            sum.failed += tries.failed;
        }
    }
}
