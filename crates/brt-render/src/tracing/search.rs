//! Which primitive does a ray meet?

use brt_geometry::{Ray, Traversal};

use crate::products::{Carrier, Counters, PreparedScene};

/// A primitive and the distance at which a ray meets it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Met {
    pub(crate) primitive: u32,
    pub(crate) t: f64,
}

impl Met {
    /// Nothing met yet before `t_max`.
    #[inline(always)]
    pub(crate) fn nothing_before(t_max: f64) -> Self {
        Self { primitive: u32::MAX, t: t_max }
    }

    /// Tests a primitive; keeps the nearer hit, of equally near ones that with the lower id.
    #[inline(always)]
    pub(crate) fn test(&mut self, scene: &PreparedScene, ray: &Ray, from: Carrier, id: u32) {
        let hit = scene.primitives[id as usize].first_hit(ray, scene.start(id, from));
        let is_nearer =
            hit.t < self.t || (hit.t == self.t && id < self.primitive && self.primitive != u32::MAX);
        if hit.found && is_nearer {
            *self = Self { primitive: id, t: hit.t };
        }
    }

    #[inline(always)]
    pub(crate) fn found(self) -> Option<Self> {
        (self.primitive != u32::MAX).then_some(self)
    }
}

/// A ray and what it left, on which it starts.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Leg {
    pub(crate) ray: Ray,
    pub(crate) from: Carrier,
}

impl Leg {
    /// Straight on from where this one has met something.
    pub(crate) fn beyond(&self, scene: &PreparedScene, met: Met) -> Self {
        Self { ray: Ray::new(self.ray.at(met.t), self.ray.direction), from: scene.carrier(met.primitive) }
    }
}

/// Searches primitives along rays.
pub(crate) struct Search<'a> {
    scene: &'a PreparedScene,
    walk: Traversal,
    primitive_tests: u64,
}

impl<'a> Search<'a> {
    pub(crate) fn new(scene: &'a PreparedScene) -> Self {
        Self { scene, walk: Traversal::default(), primitive_tests: 0 }
    }

    /// Moves the counts of tests and nodes.
    pub(crate) fn move_counts_to(&mut self, counters: &mut Counters) {
        counters.primitive_tests += std::mem::take(&mut self.primitive_tests);
        counters.nodes_visited += std::mem::take(&mut self.walk.nodes_visited);
    }

    /// Counts tests made elsewhere.
    #[inline(always)]
    pub(crate) fn count_tests(&mut self, count: u64) {
        self.primitive_tests += count;
    }

    /// The hit of a ray that leaves `from` with a primitive that it is known to meet.
    #[inline]
    pub(crate) fn known(&mut self, ray: &Ray, from: Carrier, id: u32) -> Met {
        self.primitive_tests += 1;
        let mut met = Met::nothing_before(f64::INFINITY);
        met.test(self.scene, ray, from, id);
        debug_assert_eq!(met.primitive, id, "a ray does not meet what it is known to meet");
        met
    }

    /// The nearest of these primitives ahead of a ray that leaves `from`.
    #[inline]
    pub(crate) fn closest_of(&mut self, ray: &Ray, from: Carrier, list: &[u32]) -> Option<Met> {
        self.primitive_tests += list.len() as u64;
        let mut best = Met::nothing_before(f64::INFINITY);
        list.iter().for_each(|&id| best.test(self.scene, ray, from, id));
        best.found()
    }

    /// The nearest of these primitives before `t_max`, all of which cast shadows, on a ray that leaves `from`.
    pub(crate) fn shadower_of(&mut self, ray: &Ray, from: Carrier, t_max: f64, list: &[u32]) -> Option<Met> {
        self.primitive_tests += list.len() as u64;
        let mut best = Met::nothing_before(t_max);
        list.iter().for_each(|&id| best.test(self.scene, ray, from, id));
        best.found()
    }

    /// Does one of these primitives, all of which cast shadows, stand before `t_max` on a ray that leaves `from`?
    #[inline]
    pub(crate) fn is_hidden_by(&mut self, ray: &Ray, from: Carrier, t_max: f64, list: &[u32]) -> bool {
        let (scene, tests) = (self.scene, &mut self.primitive_tests);
        list.iter().any(|&id| {
            *tests += 1;
            let hit = scene.primitives[id as usize].first_hit(ray, scene.start(id, from));
            hit.found && hit.t < t_max
        })
    }

    /// The nearest primitive ahead of a ray that leaves `from`.
    #[inline]
    pub(crate) fn closest(&mut self, ray: &Ray, from: Carrier) -> Option<Met> {
        self.nearest(ray, from, f64::INFINITY, |_| true)
    }

    /// The nearest of the primitives that pass ahead of a ray that leaves nothing.
    pub(crate) fn closest_that(&mut self, ray: &Ray, passes: impl Fn(u32) -> bool) -> Option<Met> {
        self.nearest(ray, Carrier::NOWHERE, f64::INFINITY, passes)
    }

    /// Of primitives that lie upon each other the next that the ray meets where it has met one, if it passes.
    ///
    /// A ray that has left a carrier meets nothing on it any more: this is how it gets from one of those that are partly
    /// there to the next.
    pub(crate) fn next_in_place(&mut self, leg: &Leg, met: Met, passes: impl Fn(u32) -> bool) -> Option<Met> {
        let scene = self.scene;
        let carrier = scene.carrier(met.primitive);
        scene.layered.binary_search(&carrier).ok()?;
        let comes_next = |id: u32| id > met.primitive && scene.carrier(id) == carrier && passes(id);
        self.nearest(&leg.ray, leg.from, met.t.next_up(), comes_next).filter(|next| next.t == met.t)
    }

    /// The nearest primitive before `t_max` that casts shadows, on a ray that leaves `from`.
    pub(crate) fn shadower(&mut self, ray: &Ray, from: Carrier, t_max: f64) -> Option<Met> {
        let scene = self.scene;
        self.nearest(ray, from, t_max, |id| scene.infos[id as usize].casts_shadow)
    }

    /// Does any primitive that casts shadows stand before `t_max` on a ray that leaves `from`?
    #[inline]
    pub(crate) fn is_hidden(&mut self, ray: &Ray, from: Carrier, t_max: f64) -> bool {
        let (scene, tests) = (self.scene, &mut self.primitive_tests);
        let mut hides = |id: u32| {
            *tests += 1;
            let hit = scene.primitives[id as usize].first_hit(ray, scene.start(id, from));
            hit.found && hit.t < t_max && scene.infos[id as usize].casts_shadow
        };
        scene.outside.iter().any(|&id| hides(id)) || scene.index.any(ray, t_max, &mut self.walk, hides)
    }

    #[inline(always)]
    fn nearest(&mut self, ray: &Ray, from: Carrier, t_max: f64, counts: impl Fn(u32) -> bool) -> Option<Met> {
        let (scene, tests) = (self.scene, &mut self.primitive_tests);
        let mut best = Met::nothing_before(t_max);
        let mut visit = |id: u32, best: &mut Met| {
            if counts(id) {
                *tests += 1;
                best.test(scene, ray, from, id);
            }
        };
        scene.outside.iter().for_each(|&id| visit(id, &mut best));
        scene.index.closest(ray, best.t, &mut self.walk, |id| {
            visit(id, &mut best);
            best.t
        });
        best.found()
    }
}
