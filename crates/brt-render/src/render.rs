//! The whole method on one screen.

use std::time::Instant;

use brt_image::Transfer;
use brt_scene::Scene;
use thiserror::Error;

use crate::methods::{
    TileWorker, Tolerance, render_border, render_certified, render_full, render_item_buffer, render_pencil,
    render_pixel_selected, render_reference, render_scan_line, trace_row,
};
use crate::perspective::{Outline, Outlines, Painter};
use crate::picture::{
    BandAssembler, FullTile, Layer, LayerRows, LayerSources, Sink, SinkError, TilePicture, TileShares,
    reduce, reduce_alpha, reduce_into, tile_layer,
};
use crate::prepare::{PreparedCamera, prepare};
use crate::products::{Counters, PreparedScene, SampleGrid, StageClock, Stats, Tile};
use crate::run::Run;
use crate::schedule::Schedule;
use crate::settings::{CheckedPixels, Method, Settings};
use crate::tracing::{BoundingSpheres, PencilTracer};

/// Why there is no picture.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum RenderError {
    /// The caller set the cancel flag.
    #[error("cancelled")]
    Cancelled,
    /// The sink took no more rows.
    #[error(transparent)]
    Sink(SinkError),
    /// The settings cannot be met.
    #[error("{0}")]
    Settings(String),
    /// No threads could be started.
    #[error("cannot start threads: {0}")]
    Threads(#[from] rayon::ThreadPoolBuildError),
}

/// Renders a scene that passed [`Scene::check`]; rows go to the sink from the top to the bottom.
///
/// # Errors
/// If it is cancelled, the sink fails, or the settings are out of range.
pub fn render(
    scene: &Scene,
    settings: &Settings,
    run: &Run,
    sink: &mut dyn Sink,
) -> Result<Stats, RenderError> {
    settings.check().map_err(RenderError::Settings)?;
    let begin = Instant::now();
    let grid = SampleGrid::new(settings.size, settings.samples);
    let prepared = prepare(scene, settings.accelerator);
    let camera = PreparedCamera::new(&scene.camera, prepared.origin, &grid);
    let job = Job {
        scene: &prepared,
        camera: &camera,
        grid: &grid,
        settings,
        max_depth: settings.max_depth.unwrap_or(scene.max_depth),
        transfer: sink.transfer(),
        spheres: settings.method.needs_bounding_spheres().then(|| BoundingSpheres::new(&prepared)),
        outlines: settings.needs_perspective_image().then(|| Outlines::new(&prepared, &camera, &grid)),
    };
    let prepare_seconds = begin.elapsed().as_secs_f64();

    let mut counters = Counters::default();
    let mut assembler = BandAssembler::new(&grid, settings);
    Schedule::new(&job, run)?.run(|band| {
        counters += band.counters;
        let rows = assembler.add_band(&band.tiles, band.colors);
        sink.take(&rows).map_err(RenderError::Sink)?;
        if let Some(progress) = run.progress {
            progress.advance(rows.count());
        }
        Ok(rows.colors)
    })?;
    let mut stats = Stats::of(&counters);
    stats.seconds.prepare = prepare_seconds;
    stats.seconds.render = begin.elapsed().as_secs_f64();
    Ok(stats)
}

/// Everything that the tiles of a picture have in common.
pub(crate) struct Job<'a> {
    pub(crate) scene: &'a PreparedScene,
    pub(crate) camera: &'a PreparedCamera,
    pub(crate) grid: &'a SampleGrid,
    pub(crate) settings: &'a Settings,
    pub(crate) max_depth: u32,
    /// How the sink stores colours.
    pub(crate) transfer: Transfer,
    /// Only if a perspective image is made.
    pub(crate) outlines: Option<Outlines>,
    /// Only for methods that look for what a bundle of rays may meet.
    pub(crate) spheres: Option<BoundingSpheres>,
}

/// Renders a tile; `None` if it was broken off. `outlines` are those that reach into it, `rows` its part of the picture's if the filter has no margin.
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
        if (row.saturating_sub(margin)..=row + margin).any(|row| checked.includes_row(row)) {
            trace_row(worker, tile, y);
        }
    }
    worker.tracer.take_counters();
    worker.tracer.counters = counted;
    let colors = reduce(worker.simd, job.settings.filter, job.grid, tile, &worker.samples.color);
    FullTile { colors, alpha: tile_alpha(job, worker, tile) }
}
