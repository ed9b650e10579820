//! Standard ray tracing: every sample.

use super::worker::{First, TileWorker};
use crate::products::{PreparedScene, SampleState, StageClock, Tile};
use crate::tracing::reference_sample;

/// Traces all samples of a tile.
pub(crate) fn render_full(worker: &mut TileWorker, tile: &Tile) {
    let mut clock = StageClock::start();
    for y in 0..tile.height {
        trace_row(worker, tile, y);
    }
    worker.lap(&mut clock, |c| &mut c.seconds.trace);
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
            let ray = worker.camera.ray(f64::from(tile.x + x), f64::from(tile.y + y));
            let index = tile.index(x, y);
            worker.samples.color[index] = reference_sample(scene, &ray, max_depth).to_f32();
            worker.samples.state[index] = SampleState::Traced;
        }
    }
}
