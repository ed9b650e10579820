//! Tiles over threads: groups of bands, so that memory stays proportional to the picture's width.

use std::ops::Range;
use std::sync::Mutex;

use rayon::prelude::*;
use rayon::{ScopeFifo, ThreadPool};

use crate::error::RenderError;
use crate::job::Job;
use crate::methods::TileWorker;
use crate::perspective::{BandOutlines, Painter};
use crate::picture::TilePicture;
use crate::products::{Counters, SampleGrid, Tile};
use crate::queue::Queue;
use crate::render_tile::render_tile;
use crate::run::Run;
use crate::settings::Window;

/// Bands are rendered together until there are this many tiles for each thread.
const TILES_PER_THREAD: u32 = 8;

/// So many groups of bands are rendered or wait while one is taken: threads that find nothing more to do in one work on
/// another.
const GROUPS: usize = 2;

/// Renders the tiles of a picture on a pool of threads.
pub(crate) struct Schedule<'a> {
    job: &'a Job<'a>,
    run: &'a Run<'a>,
    pool: &'a ThreadPool,
    /// Workers that no thread uses at the moment, kept for their buffers.
    idle: Mutex<Vec<(TileWorker<'a>, Painter<'a>)>>,
    /// Rows of bands that were taken, kept for their memory: fresh pages cost more than filling them.
    spare_rows: Mutex<Vec<Vec<[f32; 3]>>>,
}

/// The tiles of a band, left to right, and what was counted in them.
pub(crate) struct FinishedBand {
    pub(crate) tiles: Vec<TilePicture>,
    /// The band's rows; empty if the filter has a margin, for then its tiles have shares of pixels.
    pub(crate) colors: Vec<[f32; 3]>,
    pub(crate) counters: Counters,
}

/// A tile that is to be rendered.
struct TileTask<'r> {
    /// Counted over the bands of a group.
    index: usize,
    /// Its part of the picture's rows; empty if the filter has a margin.
    rows: Vec<&'r mut [[f32; 3]]>,
}

impl<'a> Schedule<'a> {
    pub(crate) fn new(job: &'a Job<'a>, run: &'a Run<'a>, pool: &'a ThreadPool) -> Self {
        Self { job, run, pool, idle: Mutex::new(Vec::new()), spare_rows: Mutex::new(Vec::new()) }
    }

    /// Renders all bands and hands them to `take`, from the top to the bottom; it gives back rows that can be used again.
    ///
    /// One of the threads takes bands while the others render: none waits for it, nor for the last tile of a group.
    pub(crate) fn run(
        &self,
        mut take: impl FnMut(FinishedBand) -> Result<Vec<[f32; 3]>, RenderError> + Send,
    ) -> Result<(), RenderError> {
        let queue = Queue::new(self.groups(), |bands| self.take_bands(bands, &mut take));
        self.pool.install(|| {
            rayon::scope_fifo(|scope| (0..GROUPS).for_each(|_| self.start_next(scope, &queue)));
        });
        queue.finish()
    }

