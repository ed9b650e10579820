//! Primitives that coincide share a carrier, and faces that are given twice are one face.
//!
//! Files bring the same face twice, boxes that stand upon each other, parts that end in one plane. Were each of two such
//! faces met where its own rounding says, rays that leave the one would meet the other or not by chance: salt and pepper. So
//! carriers that agree within rounding become one, to the bit ([`shared`]). Rays meet it at one distance for all that lie on
//! it, of which the first counts, and what leaves it does not meet it again. What then is the same primitive twice is kept
//! once ([`mod@duplicates`]), so a face given a hundred thousand times costs no more than one.

mod duplicates;
mod key;
mod shared;

use brt_geometry::{Aabb, BOX_MARGIN, Primitive, Vec3};

pub(super) use duplicates::duplicates;
use key::reach;
use shared::Rounding;

use crate::products::{Carrier, PreparedMaterial, PrimitiveInfo};
use crate::run::Cancel;

/// Gives primitives that coincide the same carrier: returns one for each primitive. `bounds` is around all that have a box,
/// `origin` where they were moved from.
pub(super) fn share_carriers(
    primitives: &mut [Primitive],
    bounds: &Aabb,
    origin: Vec3,
    cancel: Cancel,
) -> Vec<Carrier> {
    let mut carriers: Vec<Carrier> = (0..primitives.len() as u32).map(Carrier::new).collect();
    let rounding = Rounding {
        offset: reach(&[origin]),
        room: 0.25 * BOX_MARGIN * bounds.longest_side().max(f64::MIN_POSITIVE),
    };
    let mut keys = key::keys(primitives, bounds, rounding.offset);
    for run in key::runs(&mut keys) {
        shared::share(run, primitives, &mut carriers, rounding, cancel);
    }
    carriers
}

/// The number of each primitive's key, and its error.
#[cfg(test)]
pub(crate) fn keys_for_tests(primitives: &[Primitive], bounds: &Aabb) -> Vec<(f64, f64)> {
    key::keys(primitives, bounds, 0.0).into_iter().map(|key| (key.number, key.error)).collect()
}

/// The planes on which faces of glass lie that look to both sides: light may go from one solid into another, whether they
/// are two objects or parts of one mesh.
pub(super) fn contacts(
    primitives: &[Primitive],
    infos: &[PrimitiveInfo],
    carriers: &[Carrier],
    materials: &[PreparedMaterial],
) -> Vec<Carrier> {
    let is_glass = |id: &usize| materials[infos[*id].material as usize].transmission > 0.0;
    let face = |id: usize| Some((carriers[id], primitives[id].plane()?.normal));
    let mut faces: Vec<(Carrier, Vec3)> = (0..primitives.len()).filter(is_glass).filter_map(face).collect();
    faces.sort_unstable_by_key(|face| face.0);
    let looks_both_ways = |faces: &&[(Carrier, Vec3)]| faces.iter().any(|f| f.1.dot(faces[0].1) < 0.0);
    faces.chunk_by(|a, b| a.0 == b.0).filter(looks_both_ways).map(|faces| faces[0].0).collect()
}

/// The carriers of several primitives of which one is only partly there: behind it the others are seen.
pub(super) fn layered(
    infos: &[PrimitiveInfo],
    carriers: &[Carrier],
    materials: &[PreparedMaterial],
) -> Vec<Carrier> {
    let is_partial = |info: &PrimitiveInfo| materials[info.material as usize].dims();
    if !infos.iter().any(is_partial) {
        return Vec::new();
    }
    let mut users: Vec<(Carrier, bool)> =
        carriers.iter().copied().zip(infos.iter().map(is_partial)).collect();
    users.sort_unstable();
    let is_layered = |users: &&[(Carrier, bool)]| users.len() > 1 && users.iter().any(|user| user.1);
    users.chunk_by(|a, b| a.0 == b.0).filter(is_layered).map(|users| users[0].0).collect()
}
