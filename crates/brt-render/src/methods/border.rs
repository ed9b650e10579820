//! Border ray tracing (Hashimoto, Suenaga 1987). Paper: P3–P6, P17.
//!
//! The perspective image tells which surfaces a block shows. A block with one or two of them is judged region by region
//! on four traced samples; a region is interpolated if their ray histories are equal and their brightness is even
//! enough. Other blocks, and those with a region that failed, are divided.

use super::region::{Contents, Region, regions_of, rows};
use super::worker::{First, TileWorker};
use crate::filling::{LinearColor, fill_bilinear};
use crate::products::{Block, SampleState, StageClock, Tile};
use crate::settings::{BorderSettings, Judge, Regions};

/// Larger blocks with two surfaces are divided at once: near an outline shading bends most, and four samples say too
/// little of a large region there (`docs/notes/border.md`).
const LARGEST_WITH_TWO_SURFACES: u32 = 8;

/// A block and what is known of it on its level.
struct Candidate {
    block: Block,
    contents: Contents,
}

/// Renders a tile whose perspective image is painted. Goes through the blocks level by level: choose, trace, judge,
/// fill.
pub(crate) fn render_border(worker: &mut TileWorker, tile: &Tile, settings: &BorderSettings) {
    let mut clock = StageClock::start();
    let mut blocks = Block::cover(tile.width, tile.height, settings.block);
    let mut level = Vec::new();
    while !blocks.is_empty() {
        let contents = |b: &Block| match regions_of(b, tile, &worker.perspective, &worker.samples.state) {
            Contents::Two(_) if b.side() > LARGEST_WITH_TWO_SURFACES => Contents::Many,
            contents => contents,
        };
        level.clear();
        level.extend(blocks.drain(..).map(|block| Candidate { block, contents: contents(&block) }));
        worker.tracer.counters.blocks.judged += level.len() as u64;
        worker.lap(&mut clock, |c| &mut c.seconds.select);

        for candidate in &level {
            trace_chosen(worker, tile, candidate);
        }
        worker.lap(&mut clock, |c| &mut c.seconds.trace);

        // The smallest blocks are traced already: nothing of them is left to judge.
        for candidate in level.iter().filter(|candidate| !candidate.block.is_smallest()) {
            if !settle(worker, tile, candidate, settings) {
                worker.tracer.counters.blocks.divided += 1;
                blocks.extend(candidate.block.divide());
            }
        }
        worker.lap(&mut clock, |c| &mut c.seconds.fill);
    }
}

impl Contents {
    fn regions(&self) -> &[Region] {
        match self {
            Self::One(region) => std::slice::from_ref(region),
            Self::Two(regions) => regions,
            Self::Many => &[],
        }
    }
}

/// Traces the four samples of each region; all of a block that cannot be divided.
fn trace_chosen(worker: &mut TileWorker, tile: &Tile, candidate: &Candidate) {
    if candidate.block.is_smallest() {
        let pending =
            |[x, y]: &[u32; 2], w: &TileWorker| w.samples.state[tile.index(*x, *y)] == SampleState::Pending;
        for point in candidate.block.corners() {
            if pending(&point, worker) {
                worker.trace(tile, point[0], point[1], First::Shown);
            }
        }
        return;
    }
    for region in candidate.contents.regions().iter().filter(|r| r.is_pending) {
        for [x, y] in region.points {
            worker.trace(tile, x, y, First::Shown);
        }
    }
}

/// Fills the regions that can be; says whether none is left without colour.
fn settle(worker: &mut TileWorker, tile: &Tile, candidate: &Candidate, settings: &BorderSettings) -> bool {
    let Candidate { block, contents } = candidate;
    let verdict = |r: &Region| !r.is_pending || is_even(worker, tile, r, &settings.judge);
    let verdicts = match contents {
        Contents::One(region) => [verdict(region), true],
        Contents::Two([a, b]) => [verdict(a), verdict(b)],
        Contents::Many => return false,
    };
    let all = verdicts[0] && verdicts[1];
    if settings.regions == Regions::Together && !all {
        return false;
    }
    for (region, even) in contents.regions().iter().zip(verdicts) {
        if region.is_pending && even {
            fill_region(worker, tile, block, region);
            worker.tracer.counters.blocks.filled += 1;
        }
    }
    all
}

fn is_even(worker: &TileWorker, tile: &Tile, region: &Region, judge: &Judge) -> bool {
    let samples = &worker.samples;
    let chosen = region.points.map(|[x, y]| tile.index(x, y));
    let history = samples.history[chosen[0]];
    chosen.iter().all(|&i| samples.history[i] == history) && judge.accepts(&chosen.map(|i| samples.color[i]))
}

fn fill_region(worker: &mut TileWorker, tile: &Tile, block: &Block, region: &Region) {
    if region.is_whole {
        fill_bilinear(tile, &mut worker.samples, block);
        worker.note_history(tile, block, region.points[0]);
        return;
    }
    let samples = &mut worker.samples;
    let color = LinearColor::through(tile, samples, &region.points);
    let [x, y] = region.points[0];
    let first = tile.index(x, y);
    let history = samples.history[first];
    let alpha = samples.alpha.as_ref().map(|alpha| alpha[first]);
    for (y, row) in (block.y0..).zip(rows(block, tile)) {
        let start = row.start;
        for i in row {
            if worker.perspective.surface[i] == region.surface && samples.state[i] == SampleState::Pending {
                samples.color[i] = color.at(block.x0 + (i - start) as u32, y);
                samples.state[i] = SampleState::Filled;
                samples.history[i] = history;
                if let (Some(all), Some(alpha)) = (&mut samples.alpha, alpha) {
                    all[i] = alpha;
                }
            }
        }
    }
}
