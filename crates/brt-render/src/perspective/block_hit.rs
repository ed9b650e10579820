//! What is known of a primitive over all samples of a block.

use brt_geometry::{Mask, Primitive, Ray, Real, Start, Taylor};

use super::forms::{FlatForms, RoundForms};
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
    const NOWHERE: Self = Self {
        is_anywhere: false,
        is_everywhere: false,
        farthest: f64::INFINITY,
        depth: Depth::Direct(Taylor { c: f64::INFINITY, u: 0.0, v: 0.0, e: 0.0 }),
    };

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
        Self {
            is_anywhere: is_ahead && !(some_inside && some_outside),
            is_everywhere,
            farthest: farthest_of(inverse_depth),
            depth: Depth::Inverse(inverse_depth),
        }
    }

    /// By the forms of a sphere.
    pub(super) fn of_round(forms: &RoundForms, rays: &Ray<Taylor>, area: &Area, tile: &Tile) -> Self {
        let b = forms.b.over(area, tile);
        let discriminant = b * b - rays.dd * forms.c;
        let [least, greatest] = discriminant.range();
        let [nearest, farthest] = b.range();
        let is_anywhere = greatest >= -forms.margin && nearest <= 0.0;
        if !is_anywhere {
            return Self::NOWHERE;
        }
        let mut inverse_depth = forms.inverse_depth(b, discriminant);
        inverse_depth.e += forms.depth_margin;
        Self {
            is_anywhere,
            is_everywhere: least > forms.margin && farthest < 0.0,
            farthest: farthest_of(inverse_depth),
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

fn farthest_of(inverse_depth: Taylor) -> f64 {
    let least = inverse_depth.range()[0];
    if least > 0.0 { 1.0 / least } else { f64::INFINITY }
}
