//! Certified ray tracing: what is not traced is proven. Answers the paper's own future work.
//! Paper: P17, P19, P20.
//!
//! A block of samples that show one primitive is followed along its mirror rays, level by level, as Taylor models
//! ([`follow`]). At each level certificates try to prove what every ray of the block meets and which lights it sees
//! ([`certificates`]). A block whose history is proven gets a colour model, and is filled where that is linear within
//! the tolerance. What is not proven for a block is tried again for its quarters, which inherit every proof and every
//! list of candidates. Small blocks are traced, guided by what is proven; where everything is, no ray searches. Smooth
//! meshes are filled across their triangles instead ([`sheet`]).

mod candidates;
mod certificates;
mod follow;
mod known_history;
mod paint;
mod regions;
mod rest;
mod sheet;

use brt_geometry::Taylor;
use brt_image::Rgb;

pub(crate) use self::certificates::Tolerance;
use self::follow::{Follower, Outcome};
use self::known_history::KnownHistory;
use self::regions::{Region, regions_of, samples_of};
use self::rest::Rest;
use super::worker::TileWorker;
use crate::products::{Area, Certificate, NOTHING, PreparedScene, Seconds, StageClock, Tile};

/// Blocks of this side and less whose history is not proven are traced.
const LEAF: u32 = 16;

/// Where a linear colour would hold over fewer samples along a side, single samples are shaded instead.
const LEAST_EVEN: f64 = 3.0;

/// Fewer samples are traced: proofs would cost more.
const LEAST_PROVEN: u32 = 48;

/// As many rays look up together what they meet next.
const LEAST_TOGETHER: u32 = 12;

/// A tile with more small parts than this shows a fine mesh, or something like it.
const FEW_PARTS: usize = 64;

/// Renders a tile whose perspective image is painted.
pub(crate) fn render_certified(
    worker: &mut TileWorker,
    tile: &Tile,
    scene: &PreparedScene,
    tolerance: Tolerance,
    max_depth: u32,
) {
    let clock = StageClock::start();
    let regions = regions_of(&worker.perspective, tile);
    let follower = Follower::new(scene, worker.camera, max_depth);
    let groups = || regions.chunk_by(|a, b| a.primitive == b.primitive);
    let has_few_parts = groups().filter(|group| samples_of(group) < LEAST_PROVEN).count() <= FEW_PARTS;
    let rest = Rest::default();
    let mut method = Certified { worker, tile, follower, tolerance, clock, has_few_parts, rest };
    let area = tile.area();
    for group in groups() {
        method.settle_group(area, group);
    }
    method.lap(|seconds| &mut seconds.select);
    method.trace_rest();
    method.trace_doubtful();
    let counts = method.follower.counts;
    worker.tracer.counters.certificates += counts;
}

/// One tile at work.
struct Certified<'w, 'a> {
    worker: &'w mut TileWorker<'a>,
    tile: &'w Tile,
    follower: Follower<'w>,
    tolerance: Tolerance,
    clock: StageClock,
    /// Are there few primitives that it shows little of?
    has_few_parts: bool,
    /// What is left for the end.
    rest: Rest,
}

/// Which samples of an area show the primitive.
#[derive(Clone, Copy)]
enum Parts<'r> {
    All,
    Regions(&'r [Region]),
}

impl Certified<'_, '_> {
    /// Adds the time since the last lap to a stage.
    fn lap(&mut self, stage: impl FnOnce(&mut Seconds) -> &mut f64) {
        self.clock.lap(stage(&mut self.worker.tracer.counters.seconds));
    }

    /// Gives all samples of one primitive their colours.
    fn settle_group(&mut self, area: Area, group: &[Region]) {
        let primitive = group[0].primitive;
        if primitive == NOTHING {
            let background = crate::tracing::constant(self.worker.tracer.color_of_nothing());
            return self.fill(area, Parts::Regions(group), primitive, &background);
        }
        let samples = samples_of(group);
        let is_left = samples < LEAST_PROVEN && !self.goes_alone(primitive, samples);
        if is_left || sheet::is_of_sheet(self.follower.scene, primitive) {
            // Left for the end, where it is filled or traced together with its neighbours.
            group.iter().for_each(|region| self.rest.add(self.tile, &region.area));
            return;
        }
        let is_clear = self.worker.perspective.clear.binary_search(&primitive).is_ok();
        self.settle(area, Parts::Regions(group), &KnownHistory::starting_with(primitive, is_clear));
    }

