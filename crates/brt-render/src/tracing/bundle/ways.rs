//! The ways from points of a surface to a light.

use brt_geometry::{Aabb, LaneMask, LaneRays, Lanes, Mask, Real, Shaft, Vec3, vec3};

use super::{NOWHERE, PACKETS, lane_of};
use crate::products::PreparedLight;

/// The ways to a light from those points of a surface that face it.
pub(super) struct Ways<'s> {
    pub(super) points: &'s [Vec3<Lanes>],
    /// Which of them matter.
    pub(super) lit: &'s [LaneMask],
    /// The faces' own normals, on the side of the ways; none where all lie on one face, below which nothing is found anyway.
    pub(super) normals: &'s [Vec3<Lanes>],
    pub(super) light: &'s PreparedLight,
}

impl Ways<'_> {
    /// What holds all ways that matter.
    #[inline(always)]
    pub(super) fn shaft(&self, bounds: &Aabb) -> Option<Shaft> {
        let (mut points, mut rays) = ([NOWHERE; PACKETS], [NOT_YET; PACKETS]);
        let packets = self.points.len();
        let first = self.lit.iter().position(|lit| lit.any())?;
        let lane = self.lit[first].lanes().next()?;
        // Points that do not matter are moved to one that does.
        let spare = lane_of(&self.points[first], lane).lift();
        for packet in 0..packets {
            let point = Vec3::select(self.lit[packet], self.points[packet], spare);
            points[packet] = point;
            rays[packet] = match self.light {
                // Ways to a point spread from there.
                PreparedLight::Point { position, .. } => {
                    LaneRays { origin: position.lift(), direction: point - position.lift() }
                }
                PreparedLight::Directional { towards, .. } => {
                    LaneRays { origin: point, direction: towards.lift() }
                }
            };
        }
        let (rays, points) = (&rays[..packets], &points[..packets]);
        let (end, along) = match self.light {
            PreparedLight::Point { .. } => (1.0, -1.0),
            PreparedLight::Directional { .. } => (f64::INFINITY, 1.0),
        };
        let shaft = Shaft::around_rays_in(bounds, rays, end)?;
        let up = self.up();
        let rise = (up * along).lift();
        let all_rise = rays.iter().all(
            #[inline(always)]
            |ray| ray.direction.dot(rise).gt(Lanes::constant(0.0)).all(),
        );
        if all_rise { shaft.above(up, points) } else { Some(shaft) }
    }

    /// The sum of the normals.
    #[inline(always)]
    fn up(&self) -> Vec3 {
        let mut sums = [NOWHERE; PACKETS + 1];
        for (packet, (&normal, &lit)) in self.normals.iter().zip(self.lit).enumerate() {
            sums[packet + 1] = sums[packet] + Vec3::select(lit, normal, NOWHERE);
        }
        let Vec3 { x, y, z } = sums[self.normals.len()];
        vec3(x.0.iter().sum(), y.0.iter().sum(), z.0.iter().sum())
    }
}

const NOT_YET: LaneRays = LaneRays { origin: NOWHERE, direction: NOWHERE };
