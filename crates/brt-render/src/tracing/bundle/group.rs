//! Which rays of a bundle go on together?

use brt_geometry::{LANES, SimdLevel};

use super::hits::Hits;
use super::ones;
use crate::products::{NOTHING, PreparedScene};

/// As many rays fill the lanes by themselves, with what they meet alone.
const FULL: u32 = LANES as u32;

/// What rays that go on together meet.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Group {
    Nothing,
    /// One primitive with nothing between its corners.
    Primitive(u32),
    /// Flat primitives of one material.
    Flat,
    /// What lanes do not know.
    Unknown,
}

/// The first of the rays of these bits, and all others that go on with it.
pub(super) fn group_of(
    simd: SimdLevel,
    scene: &PreparedScene,
    hits: &Hits,
    rest: u64,
    packets: usize,
) -> (u64, Group) {
    let primitive = hits.primitive(rest.trailing_zeros() as usize);
    let same = rest & hits.that_meet(simd, primitive, packets);
    if primitive == NOTHING {
        return (same, Group::Nothing);
    }
    let info = &scene.infos[primitive as usize];
    if !scene.materials[info.material as usize].ends_view() {
        return (same, Group::Unknown);
    }
    let is_full = same == rest || same.count_ones() >= FULL;
    if info.is_plain() && (is_full || !scene.primitives[primitive as usize].is_flat()) {
        return (same, Group::Primitive(primitive));
    }
    // What one surface mirrors stays together, more or less.
    let mirrors = scene.materials[info.material as usize].reflection > 0.0;
    let goes_along = |i: usize| {
        let id = hits.primitive(i);
        id != NOTHING && scene.primitives[id as usize].is_flat() && {
            let other = &scene.infos[id as usize];
            other.material == info.material && (other.surface == info.surface || !mirrors)
        }
    };
    let group = ones(rest & !same).filter(|&i| goes_along(i)).fold(same, |bits, i| bits | 1 << i);
    if group == same && info.is_plain() {
        return (same, Group::Primitive(primitive));
    }
    (group, Group::Flat)
}
