//! Pixel-selected ray tracing, PSRT (Akimoto, Mase 1986; Akimoto, Mase, Suenaga 1991). Paper: P9.
//!
//! Traces the corners of a block. If their ray histories agree and no brightness differs from the mean by more than
//! Δ, the block is interpolated, else divided. There is no perspective image: objects between the corners are lost.
//! With *iterative central point selection* (1989) the block's central sample is traced as well and must agree.

use super::judge::brightness;
use super::worker::{First, TileWorker};
use crate::filling::fill_bilinear;
use crate::products::{Block, StageClock, Tile};
use crate::settings::{Judge, PixelSelectedSettings};

/// Renders a tile. Goes through the blocks level by level: trace, judge, fill.
pub(crate) fn render_pixel_selected(worker: &mut TileWorker, tile: &Tile, settings: &PixelSelectedSettings) {
    let mut clock = StageClock::start();
    let mut blocks = Block::cover(tile.width, tile.height, settings.block);
    while !blocks.is_empty() {
        for block in &blocks {
            let center = central_point(block).filter(|_| settings.central_point);
            for [x, y] in block.corners().into_iter().chain(center) {
                worker.trace(tile, x, y, First::Searched);
            }
        }
        worker.lap(&mut clock, |c| &mut c.seconds.trace);

        let (even, uneven): (Vec<Block>, Vec<Block>) =
            blocks.iter().partition(|block| block.is_smallest() || is_even(worker, tile, block, settings));
        let counts = &mut worker.tracer.counters.blocks;
        counts.judged += blocks.len() as u64;
        counts.filled += even.len() as u64;
        counts.divided += uneven.len() as u64;
        worker.lap(&mut clock, |c| &mut c.seconds.select);

        for block in &even {
            fill_bilinear(tile, &mut worker.samples, block);
            worker.note_history(tile, block, block.corners()[0]);
        }
        worker.lap(&mut clock, |c| &mut c.seconds.fill);
        blocks = uneven.iter().flat_map(Block::divide).collect();
    }
}

fn central_point(block: &Block) -> Option<[u32; 2]> {
    (!block.is_smallest()).then(|| [u32::midpoint(block.x0, block.x1), u32::midpoint(block.y0, block.y1)])
}

fn is_even(worker: &TileWorker, tile: &Tile, block: &Block, settings: &PixelSelectedSettings) -> bool {
    let samples = &worker.samples;
    let corners = block.corners().map(|[x, y]| tile.index(x, y));
    let history = samples.history[corners[0]];
    let colors = corners.map(|i| samples.color[i]);
    let histories_agree = corners.iter().all(|&i| samples.history[i] == history);
    if !histories_agree || !Judge::Difference(settings.delta).accepts(&colors) {
        return false;
    }
    let Some([x, y]) = central_point(block).filter(|_| settings.central_point) else { return true };
    let center = tile.index(x, y);
    let mean: [f32; 3] = std::array::from_fn(|c| colors.iter().map(|color| color[c]).sum::<f32>() * 0.25);
    let difference = (brightness(&samples.color[center]) - brightness(&mean)).abs();
    samples.history[center] == history && difference <= settings.delta.0
}
