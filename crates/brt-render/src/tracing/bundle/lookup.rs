//! Which primitives may the rays of a bundle meet? Looked up once for all of them, by their shaft.

use std::ops::ControlFlow;

use brt_geometry::{Aabb, Shaft, SimdLevel, SpatialIndex, Traversal};

use super::Bundle;
use super::ways::Ways;
use crate::products::PreparedScene;

/// Fewer rays search by themselves.
const LEAST_RAYS: usize = 12;

/// So many primitives are tried together before it is asked whether more are needed.
const BATCH: usize = 20;

/// Rays that would try more than this and a few for each of them search by themselves: they go apart.
const MOST_TRIED: usize = 48;
const MOST_TRIED_PER_RAY: usize = 2;

/// So many boxes that the shaft touches cost as much as one primitive that is tried.
const BOXES_PER_TRY: usize = 4;

/// All primitives of scenes with no more are tried by all rays.
const FEW: usize = 6;

/// What is to be done after a list was tried: break off, or go on with what begins no farther away along the axis.
pub(super) type Next = ControlFlow<(), f64>;

/// Go on, wherever things are.
pub(super) const ANYWHERE: Next = Next::Continue(f64::INFINITY);

/// Working memory of lookups.
pub(in crate::tracing) struct Lookup {
    simd: SimdLevel,
    list: Vec<u32>,
    walk: Traversal,
}

impl Lookup {
    pub(in crate::tracing) fn new(simd: SimdLevel) -> Self {
        Self { simd, list: Vec::new(), walk: Traversal::default() }
    }

    /// Nodes visited since the last call.
    pub(in crate::tracing) fn take_nodes_visited(&mut self) -> u64 {
        std::mem::take(&mut self.walk.nodes_visited)
    }

    /// Hands out lists of what the rays may meet, near things first; returns whether that was all of it.
    pub(super) fn sight(
        &mut self,
        scene: &PreparedScene,
        rays: &Bundle,
        try_list: impl FnMut(&[u32], Option<&Shaft>) -> Next,
    ) -> bool {
        self.hand_out(
            scene,
            rays.count,
            #[inline(always)]
            |bounds| Shaft::around_rays_in(bounds, &rays.rays[..rays.packets()], f64::INFINITY),
            |_| true,
            try_list,
        )
    }

    /// The same with what may stand in these ways to a light.
    pub(super) fn shadow(
        &mut self,
        scene: &PreparedScene,
        ways: &Ways,
        try_list: impl FnMut(&[u32], Option<&Shaft>) -> Next,
    ) -> bool {
        self.hand_out(
            scene,
            ways.lit.iter().map(|lit| lit.count() as usize).sum(),
            #[inline(always)]
            |bounds| ways.shaft(bounds),
            |id| scene.infos[id as usize].casts_shadow,
            try_list,
        )
    }

    fn hand_out(
        &mut self,
        scene: &PreparedScene,
        count: usize,
        shaft: impl FnOnce(&Aabb) -> Option<Shaft>,
        counts: impl Fn(u32) -> bool,
        mut try_list: impl FnMut(&[u32], Option<&Shaft>) -> Next,
    ) -> bool {
        let Self { simd, list, walk } = self;
        list.clear();
        if scene.primitives.len() <= FEW {
            list.extend((0..scene.primitives.len() as u32).filter(|&id| counts(id)));
            let _ = try_list(list, None);
            return true;
        }
        let SpatialIndex::Bvh(bvh) = &scene.index else { return false };
        if count < LEAST_RAYS {
            return false;
        }
        let shaft = simd.run(
            #[inline(always)]
            || shaft(&scene.bounds),
        );
        let Some(shaft) = shaft else { return false };
        // Single rays try all of these, wherever they are.
        list.extend(scene.outside.iter().filter(|&&id| counts(id)));
        let (mut spent, most) = (0, BOXES_PER_TRY * (MOST_TRIED + MOST_TRIED_PER_RAY * count));
        let mut is_over = false;
        bvh.touched_in_order(&shaft, walk, |id| {
            spent += 1;
            if spent > most {
                return Next::Break(());
            }
            if counts(id) && !shaft.misses(&scene.primitives[id as usize]) {
                list.push(id);
                spent += BOXES_PER_TRY;
            }
            if list.len() < BATCH {
                return ANYWHERE;
            }
            let next = try_list(list, Some(&shaft));
            list.clear();
            is_over = next.is_break();
            next
        });
        if spent > most {
            return false;
        }
        if !is_over && !list.is_empty() {
            let _ = try_list(list, Some(&shaft));
        }
        true
    }
}
