//! What is known of a sample's ray tree before it is traced.

/// What is known of how a light is seen from a hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Lighting<'a> {
    /// Nothing: a ray must search.
    Unknown,
    /// Only these primitives can hide it.
    Among(&'a [u32]),
    /// Nothing hides it where the surface faces it.
    Seen,
    /// It is hidden or behind the surface.
    Hidden,
}

/// What is known of the next hit of a ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sight<'a> {
    /// Nothing: a ray must search.
    Unknown,
    /// One of these primitives is met first, or nothing.
    Among(&'a [u32]),
    /// This primitive is met first, or [`NOTHING`](crate::products::NOTHING).
    Met(u32),
}

/// Knowledge that saves searches, level by level along mirror rays. Traced colours do not depend on it.
pub(crate) trait Guide: Copy {
    /// How a light is seen from the current hit, lights counted from 0.
    fn lighting(&self, light: usize) -> Lighting<'_>;
    /// What the mirror ray of the current hit meets.
    fn mirrored(&self) -> Sight<'_>;
    /// Knowledge of that hit.
    fn next(self) -> Self;
}

/// No knowledge.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Unguided;

impl Guide for Unguided {
    #[inline(always)]
    fn lighting(&self, _: usize) -> Lighting<'_> {
        Lighting::Unknown
    }
    #[inline(always)]
    fn mirrored(&self) -> Sight<'_> {
        Sight::Unknown
    }
    #[inline(always)]
    fn next(self) -> Self {
        self
    }
}

/// Lights, by bits, that nothing hides from the first hit.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LightsSeen(pub(crate) u64);

impl Guide for LightsSeen {
    #[inline(always)]
    fn lighting(&self, light: usize) -> Lighting<'_> {
        if light < 64 && self.0 >> light & 1 == 1 { Lighting::Seen } else { Lighting::Unknown }
    }
    #[inline(always)]
    fn mirrored(&self) -> Sight<'_> {
        Sight::Unknown
    }
    #[inline(always)]
    fn next(self) -> Self {
        Self(0)
    }
}
