//! Numbers, and vectors of them: what a predicate is generic over.

mod across;
mod real;
mod vec3;

pub use across::Across;
pub(crate) use real::power_by_squaring;
pub use real::{Exponent, Mask, Real};
pub use vec3::{Vec3, vec3};
