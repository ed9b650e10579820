//! What every method works with on a tile: samples that are traced at most once.

use brt_geometry::{LANES, LaneRays, Lanes, Ray, SimdLevel};

use crate::job::Job;
use crate::prepare::PreparedCamera;
use crate::products::{
    Block, Counters, NOTHING, PerspectiveImage, SampleState, StageClock, Tile, TileSamples,
};
use crate::run::{Cancel, RayOrder, Run};
use crate::settings::{Layer, Settings};
use crate::tracing::{Bundle, Colors, Guide, MOST_RAYS, NO_COLORS, Sight, Tracer, Unguided, color_at};

/// A thread's tracer and buffers, reused from tile to tile.
pub(crate) struct TileWorker<'a> {
    pub(crate) tracer: Tracer<'a>,
    pub(crate) camera: &'a PreparedCamera,
    pub(crate) samples: TileSamples,
    pub(crate) perspective: PerspectiveImage,
    /// Are histories of filled samples wanted?
    pub(crate) wants_histories: bool,
    /// Is it to be shown which certificates failed?
    pub(crate) wants_causes: bool,
    /// How all samples are traced where no method chooses.
    pub(crate) rays: RayOrder,
    pub(crate) simd: SimdLevel,
    pub(crate) cancel: Cancel<'a>,
    bundle: Bundle,
    colors: Colors,
}

/// Where a first hit comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum First {
    /// From a search along the ray.
    Searched,
    /// From the perspective image.
    Shown,
}

impl<'a> TileWorker<'a> {
    /// Makes all samples of a tile pending.
    pub(crate) fn reset(&mut self, tile: &Tile) {
        self.samples.reset(tile);
        if self.wants_causes {
            self.samples.cause.clear();
            self.samples.cause.resize(tile.sample_count(), None);
        }
    }

    pub(crate) fn new(job: &Job<'a>, run: &Run<'a>) -> Self {
        let Settings { history, layers, backdrop, .. } = job.settings;
        let wants_histories = layers.contains(&Layer::History);
        Self {
            tracer: Tracer::new(job.scene, *history, job.max_depth, *backdrop, run.simd),
            camera: job.camera,
            samples: TileSamples { alpha: backdrop.has_alpha().then(Vec::new), ..TileSamples::default() },
            perspective: PerspectiveImage::default(),
            wants_histories,
            wants_causes: layers.contains(&Layer::Certificates),
            rays: if wants_histories { RayOrder::Single } else { run.rays },
            simd: run.simd,
            cancel: run.cancel(),
            bundle: Bundle::default(),
            colors: NO_COLORS,
        }
    }

    /// Traces a sample of the tile unless that was done before.
    #[inline]
    pub(super) fn trace(&mut self, tile: &Tile, x: u32, y: u32, first: First) {
        self.trace_guided(tile, x, y, first, Unguided);
    }

    /// The same, knowing something of what follows from the first hit.
    #[inline]
    pub(super) fn trace_guided(&mut self, tile: &Tile, x: u32, y: u32, first: First, guide: impl Guide) {
        let index = tile.index(x, y);
        if self.samples.state[index] == SampleState::Traced || self.cancel.is_set() {
            return;
        }
        let first = match first {
            First::Searched => Sight::Unknown,
            First::Shown => Sight::Met(self.perspective.primitive[index]),
        };
        let ray = self.camera.sample_ray([tile.x + x, tile.y + y]);
        let traced = self.tracer.trace(&ray, first, guide);
        self.samples.color[index] = traced.color.to_f32();
        if let Some(alpha) = &mut self.samples.alpha {
            alpha[index] = traced.alpha;
        }
        self.samples.history[index] = traced.history;
        self.samples.state[index] = SampleState::Traced;
    }

    /// Traces up to [`MOST_RAYS`] samples together, by column and row of the tile; gives each
    /// its colour and this state.
    pub(super) fn trace_samples(
        &mut self,
        tile: &Tile,
        samples: &[[u32; 2]],
        first: Sight,
        guide: impl Guide,
        state: SampleState,
    ) {
        if self.cancel.is_set() {
            return;
        }
        self.aim(tile, samples);
        self.tracer.trace_bundle(&self.bundle, first, guide, &mut self.colors);
        self.keep_colors(tile, samples, state);
    }

