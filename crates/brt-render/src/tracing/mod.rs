//! Tracing: the colour and ray history of a sample.
//!
//! [`reference`] is the oracle: one plain recursion over all primitives. [`tracer`] is what methods use. Both share the
//! primitives' predicates, [`interaction`] and [`illumination`], and give the same bits.

mod first_seen;
mod illumination;
mod interaction;
mod reference;
mod search;
mod shadow_space;
mod tracer;

pub use first_seen::FirstSeen;
pub(crate) use interaction::Interaction;
pub(crate) use reference::reference_sample;
pub(crate) use shadow_space::ShadowSpace;
pub(crate) use tracer::{FirstHit, Tracer};
