//! Renderings that are timed, and those that are only counted.
//!
//! Times are processor times of one thread: other programs disturb them least. Contenders take turns within each
//! repetition, so that a machine which slows down slows all of them.

use brt::{
    CheckedScene, KeptRows, Method, RayOrder, Rows, Run, Scene, Settings, Sink, SinkError, Stats, Transfer,
    render,
};
use cpu_time::ProcessTime;

use super::fit::median;
use super::picture::Picture;
use super::{Options, PaperError, Watch};

/// Renderings of less than this together are repeated more often: clocks and caches need it.
const SHORT_SECONDS: f64 = 0.06;
/// But not more often than this.
const MOST_REPETITIONS: usize = 15;

/// The paper's pixel values are proportional to light. Paper: P7, P12.
const PAPERS_TRANSFER: Transfer = Transfer::Linear;

/// Where experiments are done.
pub(crate) struct Lab<'a> {
    watch: Watch<'a>,
    pub(crate) sizes: Vec<u32>,
    pub(crate) repeat: usize,
    pub(crate) quick: bool,
    /// A contender whose repetitions together would take longer is repeated less often, and one whose single rendering
    /// would is left out.
    longest: f64,
}

/// What timing a contender gave.
#[derive(Clone, Debug)]
pub(crate) struct Timing {
    /// Median of processor seconds.
    pub(crate) seconds: f64,
    /// Median of the perspective image's share, from 0 to 1.
    pub(crate) perspective_share: f64,
    pub(crate) stats: Stats,
    /// Processor seconds of each repetition.
    runs: Vec<f64>,
}

impl Timing {
    pub(crate) fn repetitions(&self) -> usize {
        self.runs.len()
    }

    /// How many times as fast as another contender of the same turns: the median over the repetitions of both.
    pub(crate) fn gain_over(&self, other: &Self) -> f64 {
        let ratios: Vec<f64> = self.runs.iter().zip(&other.runs).map(|(own, others)| others / own).collect();
        median(&ratios)
    }
}

fn fit(scene: &Scene) -> Result<CheckedScene, PaperError> {
    scene.clone().checked().map_err(|problems| PaperError::Scene(problems[0].to_string()))
}

impl<'a> Lab<'a> {
    pub(crate) fn new(options: &Options, watch: Watch<'a>) -> Self {
        let mut sizes = options.sizes.clone();
        sizes.sort_unstable();
        sizes.dedup();
        let longest = if options.quick { 4.0 } else { 40.0 };
        Self { watch, sizes, repeat: options.repeat.max(1) as usize, quick: options.quick, longest }
    }

    /// Says what is being measured.
    pub(crate) fn doing(&self, what: &str) {
        (self.watch.doing)(what);
    }

    /// The greatest of the sizes up to a limit, or the least of all.
    pub(crate) fn size_up_to(&self, limit: u32) -> u32 {
        let fitting = self.sizes.iter().copied().filter(|s| *s <= limit).max();
        fitting.or(self.sizes.first().copied()).unwrap_or(limit)
    }

    /// The side of pictures that the paper shows at one size, halved in a quick look.
    pub(crate) fn picture_size(&self, papers: u32) -> u32 {
        self.size_up_to(if self.quick { papers / 2 } else { papers })
    }

    /// A picture with its layers, on all threads.
    pub(crate) fn picture(&self, scene: &Scene, settings: &Settings) -> Result<Picture, PaperError> {
        let mut kept = KeptRows::new(PAPERS_TRANSFER);
        let stats = render(&fit(scene)?, settings, &self.run(0), &mut kept)?;
        Ok(Picture::new(settings.size.map(|side| side as u32), stats, kept.rows))
    }

    /// Counts, on all threads.
    pub(crate) fn count(&self, scene: &Scene, settings: &Settings) -> Result<Stats, PaperError> {
        Ok(render(&fit(scene)?, settings, &self.run(0), &mut Nowhere)?)
    }

    /// Times contenders, in turns, on one thread.
    pub(crate) fn time(&self, scene: &Scene, contenders: &[Settings]) -> Result<Vec<Timing>, PaperError> {
        let scene = fit(scene)?;
        let mut runs: Vec<Vec<(f64, f64, Stats)>> = vec![Vec::new(); contenders.len()];
        for repetition in 0..MOST_REPETITIONS {
            for (settings, runs) in contenders.iter().zip(&mut runs) {
                if repetition > 0 && self.has_enough(runs) {
                    continue;
                }
                let begin = ProcessTime::now();
                let stats = render(&scene, settings, &self.run(1), &mut Nowhere)?;
                let seconds = begin.elapsed().as_secs_f64();
                runs.push((seconds, stats.seconds.perspective / stats.seconds.render, stats));
            }
        }
        let timing = |runs: &Vec<(f64, f64, Stats)>| Timing {
            seconds: median(&runs.iter().map(|r| r.0).collect::<Vec<_>>()),
            perspective_share: median(&runs.iter().map(|r| r.1).collect::<Vec<_>>()),
            stats: runs[0].2,
            runs: runs.iter().map(|r| r.0).collect(),
        };
        Ok(runs.iter().map(timing).collect())
    }

    fn has_enough(&self, runs: &[(f64, f64, Stats)]) -> bool {
        let total: f64 = runs.iter().map(|r| r.0).sum();
        let next = total + total / runs.len() as f64;
        let is_short = total < SHORT_SECONDS;
        next > self.longest || (runs.len() >= self.repeat && !is_short)
    }

    /// Seconds that full ray tracing of a picture would take, by a small picture of the same scene.
    pub(crate) fn foreseen(&self, scene: &Scene, settings: &Settings) -> Result<f64, PaperError> {
        const SIDE: u32 = 24;
        let begin = ProcessTime::now();
        let probe = Settings { size: [u64::from(SIDE); 2], method: Method::Full, ..settings.clone() };
        render(&fit(scene)?, &probe, &self.run(1), &mut Nowhere)?;
        let [width, height] = settings.size.map(|side| side as f64);
        Ok(begin.elapsed().as_secs_f64() * width * height / f64::from(SIDE * SIDE))
    }

    /// Is a rendering that would take so long done at all?
    pub(crate) fn affords(&self, seconds: f64) -> bool {
        seconds <= self.longest
    }

    fn run(&self, threads: usize) -> Run<'a> {
        // The paper's methods follow single rays, and so does what they are compared with.
        Run { threads, cancel: self.watch.cancel, rays: RayOrder::Single, ..Run::default() }
    }
}

/// One sample per pixel of a square picture.
pub(crate) fn square(size: u32, method: Method) -> Settings {
    Settings { method, ..Settings::new([size, size]) }
}

/// Takes rows and forgets them: storing a picture is no part of rendering it.
struct Nowhere;

impl Sink for Nowhere {
    fn transfer(&self) -> Transfer {
        PAPERS_TRANSFER
    }

    fn take(&mut self, _: &Rows) -> Result<(), SinkError> {
        Ok(())
    }
}
