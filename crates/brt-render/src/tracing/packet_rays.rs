//! What eight rays meet.

use brt_geometry::{LaneMask, Lanes, Mask, Ray, Real};

use super::guide::Sight;
use super::search::{FROM_NOWHERE, start};
use super::tracer::Tracer;
use crate::products::NOTHING;

/// Rays and what they meet; primitives as numbers, so that they are chosen lane by lane like all else.
#[derive(Clone, Copy)]
pub(super) struct Rays {
    pub(super) ray: Ray<Lanes>,
    pub(super) primitive: Lanes,
    pub(super) t: Lanes,
    pub(super) lanes: LaneMask,
}

impl Tracer<'_> {
    /// What rays meet that leave these primitives.
    #[inline(always)]
    pub(super) fn met(&mut self, ray: Ray<Lanes>, from: &Lanes, lanes: LaneMask, sight: Sight) -> Rays {
        let far = Lanes::constant(f64::INFINITY);
        let mut rays = Rays { ray, primitive: Lanes::constant(f64::from(NOTHING)), t: far, lanes };
        let known;
        let list = match sight {
            Sight::Met(NOTHING) => return rays,
            Sight::Met(primitive) => {
                known = [primitive];
                &known
            }
            Sight::Among(list) => list,
            Sight::Unknown => {
                for lane in lanes.lanes() {
                    let met = self.search.closest(&ray.lane(lane), from.0[lane] as u32);
                    if let Some(met) = met {
                        rays.primitive.0[lane] = f64::from(met.primitive);
                        rays.t.0[lane] = met.t;
                    }
                }
                return rays;
            }
        };
        self.search.count_tests(list.len() as u64 * lanes.count());
        for &id in list {
            let (found, t) = self.hit(&ray, from, lanes, id);
            // Lists are not sorted: of equally near ones that with the lower id counts.
            let id = Lanes::constant(f64::from(id));
            let is_nearer = t.lt(rays.t) | (t.equals(rays.t) & id.lt(rays.primitive));
            let is_nearer = found & is_nearer;
            rays.t = Lanes::select(is_nearer, t, rays.t);
            rays.primitive = Lanes::select(is_nearer, id, rays.primitive);
        }
        rays
    }

    /// Where rays that leave these primitives meet another, or the same once more.
    #[inline(always)]
    fn hit(&self, ray: &Ray<Lanes>, from: &Lanes, lanes: LaneMask, id: u32) -> (LaneMask, Lanes) {
        let primitive = &self.scene.primitives[id as usize];
        let leaves = from.equals(Lanes::constant(f64::from(id)));
        if !(lanes & leaves).any() {
            let hit = primitive.first_hit(ray, start(id, FROM_NOWHERE));
            return (hit.found, hit.t);
        }
        let again = primitive.first_hit(ray, start(id, id));
        if !(lanes & !leaves).any() {
            return (again.found, again.t);
        }
        let hit = primitive.first_hit(ray, start(id, FROM_NOWHERE));
        ((leaves & again.found) | (!leaves & hit.found), Lanes::select(leaves, again.t, hit.t))
    }
}