    /// Renders the next group; whenever one is taken, another is started.
    fn start_next<'s, G, T>(&'s self, scope: &ScopeFifo<'s>, queue: &'s Queue<G, Vec<FinishedBand>, T>)
    where
        G: Iterator<Item = Range<u32>> + Send,
        T: FnMut(Vec<FinishedBand>) -> Result<(), RenderError> + Send,
    {
        let Some((place, bands)) = queue.next() else { return };
        scope.spawn_fifo(move |scope| {
            let rendered = self.render_bands(bands).ok_or(RenderError::Cancelled);
            queue.hand_over(place, rendered, || self.start_next(scope, queue));
        });
    }

    /// Bands that are rendered together, from the top to the bottom.
    fn groups(&self) -> impl Iterator<Item = Range<u32>> + Send + use<> {
        let bands = self.job.grid.bands();
        let tiles = TILES_PER_THREAD * self.pool.current_num_threads() as u32;
        let together = tiles.div_ceil(self.job.grid.tiles_wide());
        (0..bands).step_by(together as usize).map(move |first| first..(first + together).min(bands))
    }

    fn take_bands(
        &self,
        bands: Vec<FinishedBand>,
        take: &mut (impl FnMut(FinishedBand) -> Result<Vec<[f32; 3]>, RenderError> + Send),
    ) -> Result<(), RenderError> {
        bands.into_iter().try_for_each(|band| {
            if self.run.is_cancelled() {
                return Err(RenderError::Cancelled);
            }
            let rows = take(band)?;
            if self.rows_are_shared_out()
                && let Ok(mut spare) = self.spare_rows.lock()
            {
                spare.push(rows);
            }
            Ok(())
        })
    }

    /// `None` if the work was cancelled.
    fn render_bands(&self, bands: Range<u32>) -> Option<Vec<FinishedBand>> {
        let grid = self.job.grid;
        let columns = grid.tiles_wide() as usize;
        let outlines: Vec<Option<BandOutlines>> =
            bands.clone().map(|band| self.job.outlines.as_ref().map(|o| o.band(grid, band))).collect();
        let mut colors: Vec<_> = bands.clone().map(|band| self.empty_rows(band)).collect();
        let mut tasks = tile_tasks(&mut colors, grid);
        self.run.order.arrange(&mut tasks, |task| task.index);
        let render_one = |TileTask { index, mut rows }| {
            let (band, column) = (index / columns, (index % columns) as u32);
            let tile = Tile::at(grid, column, bands.start + band as u32);
            let (picture, counted) = self.render_one(&tile, column, outlines[band].as_ref(), &mut rows)?;
            Some((index, picture, counted))
        };
        let rendered: Option<Vec<_>> = tasks.into_par_iter().with_max_len(1).map(render_one).collect();
        let mut rendered = rendered?;
        rendered.sort_by_key(|(index, ..)| *index);
        let mut rendered = rendered.into_iter();
        let next_band = |colors| {
            let mut counters = Counters::default();
            let tiles = rendered.by_ref().take(columns).map(|(_, picture, counted)| {
                counters += counted;
                picture
            });
            FinishedBand { tiles: tiles.collect(), colors, counters }
        };
        Some(colors.into_iter().map(next_band).collect())
    }

    /// Do tiles write into the band's rows themselves? Not where they reach into each other.
    fn rows_are_shared_out(&self) -> bool {
        self.job.settings.filter.margin() == 0
    }

    /// Rows for the pixels of a band, of any colours; none if the filter has a margin.
    fn empty_rows(&self, band: u32) -> Vec<[f32; 3]> {
        let grid = self.job.grid;
        if !self.rows_are_shared_out() {
            return Vec::new();
        }
        let pixels = grid.width * (Tile::at(grid, 0, band).height / grid.per_side);
        let spare = self.spare_rows.lock().ok().and_then(|mut spare| spare.pop());
        let mut rows = spare.unwrap_or_default();
        rows.resize(pixels as usize, [0.0; 3]);
        rows
    }

    /// `None` if the work was cancelled.
    fn render_one(
        &self,
        tile: &Tile,
        column: u32,
        outlines: Option<&BandOutlines>,
        rows: &mut [&mut [[f32; 3]]],
    ) -> Option<(TilePicture, Counters)> {
        if self.run.is_cancelled() {
            return None;
        }
        let spare = self.idle.lock().ok().and_then(|mut idle| idle.pop());
        let (mut worker, mut painter) = spare.unwrap_or_else(|| {
            let painter = Painter::new(self.job.scene, self.job.camera, self.run);
            (TileWorker::new(self.job, self.run), painter)
        });
        let mine = outlines.map_or(&[][..], |o| o.tile(column));
        let _witness = PanicWitness { run: self.run, pixels: tile.pixels(self.job.grid) };
        let picture = render_tile(self.job, &mut worker, &mut painter, tile, mine, rows);
        let counted = worker.tracer.take_counters();
        if let Ok(mut idle) = self.idle.lock() {
            idle.push((worker, painter));
        }
        picture.map(|picture| (picture, counted))
    }
}

/// Says which pixels were rendered when a thread panicked.
struct PanicWitness<'a> {
    run: &'a Run<'a>,
    pixels: Window,
}

impl Drop for PanicWitness<'_> {
    fn drop(&mut self) {
        if std::thread::panicking()
            && let Some(progress) = self.run.progress
        {
            progress.panicked_in(self.pixels);
        }
    }
}

/// The tiles of bands, and the parts of the bands' rows that are theirs.
fn tile_tasks<'r>(bands: &'r mut [Vec<[f32; 3]>], grid: &SampleGrid) -> Vec<TileTask<'r>> {
    let (width, columns) = (grid.width as usize, grid.tiles_wide() as usize);
    let tile_width = (SampleGrid::TILE / grid.per_side) as usize;
    let mut tasks: Vec<_> =
        (0..bands.len() * columns).map(|index| TileTask { index, rows: Vec::new() }).collect();
    for (tiles, rows) in tasks.chunks_exact_mut(columns).zip(bands) {
        for row in rows.chunks_exact_mut(width) {
            let parts = row.chunks_mut(tile_width);
            tiles.iter_mut().zip(parts).for_each(|(tile, part)| tile.rows.push(part));
        }
    }
    tasks
}

#[cfg(test)]
mod tests {
    use std::panic::{AssertUnwindSafe, catch_unwind};
    use std::sync::Mutex;

    use super::*;
    use crate::run::Progress;

    #[derive(Default)]
    struct Heard(Mutex<Vec<Window>>);

    impl Progress for Heard {
        fn advance(&self, _: u32) {}

        fn panicked_in(&self, pixels: Window) {
            self.0.lock().unwrap().push(pixels);
        }
    }

    #[test]
    fn a_panic_names_its_pixels_and_nothing_else_does() {
        let heard = Heard::default();
        let run = Run { progress: Some(&heard), ..Run::default() };
        let pixels = Window { x: 1 << 35, y: 64, width: 32, height: 7 };
        drop(PanicWitness { run: &run, pixels });
        assert!(heard.0.lock().unwrap().is_empty());
        let panics = || {
            let _witness = PanicWitness { run: &run, pixels };
            panic!("a bug");
        };
        assert!(catch_unwind(AssertUnwindSafe(panics)).is_err());
        assert_eq!(*heard.0.lock().unwrap(), [pixels]);
    }
}
