//! What lies across a direction.

use std::fmt::Debug;

use super::{Real, Vec3};

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
