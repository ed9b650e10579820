//! Counts and times of a rendering.

use std::ops::AddAssign;
use std::time::Instant;

use super::{CertificateCounts, SampleState};

/// Everything counted while a picture was rendered. Counts are the same for every number of threads.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stats {
    /// Times, in seconds summed over threads for stages, by the clock for `prepare` and `render`.
    pub seconds: Seconds,
    /// Samples by state.
    pub pixels: PixelCounts,
    /// Rays by kind.
    pub rays: RayCounts,
    /// Tests of a ray with a primitive.
    pub primitive_tests: u64,
    /// Nodes of the BVH visited by rays.
    pub nodes_visited: u64,
    /// Blocks by outcome.
    pub blocks: BlockCounts,
    /// What certified ray tracing tried to prove.
    pub certificates: CertificateCounts,
}

/// Times in seconds.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Seconds {
    /// Flattening the scene, building the BVH.
    pub prepare: f64,
    /// Perspective image.
    pub perspective: f64,
    /// Choosing samples and judging blocks.
    pub select: f64,
    /// Tracing.
    pub trace: f64,
    /// Filling.
    pub fill: f64,
    /// All of these by the clock, from the first to the last row that the sink took.
    pub render: f64,
}

/// Samples by state.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PixelCounts {
    /// All of them.
    pub total: u64,
    /// Computed by searching rays.
    pub traced: u64,
    /// Computed by shading a known history.
    pub shaded: u64,
    /// Computed by a colour function over a block.
    pub filled: u64,
}

/// Rays by kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RayCounts {
    /// From the eye: one per traced sample.
    pub camera: u64,
    /// Towards lights.
    pub shadow: u64,
    /// Reflected.
    pub mirror: u64,
    /// Refracted.
    pub refracted: u64,
}

impl RayCounts {
    /// All rays.
    pub fn total(&self) -> u64 {
        self.camera + self.shadow + self.mirror + self.refracted
    }
}

/// Blocks by outcome.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct BlockCounts {
    /// Looked at.
    pub judged: u64,
    /// Filled as a whole or in one of their regions.
    pub filled: u64,
    /// Divided.
    pub divided: u64,
}

/// What one worker counts.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Counters {
    pub(crate) rays: RayCounts,
    pub(crate) primitive_tests: u64,
    pub(crate) nodes_visited: u64,
    pub(crate) blocks: BlockCounts,
    pub(crate) certificates: CertificateCounts,
    pub(crate) pixels: PixelCounts,
    pub(crate) seconds: Seconds,
}

impl Counters {
    /// Counts the finished samples of a tile.
    pub(crate) fn count_states(&mut self, states: &[SampleState]) {
        debug_assert!(!states.contains(&SampleState::Pending), "a sample was left without colour");
        // The compiler counts bytes many at a time if a count fits one too.
        let count_in = |part: &[SampleState], state| part.iter().map(|&s| u8::from(s == state)).sum::<u8>();
        let count = |state| states.chunks(255).map(|part| u64::from(count_in(part, state))).sum::<u64>();
        let (traced, shaded) = (count(SampleState::Traced), count(SampleState::Shaded));
        self.pixels.total += states.len() as u64;
        self.pixels.traced += traced;
        self.pixels.shaded += shaded;
        self.pixels.filled += states.len() as u64 - traced - shaded;
    }
}

impl AddAssign for Counters {
    fn add_assign(&mut self, o: Self) {
        self.rays.camera += o.rays.camera;
        self.rays.shadow += o.rays.shadow;
        self.rays.mirror += o.rays.mirror;
        self.rays.refracted += o.rays.refracted;
        self.primitive_tests += o.primitive_tests;
        self.nodes_visited += o.nodes_visited;
        self.blocks.judged += o.blocks.judged;
        self.blocks.filled += o.blocks.filled;
        self.blocks.divided += o.blocks.divided;
        self.certificates += o.certificates;
        self.pixels.total += o.pixels.total;
        self.pixels.traced += o.pixels.traced;
        self.pixels.shaded += o.pixels.shaded;
        self.pixels.filled += o.pixels.filled;
        self.seconds.perspective += o.seconds.perspective;
        self.seconds.select += o.seconds.select;
        self.seconds.trace += o.seconds.trace;
        self.seconds.fill += o.seconds.fill;
    }
}

impl Stats {
    /// The sum of what workers counted.
    pub(crate) fn of(counters: &Counters) -> Self {
        Self {
            seconds: counters.seconds,
            pixels: counters.pixels,
            rays: counters.rays,
            primitive_tests: counters.primitive_tests,
            nodes_visited: counters.nodes_visited,
            blocks: counters.blocks,
            certificates: counters.certificates,
        }
    }
}

/// Attributes elapsed time to stages, one after the other.
pub(crate) struct StageClock(Instant);

impl StageClock {
    pub(crate) fn start() -> Self {
        Self(Instant::now())
    }

    /// Adds the time since the last call to a stage.
    pub(crate) fn lap(&mut self, stage: &mut f64) {
        let now = Instant::now();
        *stage += (now - self.0).as_secs_f64();
        self.0 = now;
    }
}
