//! The options of `brt render`.

use std::num::NonZero;
use std::path::PathBuf;
use std::thread::available_parallelism;

use brt::{BitDepth, CheckedPixels, Limits, PictureLayer, Run, Samples, SimdLevel};
use clap::{ArgAction, Args, ValueEnum};

use super::paper::PaperOptions;
use crate::context::Context;
use crate::framing::ViewOptions;
use crate::scene_input::InputOptions;
use crate::values;

/// Options of `brt render`.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Scene file; `-` reads standard input
    #[arg(value_name = "SCENE")]
    pub(crate) scene: PathBuf,
    /// Same as --output
    #[arg(value_name = "OUT", conflicts_with = "output")]
    pub(crate) out: Option<PathBuf>,
    /// Picture to write, .png, .ppm or .exr; `-` writes PNG to standard output [default: the scene's name with .png,
    /// in the current folder]
    #[arg(short, long, value_name = "OUT")]
    pub(crate) output: Option<PathBuf>,
    /// Picture size in pixels [default: the scene's, else 1024x1024]
    #[arg(short, long, value_name = "WxH", allow_hyphen_values = true, value_parser = values::size)]
    pub(crate) size: Option<[u32; 2]>,
    /// Number of threads [default: one for each processor]
    #[arg(short = 'j', long, value_name = "N", allow_negative_numbers = true,
          value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub(crate) threads: Option<u16>,
    /// Vector instructions to use, where the machine has them; the picture is the same
    #[arg(long, value_name = "LEVEL", value_parser = values::simd_level(), default_value_t, hide_short_help = true)]
    pub(crate) simd: SimdLevel,
    /// Which pixels are traced
    #[arg(long, value_enum, default_value_t)]
    pub(crate) method: MethodName,
    /// Greatest error of a channel against full ray tracing in levels of 255 of the stored picture before rounding, for
    /// `certified`; of linear light, for `pencil`; 0: none [default: 1]
    #[arg(long, value_name = "LEVELS", allow_negative_numbers = true, value_parser = values::not_negative)]
    pub(crate) tolerance: Option<f64>,
    /// Samples per pixel
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = values::samples(),
          default_value = "16")]
    pub(crate) samples: Samples,
    /// How samples become pixels
    #[arg(long, value_enum, default_value_t)]
    pub(crate) filter: FilterName,
    /// Greatest number of bounces after the camera ray [default: the scene's]
    #[arg(long, value_name = "N", allow_negative_numbers = true,
          value_parser = clap::value_parser!(u32).range(..=i64::from(brt::Scene::GREATEST_MAX_DEPTH)))]
    pub(crate) max_depth: Option<u32>,
    /// Bits of a channel, for .png and .ppm [default: 8]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = values::bits())]
    pub(crate) bits: Option<BitDepth>,
    /// Effort spent on making a .png small; the picture is the same [default: fast]
    #[arg(long, value_enum, value_name = "HOW")]
    pub(crate) compression: Option<CompressionName>,
    /// Further layers to write, separated by commas: beside the picture as OUT.LAYER.png, or inside an .exr
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = values::layer())]
    pub(crate) layers: Vec<PictureLayer>,
    /// Write counts and times as JSON; `-` for standard output
    #[arg(long, value_name = "FILE")]
    pub(crate) stats: Option<PathBuf>,
    /// Compare every pixel, or those in the first row of every 16, with full ray tracing, before quantisation; its time
    /// counts as `render`, its rays do not
    #[arg(long, value_enum, value_name = "WHICH", num_args = 0..=1, require_equals = true,
          default_missing_value = "all")]
    pub(crate) verify: Option<VerifyName>,
    /// Verify, and exit with 3 if an error is greater than this, in levels of 255
    #[arg(long, value_name = "LEVELS", allow_negative_numbers = true, value_parser = values::not_negative)]
    pub(crate) max_error: Option<f64>,
    /// Write no picture; say what is seen in this pixel
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true, value_parser = values::pixel,
          conflicts_with_all = ["out", "output", "layers", "bits", "compression", "stats", "no_save"])]
    pub(crate) pixel: Option<[u32; 2]>,
    /// Store linear light instead of sRGB
    #[arg(long)]
    pub(crate) linear: bool,
    /// Write no picture: for timing
    #[arg(long, conflicts_with_all = ["out", "output", "layers", "bits", "compression"])]
    pub(crate) no_save: bool,
    /// Print only errors, and failed verifications
    #[arg(short, long)]
    pub(crate) quiet: bool,
    /// Print a longer summary, even if standard error is not a terminal
    #[arg(short, long, action = ArgAction::SetTrue, conflicts_with = "quiet")]
    pub(crate) verbose: bool,
    /// Options of the methods of 1987
    #[command(flatten)]
    pub(crate) paper: PaperOptions,
    /// Options for looking at the scene
    #[command(flatten)]
    pub(crate) view: ViewOptions,
    /// Options for reading the scene
    #[command(flatten)]
    pub(crate) reading: InputOptions,
    /// Refuse pictures of more pixels
    #[arg(long, value_name = "N", default_value_t = Limits::DEFAULT_PICTURE_PIXELS, help_heading = "Limits",
          allow_negative_numbers = true, value_parser = values::count)]
    pub(crate) max_pixels: u64,
}

