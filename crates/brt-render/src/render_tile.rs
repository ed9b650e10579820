//! One tile, from rays to pixels.

use crate::job::Job;
use crate::methods::{
    TileWorker, Tolerance, render_border, render_certified, render_full, render_item_buffer, render_pencil,
    render_pixel_selected, render_reference, render_scan_line, trace_row,
};
use crate::perspective::{Outline, Painter};
use crate::picture::{
    FullTile, LayerRows, LayerSources, TilePicture, TileShares, reduce, reduce_alpha, reduce_into, tile_layer,
};
use crate::products::{StageClock, Tile};
use crate::settings::{CheckedPixels, Layer, Method, Settings};
use crate::tracing::PencilTracer;

/// Renders a tile; `None` if it was broken off. `outlines` are those that reach into it, `rows` its part of the picture's if
/// the filter has no margin.
pub(crate) fn render_tile(
    job: &Job,
    worker: &mut TileWorker,
    painter: &mut Painter,
    tile: &Tile,
    outlines: &[Outline],
    rows: &mut [&mut [[f32; 3]]],
) -> Option<TilePicture> {
    worker.reset(tile);
    // "Make a perspective image of the objects" (P3): what each sample sees first, without rays.
    if job.outlines.is_some() {
        let mut clock = StageClock::start();
        match job.settings.method {
            Method::ScanLine => painter.scan(tile, outlines, &mut worker.perspective),
            _ => painter.paint(tile, outlines, &mut worker.perspective),
        }
        worker.open_background();
        clock.lap(&mut worker.tracer.counters.seconds.perspective);
    }
    // A perspective image that was broken off shows nothing of sense.
    if worker.cancel.is_set() {
        return None;
    }
    // "Use it to choose the pixels that are ray-traced and those that are interpolated" (P3, P5, P6).
    trace_and_fill(job, worker, tile, &job.settings.method);
    if worker.cancel.is_set() {
        return None;
    }
    worker.tracer.counters.count_states(&worker.samples.state);

    // From samples to pixels, and whatever else is to be seen.
    let (filter, samples) = (job.settings.filter, &worker.samples.color);
    let colors = (filter.margin() > 0).then(|| reduce(worker.simd, filter, job.grid, tile, samples));
    if colors.is_none() {
        reduce_into(worker.simd, job.grid, tile, samples, rows);
    }
    let alpha = tile_alpha(job, worker, tile);
    let layers = job.settings.layers.iter().map(|&layer| make_layer(job, worker, tile, layer)).collect();
    let full = (job.settings.checked != CheckedPixels::None).then(|| render_again_in_full(job, worker, tile));
    // Once more: what is checked may have been broken off.
    (!worker.cancel.is_set()).then_some(TilePicture { tile: *tile, colors, alpha, full, layers })
}

fn trace_and_fill(job: &Job, worker: &mut TileWorker, tile: &Tile, method: &Method) {
    match method {
        Method::Reference => render_reference(worker, tile, job.scene, job.max_depth),
        Method::Full => render_full(worker, tile),
        Method::ItemBuffer => render_item_buffer(worker, tile),
        Method::ScanLine => {
            if let Some(spheres) = &job.spheres {
                render_scan_line(worker, tile, job.scene, spheres);
            }
        }
        Method::Pencil(settings) => {
            if let Some(spheres) = &job.spheres {
                let tracer = PencilTracer { scene: job.scene, spheres, max_depth: job.max_depth };
                render_pencil(worker, tile, &tracer, settings);
            }
        }
        Method::PixelSelected(settings) => render_pixel_selected(worker, tile, settings),
        Method::Border(settings) => render_border(worker, tile, settings),
        Method::Certified(settings) => {
            let tolerance = Tolerance::new(settings, job.transfer);
            render_certified(worker, tile, job.scene, tolerance, job.max_depth);
        }
    }
}

fn tile_alpha(job: &Job, worker: &TileWorker, tile: &Tile) -> Option<TileShares<1>> {
    let samples = worker.samples.alpha.as_ref()?;
    Some(reduce_alpha(worker.simd, job.settings.filter, job.grid, tile, samples))
}

fn make_layer(job: &Job, worker: &TileWorker, tile: &Tile, layer: Layer) -> LayerRows {
    let TileWorker { samples, perspective, .. } = worker;
    let sources =
        LayerSources { scene: job.scene, camera: job.camera, grid: job.grid, tile, samples, perspective };
    tile_layer(layer, &sources)
}

/// The tile's checked pixels once more by full ray tracing. Its rays are not counted: they are spent on checking.
fn render_again_in_full(job: &Job, worker: &mut TileWorker, tile: &Tile) -> FullTile {
    let counted = worker.tracer.take_counters();
    worker.samples.reset(tile);
    let Settings { checked, filter, .. } = job.settings;
    let margin = filter.margin();
    for y in 0..tile.height {
        let row = (tile.y + y) / job.grid.per_side;
        let is_checked = |row: u32| job.crop.row(row).is_some_and(|row| checked.includes_row(row));
        if (row.saturating_sub(margin)..=row + margin).any(is_checked) {
            trace_row(worker, tile, y);
        }
    }
    worker.tracer.take_counters();
    worker.tracer.counters = counted;
    let colors = reduce(worker.simd, job.settings.filter, job.grid, tile, &worker.samples.color);
    FullTile { colors, alpha: tile_alpha(job, worker, tile) }
}
