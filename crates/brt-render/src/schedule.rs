//! Tiles over threads: groups of bands, so that memory stays proportional to the picture's width.

use std::ops::Range;
use std::sync::Mutex;

use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::methods::TileWorker;
use crate::perspective::{BandOutlines, Painter};
use crate::picture::TilePicture;
use crate::products::{Counters, Tile};
use crate::render::{Job, RenderError, render_tile};
use crate::run::Run;

/// Bands are rendered together until there are this many tiles for each thread: enough to even out their costs.
const TILES_PER_THREAD: u32 = 8;

/// Bytes of a thread's stack: a thousand bounces nest, and each takes about 2 KiB.
const STACK: usize = 16 << 20;

/// Renders the tiles of a picture on a pool of threads.
pub(crate) struct Schedule<'a> {
    job: &'a Job<'a>,
    run: &'a Run<'a>,
    pool: ThreadPool,
    /// Workers that no thread uses at the moment, kept for their buffers.
    idle: Mutex<Vec<(TileWorker<'a>, Painter<'a>)>>,
}

/// The tiles of a band, left to right, and what was counted in them.
struct FinishedBand {
    tiles: Vec<TilePicture>,
    counters: Counters,
}

impl<'a> Schedule<'a> {
    pub(crate) fn new(job: &'a Job<'a>, run: &'a Run<'a>) -> Result<Self, RenderError> {
        let pool = ThreadPoolBuilder::new().num_threads(run.threads).stack_size(STACK).build()?;
        Ok(Self { job, run, pool, idle: Mutex::new(Vec::new()) })
    }

    /// Renders all bands and hands their tiles to `take`, from the top to the bottom, with what was counted in them.
    ///
    /// While a group of bands is rendered, one of the threads takes those of the group before: none waits for it.
    pub(crate) fn run(
        &self,
        mut take: impl FnMut(Vec<TilePicture>, Counters) -> Result<(), RenderError> + Send,
    ) -> Result<(), RenderError> {
        self.pool.install(|| {
            let mut finished = Vec::new();
            for bands in self.groups() {
                let waiting = std::mem::take(&mut finished);
                let (rendered, taken) =
                    rayon::join(|| self.render_bands(bands), || self.take_bands(waiting, &mut take));
                taken?;
                finished = rendered.ok_or(RenderError::Cancelled)?;
            }
            self.take_bands(finished, &mut take)
        })
    }

    /// Bands that are rendered together, from the top to the bottom.
    fn groups(&self) -> impl Iterator<Item = Range<u32>> + use<> {
        let bands = self.job.grid.bands();
        let tiles = TILES_PER_THREAD * self.pool.current_num_threads() as u32;
        let together = tiles.div_ceil(self.job.grid.tiles_wide());
        (0..bands).step_by(together as usize).map(move |first| first..(first + together).min(bands))
    }

    fn take_bands(
        &self,
        bands: Vec<FinishedBand>,
        take: &mut (impl FnMut(Vec<TilePicture>, Counters) -> Result<(), RenderError> + Send),
    ) -> Result<(), RenderError> {
        bands.into_iter().try_for_each(|FinishedBand { tiles, counters }| {
            if self.run.is_cancelled() {
                return Err(RenderError::Cancelled);
            }
            take(tiles, counters)
        })
    }

    /// `None` if the work was cancelled.
    fn render_bands(&self, bands: Range<u32>) -> Option<Vec<FinishedBand>> {
        let grid = self.job.grid;
        let columns = grid.tiles_wide() as usize;
        let outlines: Vec<Option<BandOutlines>> =
            bands.clone().map(|band| self.job.outlines.as_ref().map(|o| o.band(grid, band))).collect();
        let mut tiles: Vec<usize> = (0..outlines.len() * columns).collect();
        self.run.order.arrange(&mut tiles);
        let render_one = |&index: &usize| {
            let (band, column) = (index / columns, (index % columns) as u32);
            let tile = Tile::at(grid, column, bands.start + band as u32);
            let (picture, counted) = self.render_one(&tile, column, outlines[band].as_ref())?;
            Some((index, picture, counted))
        };
        let rendered: Option<Vec<_>> = tiles.par_iter().with_max_len(1).map(render_one).collect();
        let mut rendered = rendered?;
        rendered.sort_by_key(|(index, ..)| *index);
        let mut rendered = rendered.into_iter();
        let next_band = |_| {
            let mut counters = Counters::default();
            let tiles = rendered.by_ref().take(columns).map(|(_, picture, counted)| {
                counters += counted;
                picture
            });
            FinishedBand { tiles: tiles.collect(), counters }
        };
        Some((0..outlines.len()).map(next_band).collect())
    }

    /// `None` if the work was cancelled.
    fn render_one(
        &self,
        tile: &Tile,
        column: u32,
        outlines: Option<&BandOutlines>,
    ) -> Option<(TilePicture, Counters)> {
        if self.run.is_cancelled() {
            return None;
        }
        let spare = self.idle.lock().ok().and_then(|mut idle| idle.pop());
        let (mut worker, mut painter) = spare
            .unwrap_or_else(|| (TileWorker::new(self.job), Painter::new(self.job.scene, self.job.camera)));
        let mine = outlines.map_or(&[][..], |o| o.tile(column));
        let picture = render_tile(self.job, &mut worker, &mut painter, tile, mine);
        let counted = worker.tracer.take_counters();
        if let Ok(mut idle) = self.idle.lock() {
            idle.push((worker, painter));
        }
        Some((picture, counted))
    }
}
