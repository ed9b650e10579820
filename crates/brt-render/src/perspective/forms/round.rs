//! Spheres: half the linear coefficient of the ray's quadratic is linear, its discriminant quadratic.

use brt_geometry::{Ray, Real, Sphere, Taylor};

use super::LinearForm;
use crate::margins::{DEPTH_ROUNDING, DISCRIMINANT_ROUNDINGS, LEAST_POWER};
use crate::prepare::PreparedCamera;
use crate::products::{SamplePattern, Tile};

/// The forms of a sphere seen from outside.
#[derive(Clone, Debug)]
pub(crate) struct RoundForms {
    /// The scalar product of the ray's direction and the way from the centre to the eye: negative towards the sphere.
    pub(in crate::perspective) b: LinearForm,
    /// The eye's power: square of its distance from the centre less that of the radius, > 0.
    pub(in crate::perspective) c: Taylor,
    inverse_c: f64,
    /// A ray's discriminant differs by less.
    pub(in crate::perspective) margin: f64,
    /// A ray's inverse depth differs by less.
    pub(in crate::perspective) depth_margin: f64,
}

impl RoundForms {
    /// The forms over a tile whose rays leave one eye; `None` from inside the sphere and from next to its surface.
    pub(super) fn new(
        sphere: &Sphere,
        ray: &Ray<Taylor>,
        tile: &Tile,
        pattern: &SamplePattern,
    ) -> Option<Self> {
        let from_center = ray.origin - sphere.center.lift();
        let b_model = from_center.dot(ray.direction);
        let b = LinearForm::of(b_model, tile, pattern);
        let c = from_center.length_squared() - Taylor::constant(sphere.radius * sphere.radius);
        let [lo, hi] = b_model.range();
        let greatest_b = hi.abs().max(lo.abs());
        let longest = ray.dd.range()[1];
        if !(c.range()[0] > LEAST_POWER * from_center.length_squared().c && greatest_b.is_finite()) {
            return None;
        }
        let terms = greatest_b * greatest_b + c.c * longest;
        let margin = 2.0 * greatest_b * b.margin + c.e * longest + DISCRIMINANT_ROUNDINGS * terms;
        let inverse_c = 1.0 / c.c;
        let depth_margin = DEPTH_ROUNDING * 2.0 * greatest_b * inverse_c;
        (margin + depth_margin).is_finite().then_some(Self { b, c, inverse_c, margin, depth_margin })
    }

    /// The inverse depth where the discriminant is positive: by this formula nothing cancels.
    #[inline(always)]
    pub(in crate::perspective) fn inverse_depth<R: Real>(&self, b: R, discriminant: R) -> R {
        (discriminant.sqrt() - b) * R::constant(self.inverse_c)
    }

    /// Square of the length of the ray through a position, next to rounding.
    #[inline(always)]
    pub(in crate::perspective) fn dd(camera: &PreparedCamera, x: f64, y: f64) -> f64 {
        let across = (2.0 * x + camera.first[0]) * camera.half_sample;
        let down = (2.0 * y + camera.first[1]) * camera.half_sample;
        1.0 + across * across + down * down
    }
}
