//! Which primitives may the rays of a bundle meet? Looked up once for all of them.

use brt_geometry::{Bvh, LANES, LaneRays, Lanes, Shaft, SimdLevel, SpatialIndex, Vec3};

use super::{Bundle, NOWHERE, PACKETS};
use crate::products::{PreparedLight, PreparedScene};

/// Fewer rays search by themselves.
const LEAST_RAYS: usize = 12;

/// Rays that may meet more primitives search by themselves, too.
const MOST_LISTED: usize = 20;

/// All primitives of scenes with no more are tried by all rays.
const FEW: usize = 6;

/// Lists of a bundle's candidates, and room for them.
#[derive(Default)]
pub(in crate::tracing) struct Lookup {
    spare: Vec<Vec<u32>>,
}

impl Lookup {
    /// What the rays may meet; `None` where that is not worth while to know.
    pub(super) fn sight(&mut self, scene: &PreparedScene, rays: &Bundle) -> Option<Vec<u32>> {
        self.list(
            scene,
            rays.count,
            #[inline(always)]
            |tree| Shaft::around_rays_in(tree, &rays.rays[..rays.packets()], f64::INFINITY),
            |_| true,
        )
    }

    /// What may stand between these points and a light.
    pub(super) fn shadow(
        &mut self,
        scene: &PreparedScene,
        points: &[Vec3<Lanes>; PACKETS],
        count: usize,
        light: &PreparedLight,
    ) -> Option<Vec<u32>> {
        self.list(
            scene,
            count,
            #[inline(always)]
            |tree| light_shaft(tree, points, count, light),
            |id| scene.infos[id as usize].casts_shadow,
        )
    }

    /// For a list that is needed no longer.
    pub(super) fn give_back(&mut self, list: Vec<u32>) {
        self.spare.push(list);
    }

    fn list(
        &mut self,
        scene: &PreparedScene,
        count: usize,
        shaft: impl FnOnce(&Bvh) -> Option<Shaft>,
        counts: impl Fn(u32) -> bool,
    ) -> Option<Vec<u32>> {
        let mut list = self.spare.pop().unwrap_or_default();
        list.clear();
        if scene.primitives.len() <= FEW {
            list.extend((0..scene.primitives.len() as u32).filter(|&id| counts(id)));
            return Some(list);
        }
        let is_complete = match &scene.index {
            SpatialIndex::Bvh(bvh) if count >= LEAST_RAYS => shaft_of(bvh, shaft).is_some_and(|shaft| {
                // Single rays try all of these, wherever they are.
                list.extend(scene.outside.iter().filter(|&&id| counts(id)));
                list.len() <= MOST_LISTED
                    && bvh.touched_by(&shaft, |id| {
                        if counts(id) && !shaft.misses(&scene.primitives[id as usize]) {
                            list.push(id);
                        }
                        list.len() <= MOST_LISTED
                    })
            }),
            _ => false,
        };
        if is_complete {
            return Some(list);
        }
        self.give_back(list);
        None
    }
}

/// All ways between points and a light.
#[inline(always)]
fn light_shaft(
    tree: &Bvh,
    points: &[Vec3<Lanes>; PACKETS],
    count: usize,
    light: &PreparedLight,
) -> Option<Shaft> {
    let mut ways = [LaneRays { origin: NOWHERE, direction: NOWHERE }; PACKETS];
    let packets = count.div_ceil(LANES);
    for (way, &point) in ways.iter_mut().zip(points).take(packets) {
        *way = match light {
            // Ways to a point spread from there.
            PreparedLight::Point { position, .. } => {
                LaneRays { origin: position.lift(), direction: point - position.lift() }
            }
            PreparedLight::Directional { towards, .. } => {
                LaneRays { origin: point, direction: towards.lift() }
            }
        };
    }
    let end = if let PreparedLight::Point { .. } = light { 1.0 } else { f64::INFINITY };
    Shaft::around_rays_in(tree, &ways[..packets], end)
}

/// The shaft, computed in lanes.
fn shaft_of(tree: &Bvh, shaft: impl FnOnce(&Bvh) -> Option<Shaft>) -> Option<Shaft> {
    SimdLevel::default().run(
        #[inline(always)]
        || shaft(tree),
    )
}