    /// Is it worth while to trace so few samples of a primitive without their neighbours? What is mirrored or lit lies
    /// together then; parts of a mesh lie together anyway, but for what they mirror.
    fn goes_alone(&self, primitive: u32, samples: u32) -> bool {
        let scene = self.follower.scene;
        let material = scene.infos[primitive as usize].material;
        let mirrors = scene.materials[material as usize].reflection > 0.0;
        samples >= LEAST_TOGETHER && (mirrors || self.has_few_parts)
    }

    fn settle(&mut self, area: Area, parts: Parts, inherited: &KnownHistory) {
        if self.worker.cancel.is_set() {
            return;
        }
        // What lies around the parts would only spoil the bounds.
        let area = match parts {
            Parts::Regions(regions) => regions::smallest_around(regions, area),
            Parts::All => area,
        };
        let parts = match parts {
            Parts::Regions([one]) if one.area == area && one.is_whole() => Parts::All,
            parts => parts,
        };
        if matches!(parts, Parts::Regions(few) if samples_of(few) < LEAST_PROVEN) {
            return self.trace(area, parts, inherited, Certificate::Size);
        }
        let lists = self.follower.candidates.lists.mark();
        let lightings = self.follower.lightings.mark();
        let mut history = *inherited;
        let counts = &mut self.worker.tracer.counters.blocks;
        counts.judged += 1;
        match self.follower.follow(area, &mut history) {
            Outcome::Open(failed) if area.is_within(LEAF) => self.trace(area, parts, &history, failed),
            Outcome::Open(_) => self.divide(area, parts, &history),
            Outcome::Proven(None) if area.is_within(LEAF) => {
                self.shade(area, parts, &history, Certificate::Checker);
            }
            Outcome::Proven(None) => self.divide(area, parts, &history),
            Outcome::Proven(Some(color)) => self.color(area, parts, &history, &color),
        }
        self.follower.candidates.lists.release(lists);
        self.follower.lightings.release(lightings);
    }

    /// The history is proven and the colour bounded.
    fn color(&mut self, area: Area, parts: Parts, history: &KnownHistory, color: &Rgb<Taylor>) {
        let excess = self.tolerance.excess(color);
        if self.follower.counts.note(Certificate::Color, excess <= 1.0) {
            self.worker.tracer.counters.blocks.filled += 1;
            return self.fill(area, parts, history.first(), color);
        }
        // The remainder grows with the square of the side; in large blocks with more.
        let side = f64::from((area.x1 - area.x0).max(area.y1 - area.y0));
        let is_too_steep = area.is_within(LEAF) && side < LEAST_EVEN * excess.sqrt();
        if is_too_steep || area.is_within(2) {
            self.shade(area, parts, history, Certificate::Color);
        } else {
            self.divide(area, parts, history);
        }
    }

    fn divide(&mut self, area: Area, parts: Parts, history: &KnownHistory) {
        self.worker.tracer.counters.blocks.divided += 1;
        for quarter in area.quarters() {
            match parts {
                Parts::All => self.settle(quarter, parts, history),
                // A part of a leaf of the perspective image has no parts of its own.
                Parts::Regions([one]) if one.area == area => {
                    let part = regions::part_of(one, quarter, &self.worker.perspective, self.tile);
                    if part.samples > 0 {
                        self.settle(quarter, Parts::Regions(&[part]), history);
                    }
                }
                Parts::Regions(regions) => {
                    let inside = regions::inside(regions, quarter);
                    if !inside.is_empty() {
                        self.settle(quarter, Parts::Regions(inside), history);
                    }
                }
            }
        }
    }
}
