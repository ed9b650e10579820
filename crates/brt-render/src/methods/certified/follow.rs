//! Following a block along its mirror rays.

use brt_geometry::{RayBlock, Real, Taylor};
use brt_image::Rgb;

use super::candidates::Candidates;
use super::certificates::{Clear, cell_color, first_seen, lighting};
use super::known_history::{KnownHistory, KnownLighting, KnownSight, Level, Lightings, MOST_LEVELS};
use crate::prepare::PreparedCamera;
use crate::products::{Area, Carrier, Certificate, CertificateCounts, NOTHING, PreparedScene};
use crate::tracing::{Patch, constant};

/// What became of a block.
pub(super) enum Outcome {
    /// Its history is not proven; this failed.
    Open(Certificate),
    /// Its history is proven; the colour, where all body colours are.
    Proven(Option<Rgb<Taylor>>),
}

/// Follows blocks; keeps what they may meet.
pub(super) struct Follower<'a> {
    pub(super) scene: &'a PreparedScene,
    pub(super) candidates: Candidates<'a>,
    pub(super) lightings: Lightings,
    pub(super) counts: CertificateCounts,
    camera: &'a PreparedCamera,
    max_depth: u32,
}

/// A block on its way: colours of its levels without what mirrors add, and what was not proven.
struct Way {
    colors: [Option<(Rgb<Taylor>, f64)>; MOST_LEVELS],
    is_bounded: bool,
    failed: Option<Certificate>,
}

impl<'a> Follower<'a> {
    pub(super) fn new(scene: &'a PreparedScene, camera: &'a PreparedCamera, max_depth: u32) -> Self {
        let candidates = Candidates::new(scene);
        let lightings = Lightings::new(scene.lights.len());
        Self { scene, candidates, lightings, counts: CertificateCounts::default(), camera, max_depth }
    }

    /// Proves what can be proven of a block, given what is known already.
    pub(super) fn follow(&mut self, area: Area, history: &mut KnownHistory) -> Outcome {
        let mut block = RayBlock::new(self.camera.block(&area));
        let mut from = Carrier::NOWHERE;
        let mut left: Option<Clear> = None;
        let mut way = Way { colors: [None; MOST_LEVELS], is_bounded: true, failed: None };
        for (depth, level) in history.levels.iter_mut().enumerate() {
            let Some(primitive) = self.met(level, &block, from, left.as_ref()) else {
                return Outcome::Open(way.failed.unwrap_or(Certificate::Visibility));
            };
            if primitive == NOTHING {
                return way.ended(depth, constant(self.scene.background));
            }
            let Some(patch) = self.patch(&block, primitive, from) else {
                return Outcome::Open(way.failed.unwrap_or(Certificate::Surface));
            };
            let is_clear = history.is_clear && depth == 0;
            left = is_clear.then(|| Clear::of(self.scene, &patch, &block.ray, self.camera.eye)).flatten();
            let color = self.local_color(level, &patch, left.as_ref(), &mut way);
            if patch.material.reflection == 0.0 || depth as u32 >= self.max_depth {
                return way.ended(depth, color);
            }
            way.colors[depth] = Some((color, patch.material.reflection));
            block = RayBlock::new(patch.mirror_ray(&block.ray));
            from = patch.carrier;
        }
        Outcome::Open(way.failed.unwrap_or(Certificate::Size))
    }

    /// What all rays meet.
    fn met(
        &mut self,
        level: &mut Level,
        block: &RayBlock,
        from: Carrier,
        left: Option<&Clear>,
    ) -> Option<u32> {
        if let KnownSight::Met(primitive) = level.sight {
            return Some(primitive);
        }
        level.sight = first_seen(&mut self.candidates, block, from, left, level.sight);
        let met = if let KnownSight::Met(primitive) = level.sight { Some(primitive) } else { None };
        self.counts.note(Certificate::Visibility, met.is_some());
        met
    }

    /// The points where all rays meet a primitive.
    fn patch(&mut self, block: &RayBlock, primitive: u32, from: Carrier) -> Option<Patch<'a>> {
        let t = block.distance(&self.scene.primitives[primitive as usize], self.scene.start(primitive, from));
        let patch = Patch::at(self.scene, &block.ray, primitive, t);
        let patch = patch.filter(|patch| patch.material.ends_view());
        self.counts.note(Certificate::Surface, patch.is_some());
        patch
    }

    /// The colour of a level without what mirrors add; it only means something while all is proven.
    fn local_color(
        &mut self,
        level: &mut Level,
        patch: &Patch,
        left: Option<&Clear>,
        way: &mut Way,
    ) -> Rgb<Taylor> {
        let body = cell_color(patch.material, &patch.point);
        if patch.material.checker.is_some() {
            way.is_bounded &= self.counts.note(Certificate::Checker, body.is_some());
        }
        let body = body.unwrap_or(patch.material.color);
        let mut color = patch.ambient(body);
        let lights = self.lightings.inherit(level.lights);
        level.lights = Some(lights);
        for (index, light) in self.scene.lights.iter().enumerate() {
            let mut known = self.lightings.of(lights, index);
            let is_colored = way.failed.is_none() && way.is_bounded;
            if known.is_settled() && !(is_colored && matches!(known, KnownLighting::Seen)) {
                continue;
            }
            let ways = patch.ways_to(light);
            if !known.is_settled() {
                known = lighting(&mut self.candidates, patch, left, light, &ways, known);
                self.lightings.set(lights, index, known);
                if !self.counts.note(Certificate::Shadow, known.is_settled()) {
                    way.failed = way.failed.or(Some(Certificate::Shadow));
                }
            }
            if matches!(known, KnownLighting::Seen) && way.failed.is_none() && way.is_bounded {
                color = color + patch.reflected(body, light, &ways);
            }
        }
        color
    }
}

impl Way {
    /// The colour of the whole, given that of the last level.
    fn ended(&self, depth: usize, last: Rgb<Taylor>) -> Outcome {
        if let Some(certificate) = self.failed {
            return Outcome::Open(certificate);
        }
        if !self.is_bounded {
            return Outcome::Proven(None);
        }
        let above = self.colors[..depth].iter().flatten();
        let fold = |seen: Rgb<Taylor>, (local, reflection): &(Rgb<Taylor>, f64)| {
            *local + seen * Taylor::constant(*reflection)
        };
        Outcome::Proven(Some(above.rev().fold(last, fold)))
    }
}
