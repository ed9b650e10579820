//! Rays and what they hit.

use std::fmt::Debug;

use crate::margins::START_ROUNDINGS;
use crate::{FARTHEST, Mask, Real, Vec3};

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

/// Two vectors across a ray's direction: products with them say how points look along it.
pub trait Across<R>: Copy + Debug {
    /// What rays keep of them.
    fn of(direction: Vec3<R>) -> Self;
    /// The vectors.
    fn vectors(self, direction: Vec3<R>) -> [Vec3<R>; 2];
}

/// Kept by each ray.
impl<R: Real> Across<R> for [Vec3<R>; 2] {
    #[inline(always)]
    fn of(direction: Vec3<R>) -> Self {
        across(direction)
    }
    #[inline(always)]
    fn vectors(self, _: Vec3<R>) -> Self {
        self
    }
}

/// Found anew each time.
impl<R: Real> Across<R> for () {
    #[inline(always)]
    fn of(_: Vec3<R>) {}
    #[inline(always)]
    fn vectors(self, direction: Vec3<R>) -> [Vec3<R>; 2] {
        across(direction)
    }
}

/// Two of the three products of a direction with the axes, without that which belongs to its greatest coordinate. Their own
/// product is the direction times this coordinate, so what they see is not flattened.
#[inline(always)]
fn across<R: Real>(d: Vec3<R>) -> [Vec3<R>; 2] {
    let zero = R::constant(0.0);
    let [x, y, z] = [d.x * d.x, d.y * d.y, d.z * d.z];
    let y_is_greatest = y.ge(x) & y.ge(z);
    let z_is_greatest = z.ge(x) & !y_is_greatest;
    let by_x = Vec3 { x: zero, y: d.z, z: -d.y };
    let by_y = Vec3 { x: d.z, y: zero, z: -d.x };
    let by_z = Vec3 { x: -d.y, y: d.x, z: zero };
    [choose(y_is_greatest, by_x, by_y), choose(z_is_greatest, by_x, by_z)]
}

#[inline(always)]
fn choose<R: Real>(mask: R::Mask, yes: Vec3<R>, no: Vec3<R>) -> Vec3<R> {
    let choose = R::select;
    Vec3 { x: choose(mask, yes.x, no.x), y: choose(mask, yes.y, no.y), z: choose(mask, yes.z, no.z) }
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
