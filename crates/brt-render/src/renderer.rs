//! The whole method on one screen.

use std::panic::resume_unwind;
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, TryLockError};
use std::thread;
use std::time::{Duration, Instant};

use brt_scene::{Camera, CheckedScene};
use rayon::ThreadPool;

use crate::error::RenderError;
use crate::job::Job;
use crate::perspective::Outlines;
use crate::picture::{BandAssembler, Crop, Sink};
use crate::prepare::{PreparedCamera, prepare};
use crate::products::{Counters, PreparedScene, SampleGrid, Stats};
use crate::run::{Run, thread_pool};
use crate::schedule::Schedule;
use crate::settings::{Accelerator, Settings, Window};
use crate::tracing::BoundingSpheres;

/// Renders a scene's picture, as its camera takes it; rows go to the sink from the top to the bottom.
///
/// For more than one picture or window of a scene a [`Renderer`] prepares it only once.
///
/// # Errors
/// If it is cancelled, the sink fails, or the settings are out of range.
pub fn render(
    scene: &CheckedScene,
    settings: &Settings,
    run: &Run,
    sink: &mut dyn Sink,
) -> Result<Stats, RenderError> {
    settings.check().map_err(RenderError::Settings)?;
    let begin = Instant::now();
    let window = settings.whole()?;
    let pool = &run.threads_to_use()?;
    let prepared = pool.install(|| prepare(scene, settings.accelerator, run.cancel()));
    let prepared = &prepared.ok_or(RenderError::Cancelled)?;
    Shot { scene, prepared, camera: &scene.camera, window, settings, run, pool }.take(begin, sink)
}

/// A scene that is prepared once, when it is first rendered, for as many pictures and windows as are wanted.
///
/// ```
/// use brt_render::{Renderer, Run, Settings, Window};
/// # let scene = brt_testkit::checked(&brt_testkit::seed_scene("a"));
/// let camera = scene.camera.clone();
/// let renderer = Renderer::new(scene);
/// // One pixel of a picture that nobody renders whole.
/// let settings = Settings::of_virtual([1_000_000_000, 1_000_000_000]);
/// let mut rows = Vec::new();
/// renderer.render(&camera, Window::pixel(500_000_000, 500_000_000), &settings, &Run::default(), &mut rows)?;
/// assert_eq!(rows[0].colors.len(), 1);
/// # Ok::<(), brt_render::RenderError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Renderer {
    scene: Arc<CheckedScene>,
    /// One for each accelerator.
    prepared: Arc<[Once; Accelerator::ALL.len()]>,
}

/// A scene that is prepared once.
#[derive(Debug, Default)]
struct Once {
    scene: OnceLock<PreparedScene>,
    preparing: Mutex<()>,
}

impl Renderer {
    /// A renderer of a scene.
    pub fn new(scene: impl Into<Arc<CheckedScene>>) -> Self {
        Self { scene: scene.into(), prepared: Arc::default() }
    }

    /// The scene.
    pub fn scene(&self) -> &CheckedScene {
        &self.scene
    }

    /// The scene as the tracers see it, prepared if it is not yet. It is the same on any number of threads.
    ///
    /// # Errors
    /// If it is cancelled, or the machine has no more threads to give.
    pub fn prepared(&self, accelerator: Accelerator, run: &Run) -> Result<&PreparedScene, RenderError> {
        let Once { scene, preparing } = &self.prepared[accelerator as usize];
        if scene.get().is_none() {
            let _alone = alone(preparing, run)?;
            if scene.get().is_none() {
                // Nobody else has set it since.
                _ = scene.set(prepare_apart(&self.scene, accelerator, run)?);
            }
        }
        scene.get().ok_or(RenderError::Cancelled)
    }

    /// Renders a window of the picture of [`Settings::size`] that this camera takes; its rows go to the sink from the top to
    /// the bottom, numbered from the window's first. They are those of the whole picture, to the bit.
    ///
    /// Counts in [`Stats`] are of all tiles that the window touches.
    ///
    /// # Errors
    /// If it is cancelled, the sink fails, or the camera, the window or the settings are out of range.
    pub fn render(
        &self,
        camera: &Camera,
        window: Window,
        settings: &Settings,
        run: &Run,
        sink: &mut dyn Sink,
    ) -> Result<Stats, RenderError> {
        settings.check().map_err(RenderError::Settings)?;
        if let Some(problem) = camera.check().into_iter().next() {
            return Err(RenderError::Camera(problem));
        }
        if !window.fits(settings.size) {
            let [width, height] = settings.size;
            return Err(RenderError::Settings(format!(
                "{window} is not a part of the picture of {width}×{height} pixels"
            )));
        }
        let begin = Instant::now();
        let prepared = self.prepared(settings.accelerator, run)?;
        let pool = &run.threads_to_use()?;
        Shot { scene: &self.scene, prepared, camera, window, settings, run, pool }.take(begin, sink)
    }
}

