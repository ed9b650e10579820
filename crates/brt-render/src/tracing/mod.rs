//! Tracing: the colour and ray history of a sample.
//!
//! [`mod@reference`] is the oracle: one plain recursion over all primitives. [`tracer`] is what methods use. Both share the
//! primitives' predicates, [`interaction`] and [`illumination`], and give the same bits.

mod bounding_spheres;
mod bundle;
mod contact;
mod first_seen;
mod guide;
mod illumination;
mod interaction;
mod patch;
mod pencil;
mod reference;
mod search;
mod see_through;
mod shadow_space;
mod source;
mod tracer;

pub(crate) use bounding_spheres::BoundingSpheres;
pub(crate) use bundle::{Bundle, Colors, MOST_RAYS, NO_COLORS, color_at};
/// No sample follows more mirror and refracted rays: between glass walls their number doubles at every bounce. Those
/// beyond it end like those at the depth limit.
const MOST_RAYS_PER_SAMPLE: u32 = 1 << 16;

pub use first_seen::FirstSeen;
pub(crate) use guide::{Guide, Lighting, LightsSeen, Sight, Unguided};
pub(crate) use interaction::Interaction;
pub(crate) use patch::{LightWays, Patch, constant};
pub(crate) use pencil::PencilTracer;
pub(crate) use reference::reference_sample;
pub(crate) use shadow_space::lights_surely_seen;
pub(crate) use tracer::Tracer;
