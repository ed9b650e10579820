//! What the rays of a bundle leave: one primitive, or each a flat one of its own.

use brt_geometry::{Hit, LANES, LaneMask, Lanes, Ray, Real, Start};

use super::PACKETS;
use crate::products::{Carrier, PreparedScene};

/// What each ray of a bundle leaves.
#[derive(Clone)]
pub(super) struct Starts {
    /// If all leave the same, what; [`Carrier::NOWHERE`] where they leave nothing.
    sole: Option<Carrier>,
    /// What each leaves otherwise, as numbers: planes only, which rays do not meet again.
    each: [Lanes; PACKETS],
}

impl Default for Starts {
    fn default() -> Self {
        Self { sole: Some(Carrier::NOWHERE), each: [Lanes([0.0; LANES]); PACKETS] }
    }
}

impl Starts {
    /// All rays leave this.
    pub(super) fn set_sole(&mut self, carrier: Carrier) {
        self.sole = Some(carrier);
    }

    /// A ray leaves this plane, and each of the others one of its own.
    pub(super) fn set_one(&mut self, i: usize, carrier: Carrier) {
        self.sole = None;
        self.each[i / LANES].0[i % LANES] = carrier.as_number();
    }

    /// Becomes those of other rays.
    pub(super) fn set(&mut self, other: &Self, packets: usize) {
        self.sole = other.sole;
        if self.sole.is_none() {
            self.each[..packets].copy_from_slice(&other.each[..packets]);
        }
    }

    /// Becomes those of picked rays, as pairs of to and from.
    pub(super) fn take(&mut self, other: &Self, places: impl Iterator<Item = (usize, usize)>) {
        self.sole = other.sole;
        if self.sole.is_none() {
            for (to, from) in places {
                self.each[to / LANES].0[to % LANES] = other.each[from / LANES].0[from % LANES];
            }
        }
    }

    /// Are they not all the same?
    #[inline(always)]
    pub(super) fn differ(&self) -> bool {
        self.sole.is_none()
    }

    /// What a ray leaves.
    pub(super) fn of(&self, i: usize) -> Carrier {
        self.sole.unwrap_or(Carrier::of_number(self.each[i / LANES].0[i % LANES]))
    }

    /// Where the rays of a packet meet a primitive.
    #[inline(always)]
    pub(super) fn first_hit(
        &self,
        packet: usize,
        ray: &Ray<Lanes>,
        scene: &PreparedScene,
        id: u32,
    ) -> Hit<Lanes> {
        // One call for both, since all of a primitive's formula is inlined here.
        let start = self.sole.map_or(Start::Elsewhere, |from| scene.start(id, from));
        let hit = scene.primitives[id as usize].first_hit(ray, start);
        if self.sole.is_some() {
            return hit;
        }
        let carrier = Lanes::constant(scene.carrier(id).as_number());
        let leaves: LaneMask = self.each[packet].equals(carrier);
        Hit { found: hit.found & !leaves, t: hit.t }
    }
}
