//! What decides on a hit, written as functions of a sample's position.
//!
//! For rays that leave one eye, the predicates of flat primitives are linear and those of spheres quadratic. The forms
//! of a tile are read off the predicates, evaluated over the whole tile as Taylor models: what is linear leaves
//! nothing but rounding in the remainder, and that bounds how far a form is from what a ray computes. Where a form is
//! within this margin of a decision, the ray decides.

mod flat;
mod linear;
mod round;

pub(super) use flat::FlatForms;
pub(super) use linear::LinearForm;
pub(super) use round::RoundForms;

use brt_geometry::{Primitive, RayBlock};

use crate::products::{SamplePattern, Tile};

/// The forms of a primitive over a tile.
#[derive(Clone, Debug)]
pub(super) enum Forms {
    Flat(FlatForms),
    Round(RoundForms),
}

impl Forms {
    /// The forms over a tile whose rays leave one eye, for primitives that have them there.
    pub(super) fn new(
        primitive: &Primitive,
        rays: &RayBlock,
        tile: &Tile,
        pattern: &SamplePattern,
    ) -> Option<Self> {
        if let Primitive::Sphere(sphere) = primitive {
            return RoundForms::new(sphere, &rays.ray, tile, pattern).map(Self::Round);
        }
        let (plane, corners) = primitive.flat()?;
        FlatForms::new(plane, corners, rays, tile, pattern).map(Self::Flat)
    }

    /// A ray's inverse depth differs by less.
    pub(super) fn depth_margin(&self) -> f64 {
        match self {
            Self::Flat(forms) => forms.inverse_depth.margin,
            Self::Round(forms) => forms.depth_margin,
        }
    }
}