impl Options {
    /// Are pixels compared with full ray tracing?
    pub(crate) fn verifies(&self) -> bool {
        self.checked() != CheckedPixels::None
    }

    /// Which pixels are compared with full ray tracing.
    pub(crate) fn checked(&self) -> CheckedPixels {
        match self.verify {
            // Where a pixel is looked at, it is that which is compared.
            Some(VerifyName::Rows) if self.pixel.is_none() => CheckedPixels::Rows,
            Some(_) => CheckedPixels::All,
            None if self.max_error.is_some() => CheckedPixels::All,
            None => CheckedPixels::None,
        }
    }

    /// Is an error, in levels of 255, greater than was asked for?
    pub(crate) fn is_over_limit(&self, error: f64) -> bool {
        self.max_error.is_some_and(|limit| error > limit)
    }

    /// How the work is done; it ends when a signal asks for it.
    pub(crate) fn run<'c>(&self, context: &'c Context) -> Run<'c> {
        let (threads, simd) = (self.thread_count(), self.simd);
        Run { threads, simd, cancel: Some(context.interrupt.flag()), ..Run::default() }
    }

    /// How many threads render.
    pub(crate) fn thread_count(&self) -> usize {
        self.threads.map_or_else(|| available_parallelism().map_or(1, NonZero::get), usize::from)
    }
}

/// Checked pixels by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum VerifyName {
    /// The first row of every 16
    Rows,
    /// Every pixel
    All,
}

/// Methods by name.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum MethodName {
    /// Every sample: standard ray tracing
    Full,
    /// Every sample, first hits from the perspective image (Weghorst, Hooper, Greenberg 1984)
    ItemBuffer,
    /// Every sample, rays only where mirrors, glass or shadows need them (Tadamura, Nakamae, Nishita 1985)
    ScanLine,
    /// Blocks of rays traced together, within a tolerance (Shinya, Takahashi, Naito 1987)
    Pencil,
    /// Pixel-selected ray tracing (Akimoto, Mase 1986)
    PixelSelected,
    /// Border ray tracing (Hashimoto, Suenaga 1987)
    Border,
    /// Every pixel is proven to be within a tolerance of `full`
    #[default]
    Certified,
}

impl MethodName {
    /// The name on the command line.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Full => "full",
            Self::ItemBuffer => "item-buffer",
            Self::ScanLine => "scan-line",
            Self::Pencil => "pencil",
            Self::PixelSelected => "pixel-selected",
            Self::Border => "border",
            Self::Certified => "certified",
        }
    }
}

/// Compressions by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum CompressionName {
    /// Least time
    Fast,
    /// Up to a sixth smaller with 8 bits, two fifths with 16, up to twice the time
    Balanced,
    /// A fifth to three fifths smaller, three to six times the time
    Small,
}

impl From<CompressionName> for brt::Compression {
    fn from(name: CompressionName) -> Self {
        match name {
            CompressionName::Fast => Self::Fast,
            CompressionName::Balanced => Self::Balanced,
            CompressionName::Small => Self::Small,
        }
    }
}

/// Filters by name.
#[derive(Clone, Copy, Debug, Default, ValueEnum)]
pub(crate) enum FilterName {
    /// The mean of the pixel's own samples
    #[default]
    Box,
    /// A Gaussian over the pixel and its neighbours
    Gaussian,
}

impl From<FilterName> for brt::Filter {
    fn from(name: FilterName) -> Self {
        match name {
            FilterName::Box => Self::Box,
            FilterName::Gaussian => Self::Gaussian,
        }
    }
}
