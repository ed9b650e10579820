//! What the rays of a bundle leave: one primitive, or each a flat one of its own.

use brt_geometry::{Hit, LANES, LaneMask, Lanes, Primitive, Ray, Real};

use super::PACKETS;
use crate::tracing::search::{FROM_NOWHERE, start};

/// What each ray of a bundle leaves.
#[derive(Clone)]
pub(super) struct Starts {
    /// If all leave the same, what; [`FROM_NOWHERE`] where they leave nothing.
    sole: Option<u32>,
    /// What each leaves otherwise, as numbers: flat primitives only, which rays do not meet again.
    each: [Lanes; PACKETS],
}

impl Default for Starts {
    fn default() -> Self {
        Self { sole: Some(FROM_NOWHERE), each: [Lanes([0.0; LANES]); PACKETS] }
    }
}

impl Starts {
    /// All rays leave this.
    pub(super) fn set_sole(&mut self, primitive: u32) {
        self.sole = Some(primitive);
    }

    /// Each ray leaves a flat primitive of its own.
    pub(super) fn set_each(&mut self, primitives: &[Lanes]) {
        self.sole = None;
        self.each[..primitives.len()].copy_from_slice(primitives);
    }

    /// Becomes those of other rays.
    pub(super) fn set(&mut self, other: &Self, packets: usize) {
        match other.sole {
            Some(primitive) => self.set_sole(primitive),
            None => self.set_each(&other.each[..packets]),
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
    pub(super) fn of(&self, i: usize) -> u32 {
        self.sole.unwrap_or(self.each[i / LANES].0[i % LANES] as u32)
    }

    /// Where the rays of a packet meet a primitive.
    #[inline(always)]
    pub(super) fn first_hit(
        &self,
        packet: usize,
        ray: &Ray<Lanes>,
        primitive: &Primitive,
        id: u32,
    ) -> Hit<Lanes> {
        match self.sole {
            Some(from) => primitive.first_hit(ray, start(id, from)),
            None => {
                let hit = primitive.first_hit(ray, start(id, FROM_NOWHERE));
                let leaves: LaneMask = self.each[packet].equals(Lanes::constant(f64::from(id)));
                Hit { found: hit.found & !leaves, t: hit.t }
            }
        }
    }
}
