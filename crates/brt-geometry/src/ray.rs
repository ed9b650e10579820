//! Rays and what they hit.

use crate::margins::START_ROUNDINGS;
use crate::{Across, FARTHEST, Mask, Real, Vec3};

/// A half-line. The direction has any length; distances along it are in units of that length.
#[derive(Clone, Copy, Debug)]
pub struct Ray<R: Real = f64> {
    /// Where it starts.
    pub origin: Vec3<R>,
    /// Where it goes, not normalised.
    pub direction: Vec3<R>,
    /// `direction · direction`
    pub dd: R,
    /// `1 / dd`
    pub inv_dd: R,
    /// For [`Self::view_along`].
    across: R::Across,
}

impl<R: Real> Ray<R> {
    /// The ray from `origin` along `direction`.
    #[inline(always)]
    pub fn new(origin: Vec3<R>, direction: Vec3<R>) -> Self {
        let dd = direction.length_squared();
        Self { origin, direction, dd, inv_dd: R::constant(1.0) / dd, across: R::Across::of(direction) }
    }

    /// Says of points where they are, seen along the ray: the ray itself is at 0, 0. The same bits for whatever has the
    /// point as a corner.
    #[inline(always)]
    pub(crate) fn view_along(&self) -> impl Fn(Vec3) -> [R; 2] {
        let (origin, [first, second]) = (self.origin, self.across.vectors(self.direction));
        #[inline(always)]
        move |point| {
            let from_origin = point.lift::<R>() - origin;
            [first.dot(from_origin), second.dot(from_origin)]
        }
    }

    /// Is the point at distance `t` farther from the start than rounding? A root nearer than that is the one that the ray starts
    /// at: from the point that it gives the same ray would start again, and meet it again, for ever.
    #[inline(always)]
    pub(crate) fn gets_away(&self, t: R) -> R::Mask {
        let Vec3 { x, y, z } = self.origin;
        let least = (x.max(-x) + y.max(-y) + z.max(-z)) * R::constant(START_ROUNDINGS);
        (t * t * self.dd).gt(least * least)
    }

    /// The point at distance `t`.
    #[inline(always)]
    pub fn at(&self, t: R) -> Vec3<R> {
        self.origin + self.direction * t
    }
}

/// The nearest point of a primitive ahead of a ray.
#[derive(Clone, Copy, Debug)]
pub struct Hit<R: Real = f64> {
    /// Is there one? Where not, `t` means nothing.
    pub found: R::Mask,
    /// Its distance in units of the ray's direction, above 0 and below [`FARTHEST`].
    pub t: R,
}

impl<R: Real> Hit<R> {
    /// No hit.
    #[inline(always)]
    pub fn none() -> Self {
        Self { found: R::Mask::FALSE, t: R::constant(f64::INFINITY) }
    }

    /// A hit at `t` where `valid` and `t` is ahead.
    #[inline(always)]
    pub fn at(t: R, valid: R::Mask) -> Self {
        let ahead = t.gt(R::constant(0.0)) & t.lt(R::constant(FARTHEST));
        Self { found: valid & ahead, t }
    }

    /// The nearer of two hits.
    #[inline(always)]
    pub fn nearer(self, other: Self) -> Self {
        let first = self.found & (self.t.le(other.t) | !other.found);
        Self { found: self.found | other.found, t: R::select(first, self.t, other.t) }
    }
}

/// Does a ray start on the primitive that it is tested with?
///
/// A ray that leaves a primitive skips the root at its origin and no other: flat primitives are not hit again, a
/// sphere is where the ray comes out on its other side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Start {
    /// It starts anywhere else.
    Elsewhere,
    /// It starts on this primitive.
    OnPrimitive,
}
