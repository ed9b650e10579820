//! Proves that all rays of a block meet one primitive first, or nothing.
//!
//! From: the shaft of the rays; what reaches into it; the primitives' own predicates over the block. A primitive that
//! all rays certainly meet before any other possible hit is the first one, for the predicates enclose what tracing any
//! of the rays computes.

use brt_geometry::{Hit, Mask, RayBlock, Real, Taylor};

use super::MOST_CLASSIFIED;
use super::clear::{Clear, Leaving};
use crate::methods::certified::candidates::{Candidates, MOST_LISTED};
use crate::methods::certified::known_history::KnownSight;
use crate::products::{Carrier, NOTHING};

/// What rays that leave `from` meet first, given what is known of it, and of how they left.
pub(in crate::methods::certified) fn first_seen(
    candidates: &mut Candidates,
    block: &RayBlock,
    from: Carrier,
    left: Option<&Clear>,
    known: KnownSight,
) -> KnownSight {
    let scene = candidates.scene;
    let inherited = match known {
        KnownSight::Met(_) => return known,
        KnownSight::Among(list) => Some(list),
        KnownSight::Unknown => None,
    };
    let Some(shaft) = candidates.shaft(&block.ray.origin, &block.ray.direction, f64::INFINITY) else {
        return known;
    };
    let cannot_be_left = |id: u32| scene.carrier(id) == from && scene.primitives[id as usize].is_flat();
    if !candidates.find(&shaft, inherited, MOST_LISTED, |id| !cannot_be_left(id)) {
        return known;
    }
    if candidates.found.len() > MOST_CLASSIFIED {
        return KnownSight::Among(candidates.keep_found());
    }
    let hits = candidates
        .found
        .iter()
        .map(|&id| (id, block.first_hit(&scene.primitives[id as usize], scene.start(id, from))));
    let leaving = left.and_then(|clear| clear.leaving(&block.ray.direction));
    let is_met = |id: u32, hit: &Hit<Taylor>| {
        let never = |leaving: &Leaving| leaving.never_meets(&scene.primitives[id as usize]);
        hit.found.any() && (hit.found.all() || !leaving.as_ref().is_some_and(never))
    };
    let mut hits: Vec<(u32, Hit<Taylor>)> = hits.filter(|(id, hit)| is_met(*id, hit)).collect();
    if hits.is_empty() {
        return KnownSight::Met(NOTHING);
    }
    let greatest = |hit: &Hit<Taylor>| hit.t.range()[1];
    let certain = hits.iter().filter(|(_, hit)| hit.found.all());
    let front = certain.min_by(|a, b| greatest(&a.1).total_cmp(&greatest(&b.1))).copied();
    if let Some((front, nearest)) = front {
        let hides = |id: u32| id != front && scene.hides_coincident(front, id);
        hits.retain(|(id, hit)| *id == front || (!hides(*id) && hit.t.le(nearest.t).any()));
        if hits.len() == 1 {
            return KnownSight::Met(front);
        }
    }
    KnownSight::Among(candidates.lists.keep(hits.iter().map(|(id, _)| *id)))
}
