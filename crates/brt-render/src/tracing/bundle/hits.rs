//! What the rays of a bundle meet.

use brt_geometry::{Hit, LANES, LaneRays, Lanes, Real, Shaft, SimdLevel, Vec3};

use super::lookup::Next;
use super::{Bundle, PACKETS, places};
use crate::products::{NOTHING, PreparedScene};
use crate::tracing::guide::Sight;
use crate::tracing::search::Met;
use crate::tracing::tracer::Tracer;

/// For each ray what it meets, as a number, so that it is chosen lane by lane like all else, and how far away.
pub(super) struct Hits {
    primitive: [Lanes; PACKETS],
    pub(super) t: [Lanes; PACKETS],
}

impl Default for Hits {
    fn default() -> Self {
        Self { primitive: [NONE; PACKETS], t: [FAR; PACKETS] }
    }
}

const NONE: Lanes = Lanes([NOTHING as f64; LANES]);
const FAR: Lanes = Lanes([f64::INFINITY; LANES]);

impl Hits {
    fn clear(&mut self, packets: usize) {
        self.primitive[..packets].fill(NONE);
        self.t[..packets].fill(FAR);
    }

    /// What a ray meets.
    pub(super) fn primitive(&self, i: usize) -> u32 {
        self.primitive[i / LANES].0[i % LANES] as u32
    }

    /// What a ray meets, and where; it must meet something.
    pub(super) fn met(&self, i: usize) -> Met {
        Met { primitive: self.primitive(i), t: self.t[i / LANES].0[i % LANES] }
    }

    /// Which rays meet this, by bits.
    pub(super) fn that_meet(&self, simd: SimdLevel, primitive: u32, packets: usize) -> u64 {
        let wanted = Lanes::constant(f64::from(primitive));
        simd.run(
            #[inline(always)]
            || {
                let mut all = 0;
                for (packet, met) in self.primitive.iter().enumerate().take(packets) {
                    all |= u64::from(met.equals(wanted).bits()) << (packet * LANES);
                }
                all
            },
        )
    }

    /// Becomes the hits of the rays of these bits.
    pub(super) fn take(&mut self, hits: &Self, bits: u64) {
        for (to, from) in places(bits) {
            self.primitive[to / LANES].0[to % LANES] = hits.primitive[from / LANES].0[from % LANES];
            self.t[to / LANES].0[to % LANES] = hits.t[from / LANES].0[from % LANES];
        }
    }

    /// Tries these primitives; of equally near ones that with the lower id counts, however they are sorted.
    #[inline(always)]
    fn meet(&mut self, scene: &PreparedScene, rays: &Bundle, list: &[u32]) {
        for packet in 0..rays.packets() {
            let ray = rays.packet(packet);
            let (mut nearest, mut met) = (self.t[packet], self.primitive[packet]);
            for &id in list {
                let hit: Hit<Lanes> = rays.starts.first_hit(packet, &ray, scene, id);
                let id = Lanes::constant(f64::from(id));
                let is_nearer = hit.t.lt(nearest) | (hit.t.equals(nearest) & id.lt(met));
                let is_nearer = hit.found & is_nearer;
                nearest = Lanes::select(is_nearer, hit.t, nearest);
                met = Lanes::select(is_nearer, id, met);
            }
            (self.t[packet], self.primitive[packet]) = (nearest, met);
        }
    }

    /// Where the last of the rays ends, along an axis that all have a share of.
    #[inline(always)]
    fn end_along(&self, rays: &Bundle, axis: Vec3) -> f64 {
        let mut ends = [FAR; PACKETS];
        for (packet, end) in ends.iter_mut().enumerate().take(rays.packets()) {
            let LaneRays { origin, direction } = rays.rays[packet];
            // Not the dot product of the end: it is no number where the end is infinitely far away.
            *end = origin.dot(axis.lift()) + self.t[packet] * direction.dot(axis.lift());
        }
        ends[..rays.packets()].iter().flat_map(|end| end.0).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Meets what each ray is known to meet.
    #[inline(always)]
    fn meet_each(&mut self, scene: &PreparedScene, rays: &Bundle, known: &[u32]) {
        for packet in 0..rays.packets() {
            let ray = rays.packet(packet);
            let here = Lanes::from_fn(|lane| f64::from(known[(packet * LANES + lane).min(rays.count - 1)]));
            let mut distance = FAR;
            let mut open = !here.equals(NONE);
            while let Some(lane) = open.lanes().next() {
                let id = here.0[lane];
                let hit = rays.starts.first_hit(packet, &ray, scene, id as u32);
                let same = here.equals(Lanes::constant(id));
                distance = Lanes::select(same, hit.t, distance);
                open = open & !same;
            }
            (self.t[packet], self.primitive[packet]) = (distance, here);
        }
    }
}

impl Tracer<'_> {
    /// What rays meet.
    pub(super) fn find_hits(&mut self, hits: &mut Hits, rays: &Bundle, sight: Sight) {
        hits.clear(rays.packets());
        match sight {
            Sight::Met(NOTHING) => {}
            Sight::Met(primitive) => self.find_among(hits, rays, &[primitive]),
            Sight::Among(list) => self.find_among(hits, rays, list),
            Sight::Unknown => {
                let (simd, scene, mut tests) = (self.simd, self.scene, 0);
                let is_complete = self.lookup.sight(scene, rays, |list, shaft| {
                    tests += list.len();
                    meet_and_end(simd, hits, scene, rays, list, shaft)
                });
                self.search.count_tests((tests * rays.count) as u64);
                if !is_complete {
                    hits.clear(rays.packets());
                    self.search_hits(hits, rays);
                }
            }
        }
    }

    /// The distances at which rays meet what they are known to meet.
    pub(super) fn find_known(&mut self, hits: &mut Hits, rays: &Bundle, known: &[u32]) {
        self.search.count_tests(rays.count as u64);
        self.simd.run(
            #[inline(always)]
            || hits.meet_each(self.scene, rays, known),
        );
    }

    fn find_among(&mut self, hits: &mut Hits, rays: &Bundle, list: &[u32]) {
        self.search.count_tests((list.len() * rays.count) as u64);
        self.simd.run(
            #[inline(always)]
            || hits.meet(self.scene, rays, list),
        );
    }

    fn search_hits(&mut self, hits: &mut Hits, rays: &Bundle) {
        // Lanes beyond the last are to hold what it meets.
        for i in 0..rays.packets() * LANES {
            if i >= rays.count {
                let last = rays.count - 1;
                hits.primitive[i / LANES].0[i % LANES] = hits.primitive[last / LANES].0[last % LANES];
                hits.t[i / LANES].0[i % LANES] = hits.t[last / LANES].0[last % LANES];
            } else if let Some(met) = self.search.closest(&rays.ray(i), rays.starts.of(i)) {
                hits.primitive[i / LANES].0[i % LANES] = f64::from(met.primitive);
                hits.t[i / LANES].0[i % LANES] = met.t;
            }
        }
    }
}

/// Tries a list, and says how far away other things may still matter.
fn meet_and_end(
    simd: SimdLevel,
    hits: &mut Hits,
    scene: &PreparedScene,
    rays: &Bundle,
    list: &[u32],
    shaft: Option<&Shaft>,
) -> Next {
    simd.run(
        #[inline(always)]
        || {
            hits.meet(scene, rays, list);
            Next::Continue(shaft.map_or(f64::INFINITY, |shaft| hits.end_along(rays, shaft.axis())))
        },
    )
}
