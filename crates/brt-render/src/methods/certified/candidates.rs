//! Lists of primitives that the rays of a block may meet. A block's lists are filtered from its parent's.

use brt_geometry::{Shaft, SpatialIndex, Taylor, Vec3};

use crate::products::PreparedScene;

/// Longer lists are not kept: smaller blocks have shorter ones.
pub(super) const MOST_LISTED: usize = 32;

/// A list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct List {
    first: u32,
    count: u32,
}

/// All lists of the blocks that are open, each block's behind its parent's.
#[derive(Debug, Default)]
pub(super) struct Lists {
    items: Vec<u32>,
}

impl Lists {
    pub(super) fn get(&self, list: List) -> &[u32] {
        &self.items[list.first as usize..(list.first + list.count) as usize]
    }

    /// For [`Self::release`].
    pub(super) fn mark(&self) -> usize {
        self.items.len()
    }

    /// Forgets all lists made since the mark.
    pub(super) fn release(&mut self, mark: usize) {
        self.items.truncate(mark);
    }

    /// Keeps these as a list.
    pub(super) fn keep(&mut self, items: impl Iterator<Item = u32>) -> List {
        let first = self.items.len();
        self.items.extend(items);
        let first_id = u32::try_from(first).expect("so many candidates would fill 16 GiB");
        List { first: first_id, count: (self.items.len() - first) as u32 }
    }
}

/// What the rays of a block may meet.
pub(super) struct Candidates<'a> {
    pub(super) scene: &'a PreparedScene,
    pub(super) lists: Lists,
    /// Those of the shaft that was looked into last.
    pub(super) found: Vec<u32>,
}

impl<'a> Candidates<'a> {
    pub(super) fn new(scene: &'a PreparedScene) -> Self {
        Self { scene, lists: Lists::default(), found: Vec::new() }
    }

    /// Keeps those found as a list.
    pub(super) fn keep_found(&mut self) -> List {
        self.lists.keep(self.found.drain(..))
    }

    /// The shaft of rays up to distance `end`, wide enough for all that rays are said to hit.
    pub(super) fn shaft(&self, origin: &Vec3<Taylor>, direction: &Vec3<Taylor>, end: f64) -> Option<Shaft> {
        Shaft::around_in(&self.scene.bounds, origin, direction, end)
    }

    /// Finds what a shaft may touch of a list, or of the whole scene, and `passes`; returns whether that is everything
    /// there is, which it is not where there are more than `most`.
    pub(super) fn find(
        &mut self,
        shaft: &Shaft,
        from: Option<List>,
        most: usize,
        passes: impl Fn(u32) -> bool,
    ) -> bool {
        let Self { scene, lists, found } = self;
        found.clear();
        let mut visit = |id: u32| {
            if passes(id) && !shaft.misses(&scene.primitives[id as usize]) {
                found.push(id);
            }
            found.len() <= most
        };
        if let Some(list) = from {
            return lists.get(list).iter().all(|&id| visit(id));
        }
        scene.outside.iter().all(|&id| visit(id))
            && match &scene.index {
                SpatialIndex::Bvh(bvh) => bvh.touched_by(shaft, visit),
                _ => (0..scene.primitives.len() as u32)
                    .filter(|id| scene.primitives[*id as usize].bounds().is_some())
                    .all(visit),
            }
    }
}