/// Waits until nobody else prepares the scene, or it is cancelled.
fn alone<'m>(preparing: &'m Mutex<()>, run: &Run) -> Result<MutexGuard<'m, ()>, RenderError> {
    /// A lock cannot be waited for and a flag be watched at once.
    const MOMENT: Duration = Duration::from_millis(1);
    let cancel = run.cancel();
    loop {
        match preparing.try_lock() {
            Ok(guard) => return Ok(guard),
            // Whoever panicked has left nothing behind.
            Err(TryLockError::Poisoned(poisoned)) => return Ok(poisoned.into_inner()),
            Err(TryLockError::WouldBlock) if cancel.is_set() => return Err(RenderError::Cancelled),
            Err(TryLockError::WouldBlock) => thread::sleep(MOMENT),
        }
    }
}

/// Prepares a scene on threads that nobody else has.
///
/// A thread of a pool that waits for another pool takes up other work meanwhile. That might be the next window of the scene:
/// it would wait for what the same thread has begun. And the threads that are lent may all wait for it. A plain thread does
/// nothing but wait.
fn prepare_apart(
    scene: &CheckedScene,
    accelerator: Accelerator,
    run: &Run,
) -> Result<PreparedScene, RenderError> {
    let threads = run.pool.map_or(run.threads, ThreadPool::current_num_threads);
    let cancel = run.cancel();
    let work = || -> Result<PreparedScene, RenderError> {
        let prepared = thread_pool(threads)?.install(|| prepare(scene, accelerator, cancel));
        prepared.ok_or(RenderError::Cancelled)
    };
    thread::scope(|scope| {
        let thread = thread::Builder::new().spawn_scoped(scope, work)?;
        thread.join().unwrap_or_else(|panic| resume_unwind(panic))
    })
}

/// A window of a picture, about to be rendered.
struct Shot<'a> {
    scene: &'a CheckedScene,
    prepared: &'a PreparedScene,
    camera: &'a Camera,
    window: Window,
    settings: &'a Settings,
    run: &'a Run<'a>,
    pool: &'a ThreadPool,
}

impl Shot<'_> {
    /// `begin` is when its preparation began.
    fn take(&self, begin: Instant, sink: &mut dyn Sink) -> Result<Stats, RenderError> {
        let Self { scene, prepared, window, settings, run, .. } = *self;
        let grid = SampleGrid::around(&window, settings.size, settings.samples, settings.filter.margin());
        let camera = PreparedCamera::new(self.camera, prepared.origin, &grid);
        let job = Job {
            scene: prepared,
            camera: &camera,
            grid: &grid,
            crop: Crop::new(&window, &grid),
            settings,
            max_depth: settings.max_depth.unwrap_or(scene.max_depth),
            transfer: sink.transfer(),
            spheres: settings.method.needs_bounding_spheres().then(|| BoundingSpheres::new(prepared)),
            outlines: settings.needs_perspective_image().then(|| Outlines::new(prepared, &camera, &grid)),
        };
        let prepare_seconds = begin.elapsed().as_secs_f64();

        let mut counters = Counters::default();
        let mut assembler = BandAssembler::new(&grid, settings);
        Schedule::new(&job, run, self.pool).run(|band| {
            counters += band.counters;
            let rows = assembler.add_band(&band.tiles, band.colors);
            if let Some(rows) = job.crop.of(&rows) {
                sink.take(&rows).map_err(RenderError::Sink)?;
                if let Some(progress) = run.progress {
                    progress.advance(rows.count());
                }
            }
            Ok(rows.colors)
        })?;
        let mut stats = Stats::of(&counters);
        stats.seconds.prepare = prepare_seconds;
        stats.seconds.render = begin.elapsed().as_secs_f64();
        Ok(stats)
    }
}