    /// The same for samples whose first hits the perspective image shows.
    pub(super) fn trace_shown_samples(&mut self, tile: &Tile, samples: &[[u32; 2]]) {
        if self.cancel.is_set() {
            return;
        }
        self.aim(tile, samples);
        let mut shown = [NOTHING; MOST_RAYS];
        for (shown, &[x, y]) in shown.iter_mut().zip(samples) {
            *shown = self.perspective.primitive[tile.index(x, y)];
        }
        self.tracer.trace_known_bundle(&self.bundle, &shown[..samples.len()], &mut self.colors);
        self.keep_colors(tile, samples, SampleState::Traced);
    }

    /// Makes the rays of samples.
    fn aim(&mut self, tile: &Tile, samples: &[[u32; 2]]) {
        let Self { camera, bundle, simd, .. } = self;
        let last = samples.len() - 1;
        simd.run(
            #[inline(always)]
            || {
                bundle.set(
                    samples.len(),
                    #[inline(always)]
                    |packet| {
                        let at = |lane: usize| {
                            let [x, y] = samples[(packet * LANES + lane).min(last)];
                            camera.pattern.position([tile.x + x, tile.y + y])
                        };
                        let x = Lanes::from_fn(|lane| at(lane)[0]);
                        let y = Lanes::from_fn(|lane| at(lane)[1]);
                        let Ray { origin, direction, .. } = camera.ray(x, y);
                        LaneRays { origin, direction }
                    },
                );
            },
        );
    }

    fn keep_colors(&mut self, tile: &Tile, samples: &[[u32; 2]], state: SampleState) {
        for (i, &[x, y]) in samples.iter().enumerate() {
            let index = tile.index(x, y);
            self.samples.color[index] = color_at(&self.colors, i).to_f32();
            self.samples.state[index] = state;
        }
        if let Some(alpha) = &mut self.samples.alpha {
            for (&[x, y], traced) in samples.iter().zip(self.tracer.alphas()) {
                alpha[tile.index(x, y)] = *traced;
            }
        }
    }

    /// Leaves those samples open that see nothing by the perspective image, however they will be filled. The others are
    /// covered, unless a ray finds a way through.
    pub(crate) fn open_background(&mut self) {
        let Some(alpha) = &mut self.samples.alpha else { return };
        for (alpha, &primitive) in alpha.iter_mut().zip(&self.perspective.primitive) {
            if primitive == NOTHING {
                *alpha = 0.0;
            }
        }
    }

    /// Traces a sample for nothing but its history. Its rays are not counted.
    pub(super) fn note_history_of(&mut self, tile: &Tile, x: u32, y: u32) {
        let index = tile.index(x, y);
        let ray = self.camera.sample_ray([tile.x + x, tile.y + y]);
        let first = Sight::Met(self.perspective.primitive[index]);
        let counted = self.tracer.take_counters();
        self.samples.history[index] = self.tracer.trace(&ray, first, Unguided).history;
        self.tracer.take_counters();
        self.tracer.counters = counted;
    }

    /// Gives the filled samples of a block the history of the sample that they were filled from, if that is wanted.
    pub(super) fn note_history(&mut self, tile: &Tile, block: &Block, [x, y]: [u32; 2]) {
        if !self.wants_histories {
            return;
        }
        let history = self.samples.history[tile.index(x, y)];
        for y in block.y0..=block.y1 {
            for x in block.x0..=block.x1 {
                let index = tile.index(x, y);
                if self.samples.state[index] == SampleState::Filled {
                    self.samples.history[index] = history;
                }
            }
        }
    }

    /// Adds the time since the last lap to one of the stages.
    pub(super) fn lap(&mut self, clock: &mut StageClock, stage: impl FnOnce(&mut Counters) -> &mut f64) {
        clock.lap(stage(&mut self.tracer.counters));
    }
}
