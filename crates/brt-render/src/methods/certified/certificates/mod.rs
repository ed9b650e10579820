//! Certificates: conservative proofs about a block, one file per way to fail.

mod checker;
mod clear;
mod screen;
mod shadow;
#[cfg(test)]
mod tests;
mod tolerance;
mod visibility;

pub(super) use checker::cell_color;
pub(super) use clear::Clear;
pub(super) use screen::hides_together;
pub(super) use shadow::{before_light, is_beside, lighting, shaft_of};
pub(crate) use tolerance::Tolerance;
pub(super) use visibility::first_seen;

/// More candidates than these are not looked at one by one: smaller blocks have fewer.
const MOST_CLASSIFIED: usize = 16;
