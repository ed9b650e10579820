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

use brt_geometry::{Aabb, Primitive};

pub(super) use duplicates::duplicates;

use crate::products::{Carrier, PreparedMaterial, PrimitiveInfo, Surface};

/// Gives primitives that coincide the same carrier: returns one for each primitive. `bounds` is around all that have a box.
pub(super) fn share_carriers(primitives: &mut [Primitive], bounds: &Aabb) -> Vec<Carrier> {
    let mut carriers: Vec<Carrier> = (0..primitives.len() as u32).map(Carrier::new).collect();
    let mut keys = key::keys(primitives, bounds);
    keys.sort_unstable_by(|a, b| a.number.total_cmp(&b.number).then(a.id.cmp(&b.id)));
    for run in key::runs(&mut keys) {
        shared::share(run, primitives, &mut carriers);
    }
    carriers
}

/// The planes on which faces of several transparent objects lie: light goes from one into the other.
pub(super) fn contacts(
    primitives: &[Primitive],
    infos: &[PrimitiveInfo],
    carriers: &[Carrier],
    surfaces: &[Surface],
    materials: &[PreparedMaterial],
) -> Vec<Carrier> {
    let is_refracting =
        |id: &usize| primitives[*id].is_flat() && materials[infos[*id].material as usize].transmission > 0.0;
    let object_of = |id: usize| surfaces[infos[id].surface as usize].object;
    let faces = (0..primitives.len()).filter(is_refracting);
    let mut faces: Vec<(Carrier, usize)> = faces.map(|id| (carriers[id], object_of(id))).collect();
    faces.sort_unstable();
    faces.dedup();
    faces
        .chunk_by(|a, b| a.0 == b.0)
        .filter(|objects| objects.len() > 1)
        .map(|objects| objects[0].0)
        .collect()
}
