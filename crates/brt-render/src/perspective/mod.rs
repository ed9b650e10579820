//! The perspective image: what each sample sees first, made without rays. Paper: P3, P11.
//!
//! [`outlines`] projects every primitive once and sorts them into bands. A tile is then divided like Warnock (1969)
//! until one primitive certainly covers a block before all others, by bounds over the whole block; what is left at
//! blocks of a few samples goes through a Z-buffer. All decisions are the primitives' own predicates, so the image
//! equals the first hits of the tracer on every sample.

mod block_hit;
mod depth_buffer;
mod forms;
mod outlines;
mod subdivide;

pub(crate) use outlines::{BandOutlines, Outline, Outlines};
pub(crate) use subdivide::Painter;
