//! Standard ray tracing: every sample.

use std::ops::Range;

use super::worker::{First, TileWorker};
use crate::products::{PreparedScene, SampleState, StageClock, Tile};
use crate::run::RayOrder;
use crate::tracing::{MOST_RAYS, Sight, Unguided, reference_sample};

/// Traces all samples of a tile.
pub(crate) fn render_full(worker: &mut TileWorker, tile: &Tile) {
    let mut clock = StageClock::start();
    match worker.rays {
        RayOrder::Single => (0..tile.height).for_each(|y| trace_row(worker, tile, y)),
        RayOrder::Bundled => trace_squares(worker, tile),
    }
    worker.lap(&mut clock, |c| &mut c.seconds.trace);
}

/// Samples are traced together in squares of this side.
const SIDE: u32 = 8;

fn trace_squares(worker: &mut TileWorker, tile: &Tile) {
    for y in (0..tile.height).step_by(SIDE as usize) {
        let rows = y..(y + SIDE).min(tile.height);
        for x in (0..tile.width).step_by(SIDE as usize) {
            trace_together(worker, tile, x..(x + SIDE).min(tile.width), rows.clone());
        }
    }
}

/// Traces a small rectangle of samples.
fn trace_together(worker: &mut TileWorker, tile: &Tile, columns: Range<u32>, rows: Range<u32>) {
    let (mut samples, mut count) = ([[0; 2]; MOST_RAYS], 0);
    for row in rows {
        for column in columns.clone() {
            samples[count] = [column, row];
            count += 1;
        }
    }
    worker.trace_samples(tile, &samples[..count], Sight::Unknown, Unguided, SampleState::Traced);
}

/// Traces all samples in a row of a tile.
pub(crate) fn trace_row(worker: &mut TileWorker, tile: &Tile, y: u32) {
    for x in 0..tile.width {
        worker.trace(tile, x, y, First::Searched);
    }
}

/// The same by the oracle, which counts nothing but samples.
pub(crate) fn render_reference(worker: &mut TileWorker, tile: &Tile, scene: &PreparedScene, max_depth: u32) {
    for y in 0..tile.height {
        for x in 0..tile.width {
            if worker.cancel.is_set() {
                return;
            }
            let ray = worker.camera.sample_ray([tile.x + x, tile.y + y]);
            let index = tile.index(x, y);
            let background = worker.tracer.color_of_nothing();
            let (color, share) = reference_sample(scene, &ray, max_depth, background);
            worker.samples.color[index] = color.to_f32();
            if let Some(alpha) = &mut worker.samples.alpha {
                alpha[index] = (1.0 - share) as f32;
            }
            worker.samples.state[index] = SampleState::Traced;
        }
    }
}
