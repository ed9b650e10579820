//! Pencil tracing (Shinya, Takahashi, Naito 1987): the rays of a block together, within a stated tolerance. Paper: P1.
//!
//! A block whose samples all see one primitive is traced as a pencil. Where the pencil's history is certain and its
//! colour within the tolerance of a linear function, the block is filled with that function; else it is split, in the
//! end to rays.

use brt_geometry::Taylor;
use brt_image::Rgb;

use super::worker::{First, TileWorker};
use crate::filling::LinearFill;
use crate::products::{Area, NOTHING, SampleState, StageClock, Tile};
use crate::settings::PencilSettings;
use crate::tracing::{PencilTracer, constant};

/// Blocks of this side and less are left to rays: a pencil costs as much as several of them.
const SMALLEST_PENCIL: u32 = 3;

/// Renders a tile whose perspective image is painted.
pub(crate) fn render_pencil(
    worker: &mut TileWorker,
    tile: &Tile,
    tracer: &PencilTracer,
    settings: &PencilSettings,
) {
    let mut clock = StageClock::start();
    let (right, bottom) = (tile.x + tile.width, tile.y + tile.height);
    for y0 in (tile.y..bottom).step_by(settings.block as usize) {
        for x0 in (tile.x..right).step_by(settings.block as usize) {
            let (x1, y1) = ((x0 + settings.block).min(right), (y0 + settings.block).min(bottom));
            render_area(worker, tile, tracer, Area { x0, y0, x1, y1 }, settings.tolerance);
        }
    }
    worker.lap(&mut clock, |c| &mut c.seconds.trace);
}

fn render_area(worker: &mut TileWorker, tile: &Tile, tracer: &PencilTracer, area: Area, tolerance: f64) {
    let counts = &mut worker.tracer.counters.blocks;
    counts.judged += 1;
    if area.is_within(SMALLEST_PENCIL) {
        for y in area.y0..area.y1 {
            (area.x0..area.x1).for_each(|x| worker.trace(tile, x - tile.x, y - tile.y, First::Shown));
        }
        return;
    }
    if let Some(color) = even_color(worker, tile, tracer, area, tolerance) {
        worker.tracer.counters.blocks.filled += 1;
        fill(worker, tile, area, &color);
        return;
    }
    worker.tracer.counters.blocks.divided += 1;
    for quarter in area.quarters() {
        render_area(worker, tile, tracer, quarter, tolerance);
    }
}

/// The colour over an area, if its remainder is within the tolerance.
fn even_color(
    worker: &TileWorker,
    tile: &Tile,
    tracer: &PencilTracer,
    area: Area,
    tolerance: f64,
) -> Option<Rgb<Taylor>> {
    let primitive = only_primitive(worker, tile, area)?;
    let color = match primitive {
        NOTHING => constant(worker.tracer.color_of_nothing()),
        primitive => tracer.color(&worker.camera.block(&area), primitive)?,
    };
    let remainder = color.r.e.max(color.g.e).max(color.b.e);
    // Written so that NaN is refused.
    (remainder * 255.0 <= tolerance).then_some(color)
}

fn only_primitive(worker: &TileWorker, tile: &Tile, area: Area) -> Option<u32> {
    let at = |x: u32, y: u32| tile.index(x - tile.x, y - tile.y);
    let first = worker.perspective.primitive[at(area.x0, area.y0)];
    let row = |y: u32| &worker.perspective.primitive[at(area.x0, y)..=at(area.x1 - 1, y)];
    (area.y0..area.y1).all(|y| row(y).iter().all(|&p| p == first)).then_some(first)
}

/// All samples have the history of the pencil, and so of the first.
fn note_histories(worker: &mut TileWorker, tile: &Tile, area: Area) {
    let (x, y) = (area.x0 - tile.x, area.y0 - tile.y);
    worker.note_history_of(tile, x, y);
    let history = worker.samples.history[tile.index(x, y)];
    for row in y..area.y1 - tile.y {
        let start = tile.index(x, row);
        worker.samples.history[start..start + (area.x1 - area.x0) as usize].fill(history);
    }
}

fn fill(worker: &mut TileWorker, tile: &Tile, area: Area, color: &Rgb<Taylor>) {
    if worker.wants_histories {
        note_histories(worker, tile, area);
    }
    let fill = LinearFill::new(worker.simd, area, &worker.camera.pattern, color, f32::NEG_INFINITY);
    for y in area.y0..area.y1 {
        let start = tile.index(area.x0 - tile.x, y - tile.y);
        let run = start..start + (area.x1 - area.x0) as usize;
        fill.fill([area.x0, y], &mut worker.samples.color[run.clone()]);
        worker.samples.state[run].fill(SampleState::Filled);
    }
}
