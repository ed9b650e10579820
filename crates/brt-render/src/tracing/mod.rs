//! Tracing: the colour and ray history of a sample.
//!
//! [`reference`] is the oracle: one plain recursion over all primitives. [`tracer`] is what methods use. Both share the
//! primitives' predicates, [`interaction`] and [`illumination`], and give the same bits.

mod illumination;
mod interaction;
mod reference;
mod search;
mod tracer;

pub(crate) use interaction::Interaction;
pub(crate) use reference::reference_sample;
pub(crate) use tracer::{FirstHit, Tracer};
