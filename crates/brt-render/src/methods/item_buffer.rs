//! Ray tracing with an item buffer (Weghorst, Hooper, Greenberg 1984): the first hit is read from the perspective image,
//! everything after it is traced. Paper: P1, P10.

use super::worker::{First, TileWorker};
use crate::products::{StageClock, Tile};

/// Traces all samples of a tile whose perspective image is painted.
pub(crate) fn render_item_buffer(worker: &mut TileWorker, tile: &Tile) {
    let mut clock = StageClock::start();
    for y in 0..tile.height {
        for x in 0..tile.width {
            worker.trace(tile, x, y, First::Shown);
        }
    }
    worker.lap(&mut clock, |c| &mut c.seconds.trace);
}
