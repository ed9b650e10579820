//! What a light sends in a direction.

use brt_geometry::{Real, Vec3};
use brt_image::{Rgb, rgb};

use crate::products::{Beam, LIGHT_END, PreparedLight};

impl Beam {
    /// The beam around an axis of any length but 0, with full strength up to `inner_deg` and none from `outer_deg` on.
    pub(crate) fn new(direction: Vec3, inner_deg: f64, outer_deg: f64) -> Self {
        let [inner, outer] = [inner_deg, outer_deg].map(|angle| libm::cos(angle.to_radians()));
        // Never divides by 0: a beam whose edge is thinner than that of numbers has a sharp edge.
        let steepness = 1.0 / (inner - outer).max(f64::MIN_POSITIVE);
        Self { axis: direction.try_normalize().unwrap_or_default(), outer, steepness }
    }

    /// Share of the light that goes to a point from which the light is seen in the direction of this unit vector.
    #[inline(always)]
    fn strength<R: Real>(&self, towards: Vec3<R>) -> R {
        let cosine = -self.axis.lift::<R>().dot(towards);
        let rise = (cosine - R::constant(self.outer)) * R::constant(self.steepness);
        let s = rise.max(R::constant(0.0)).min(R::constant(1.0));
        s * s * (R::constant(3.0) - R::constant(2.0) * s)
    }
}

impl PreparedLight {
    /// The way from a point to the light, of unit length for one infinitely far away, and the distance in units of it
    /// beyond which nothing hides the light.
    #[inline(always)]
    pub(super) fn way_from<R: Real>(&self, point: Vec3<R>) -> (Vec3<R>, f64) {
        match self {
            Self::Point { position, .. } => (position.lift::<R>() - point, LIGHT_END),
            Self::Directional { towards, .. } => (towards.lift(), f64::INFINITY),
        }
    }

    /// Light that arrives where it is seen in the direction of this unit vector.
    #[inline(always)]
    pub(super) fn source<R: Real>(&self, towards: Vec3<R>) -> Rgb<R> {
        let (color, beam) = match self {
            Self::Point { color, beam, .. } => (color, beam.as_ref()),
            Self::Directional { color, .. } => (color, None),
        };
        let full = rgb(R::constant(color.r), R::constant(color.g), R::constant(color.b));
        match beam {
            Some(beam) => full * beam.strength(towards),
            None => full,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use brt_geometry::vec3;

    #[test]
    fn beams_fall_smoothly_from_their_inner_to_their_outer_angle() {
        let beam = Beam::new(vec3(0.0, 0.0, -2.0), 0.0, 60.0);
        // The light is seen upwards from below it: cos 0° = 1, cos 60° = 0.5; half-way at a cosine of 0.75.
        let seen_at = |cosine: f64| beam.strength(vec3((1.0 - cosine * cosine).sqrt(), 0.0, cosine));
        let expected = [(1.0, 1.0), (0.875, 0.84375), (0.75, 0.5), (0.5, 0.0), (0.1, 0.0), (-1.0, 0.0)];
        for (cosine, strength) in expected {
            assert!((seen_at(cosine) - strength).abs() < 1e-14, "{cosine}");
        }
    }
}
