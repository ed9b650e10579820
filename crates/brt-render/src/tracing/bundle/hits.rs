//! What the rays of a bundle meet.

use brt_geometry::{Hit, LANES, Lanes, Real, SimdLevel};

use super::{Bundle, PACKETS, ones};
use crate::products::{NOTHING, PreparedScene};
use crate::tracing::guide::Sight;
use crate::tracing::search::start;
use crate::tracing::tracer::Tracer;

/// For each ray what it meets, as a number, so that it is chosen lane by lane like all else, and how far away.
pub(super) struct Hits {
    primitive: [Lanes; PACKETS],
    pub(super) t: [Lanes; PACKETS],
}

impl Hits {
    fn none() -> Self {
        let nothing = Lanes::constant(f64::from(NOTHING));
        Self { primitive: [nothing; PACKETS], t: [Lanes::constant(f64::INFINITY); PACKETS] }
    }

    /// What a ray meets.
    pub(super) fn primitive(&self, i: usize) -> u32 {
        self.primitive[i / LANES].0[i % LANES] as u32
    }

    /// Which rays meet this, by bits.
    pub(super) fn that_meet(&self, primitive: u32) -> u64 {
        let wanted = Lanes::constant(f64::from(primitive));
        let bits = self.primitive.iter().map(|met| u64::from(met.equals(wanted).bits()));
        bits.enumerate().fold(0, |all, (packet, bits)| all | bits << (packet * LANES))
    }

    /// The distances of these rays.
    pub(super) fn some(&self, bits: u64) -> [Lanes; PACKETS] {
        let first = bits.trailing_zeros() as usize;
        let mut t = [Lanes::constant(self.t[first / LANES].0[first % LANES]); PACKETS];
        for (to, from) in ones(bits).enumerate() {
            t[to / LANES].0[to % LANES] = self.t[from / LANES].0[from % LANES];
        }
        t
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
    pub(super) fn hits(&mut self, rays: &Bundle, from: u32, sight: Sight) -> Hits {
        match sight {
            Sight::Met(NOTHING) => Hits::none(),
            Sight::Met(primitive) => self.hits_among(rays, from, &[primitive]),
            Sight::Among(list) => self.hits_among(rays, from, list),
            Sight::Unknown => {
                let Some(list) = self.lookup.sight(self.scene, rays) else {
                    return self.searched_hits(rays, from);
                };
                let hits = self.hits_among(rays, from, &list);
                self.lookup.give_back(list);
                hits
            }
        }
    }

    fn hits_among(&mut self, rays: &Bundle, from: u32, list: &[u32]) -> Hits {
        self.search.count_tests((list.len() * rays.count) as u64);
        let (scene, mut hits) = (self.scene, Hits::none());
        SimdLevel::default().run(
            #[inline(always)]
            || hits.meet(scene, rays, from, list),
        );
        hits
    }

    fn searched_hits(&mut self, rays: &Bundle, from: u32) -> Hits {
        let mut hits = Hits::none();
        for i in 0..rays.count {
            if let Some(met) = self.search.closest(&rays.ray(i), from) {
                hits.primitive[i / LANES].0[i % LANES] = f64::from(met.primitive);
                hits.t[i / LANES].0[i % LANES] = met.t;
            }
        }
        hits
    }
}
