//! What is known of a primitive over all samples of a block.

use brt_geometry::{Mask, Primitive, Ray, Real, Start, Taylor};

use super::flat_forms::FlatForms;
use crate::products::{Area, Tile};

/// A primitive as the rays of a block meet it.
#[derive(Clone, Copy, Debug)]
pub(super) struct BlockHit {
    /// Do some rays possibly meet it?
    pub(super) is_anywhere: bool,
    /// Do all certainly meet it?
    pub(super) is_everywhere: bool,
    /// No ray that meets it does so farther away.
    pub(super) farthest: f64,
    depth: Depth,
}

/// Depth over a block; means something where the primitive is met.
#[derive(Clone, Copy, Debug)]
enum Depth {
    Direct(Taylor),
    Inverse(Taylor),
}

impl BlockHit {
    /// By the primitive's own predicate.
    pub(super) fn of(primitive: &Primitive, rays: &Ray<Taylor>) -> Self {
        let hit = primitive.first_hit(rays, Start::Elsewhere);
        Self {
            is_anywhere: hit.found.any(),
            is_everywhere: hit.found.all(),
            farthest: hit.t.range()[1],
            depth: Depth::Direct(hit.t),
        }
    }

    /// By the forms of a flat primitive.
    pub(super) fn of_flat(forms: &FlatForms, area: &Area, tile: &Tile) -> Self {
        let inverse_depth = forms.inverse_depth.over(area, tile);
        let [lo, hi] = inverse_depth.range();
        let (mut is_everywhere, mut some_inside, mut some_outside) = (lo > forms.least, false, false);
        for edge in &forms.edges {
            let [lo, hi] = edge.over(area, tile).range();
            is_everywhere &= lo > 0.0;
            some_inside |= lo > 0.0;
            some_outside |= hi < 0.0;
        }
        let is_ahead = hi > 0.0;
        let farthest = if lo > 0.0 { 1.0 / lo } else { f64::INFINITY };
        Self {
            is_anywhere: is_ahead && !(some_inside && some_outside),
            is_everywhere,
            farthest,
            depth: Depth::Inverse(inverse_depth),
        }
    }

    /// May some ray meet this one no later than the other, which all rays meet?
    pub(super) fn may_be_before(&self, other: &Self) -> bool {
        let inverted = |depth: Taylor| Taylor::constant(1.0) / depth;
        match (self.depth, other.depth) {
            (Depth::Direct(a), Depth::Direct(b)) => a.le(b).any(),
            (Depth::Inverse(a), Depth::Inverse(b)) => a.ge(b).any(),
            (Depth::Inverse(a), Depth::Direct(b)) => inverted(a).le(b).any(),
            (Depth::Direct(a), Depth::Inverse(b)) => a.le(inverted(b)).any(),
        }
    }
}
