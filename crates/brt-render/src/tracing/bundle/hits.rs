//! What the rays of a bundle meet.

use brt_geometry::{Hit, LANES, Lanes, Real, SimdLevel};

use super::{Bundle, PACKETS, places};
use crate::products::{NOTHING, PreparedScene};
use crate::tracing::guide::Sight;
use crate::tracing::search::start;
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

    /// Which rays meet this, by bits.
    pub(super) fn that_meet(&self, primitive: u32, packets: usize) -> u64 {
        let wanted = Lanes::constant(f64::from(primitive));
        SimdLevel::default().run(
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
    fn meet(&mut self, scene: &PreparedScene, rays: &Bundle, from: u32, list: &[u32]) {
        for packet in 0..rays.packets() {
            let ray = rays.packet(packet);
            let (mut nearest, mut met) = (self.t[packet], self.primitive[packet]);
            for &id in list {
                let hit: Hit<Lanes> = scene.primitives[id as usize].first_hit(&ray, start(id, from));
                let id = Lanes::constant(f64::from(id));
                let is_nearer = hit.t.lt(nearest) | (hit.t.equals(nearest) & id.lt(met));
                let is_nearer = hit.found & is_nearer;
                nearest = Lanes::select(is_nearer, hit.t, nearest);
                met = Lanes::select(is_nearer, id, met);
            }
            (self.t[packet], self.primitive[packet]) = (nearest, met);
        }
    }
}

impl Tracer<'_> {
    /// What rays meet that leave a primitive.
    pub(super) fn find_hits(&mut self, hits: &mut Hits, rays: &Bundle, from: u32, sight: Sight) {
        hits.clear(rays.packets());
        match sight {
            Sight::Met(NOTHING) => {}
            Sight::Met(primitive) => self.find_among(hits, rays, from, &[primitive]),
            Sight::Among(list) => self.find_among(hits, rays, from, list),
            Sight::Unknown => match self.lookup.sight(self.scene, rays) {
                Some(list) => {
                    self.find_among(hits, rays, from, &list);
                    self.lookup.give_back(list);
                }
                None => self.search_hits(hits, rays, from),
            },
        }
    }

    fn find_among(&mut self, hits: &mut Hits, rays: &Bundle, from: u32, list: &[u32]) {
        self.search.count_tests((list.len() * rays.count) as u64);
        SimdLevel::default().run(
            #[inline(always)]
            || hits.meet(self.scene, rays, from, list),
        );
    }

    fn search_hits(&mut self, hits: &mut Hits, rays: &Bundle, from: u32) {
        // Lanes beyond the last are to hold what it meets.
        for i in 0..rays.packets() * LANES {
            if i >= rays.count {
                let last = rays.count - 1;
                hits.primitive[i / LANES].0[i % LANES] = hits.primitive[last / LANES].0[last % LANES];
                hits.t[i / LANES].0[i % LANES] = hits.t[last / LANES].0[last % LANES];
            } else if let Some(met) = self.search.closest(&rays.ray(i), from) {
                hits.primitive[i / LANES].0[i % LANES] = f64::from(met.primitive);
                hits.t[i / LANES].0[i % LANES] = met.t;
            }
        }
    }
}
