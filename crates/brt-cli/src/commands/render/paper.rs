//! The options under the heading "Paper": those of the methods of 1987.

use clap::{Args, ValueEnum};

use crate::values;

/// Options of `pixel-selected` and `border`.
#[derive(Clone, Copy, Debug, Args)]
#[command(next_help_heading = "Paper")]
pub(crate) struct PaperOptions {
    /// Threshold of brightness in levels of 255, of their squares for `--judge variance`; for `border` and
    /// `pixel-selected` [default: 16]
    #[arg(long, value_name = "LEVELS", allow_negative_numbers = true, value_parser = values::not_negative)]
    pub(crate) delta: Option<f64>,
    /// How brightness is judged by `border` [default: deviation]
    #[arg(long, value_enum)]
    pub(crate) judge: Option<JudgeName>,
    /// What `border` does with blocks of two surfaces [default: separate]
    #[arg(long, value_enum)]
    pub(crate) regions: Option<RegionsName>,
    /// When ray histories are the same, for `border` and `pixel-selected` [default: lit]
    #[arg(long, value_enum)]
    pub(crate) history: Option<HistoryName>,
    /// Side of the first blocks in samples, for `border` and `pixel-selected` [default: 16], for `pencil` [default: 32]
    #[arg(long, value_name = "N", allow_negative_numbers = true,
          value_parser = clap::value_parser!(u32).range(1..=128))]
    pub(crate) block: Option<u32>,
    /// Iterative central point selection, for `pixel-selected`
    #[arg(long)]
    pub(crate) icps: bool,
    /// Index that saves tests of rays with primitives
    #[arg(long, value_enum, default_value_t)]
    pub(crate) accelerator: AcceleratorName,
}

/// Judgements by name.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum JudgeName {
    /// Standard deviation of four brightness values
    #[default]
    Deviation,
    /// Their variance, as the paper's text says
    Variance,
    /// Their differences from the mean
    Difference,
}

/// Treatments of blocks with two surfaces by name.
#[derive(Clone, Copy, Debug, Default, ValueEnum)]
pub(crate) enum RegionsName {
    /// Interpolate each region that can be
    #[default]
    Separate,
    /// Interpolate both regions or none
    Together,
}

/// Kinds of ray history by name.
#[derive(Clone, Copy, Debug, Default, ValueEnum)]
pub(crate) enum HistoryName {
    /// Same surfaces, same lights seen
    #[default]
    Lit,
    /// Also which surfaces hide lights
    Shadower,
}

/// Accelerators by name.
#[derive(Clone, Copy, Debug, Default, ValueEnum)]
pub(crate) enum AcceleratorName {
    /// A bounding volume hierarchy
    #[default]
    Bvh,
    /// Every ray is tested with every primitive, as in the paper
    None,
    /// Bounding spheres around objects (Whitted 1980)
    Extents,
    /// A uniform grid (Fujimoto, Tanaka, Iwata 1986)
    Grid,
}

impl From<RegionsName> for brt::Regions {
    fn from(name: RegionsName) -> Self {
        match name {
            RegionsName::Separate => Self::Separate,
            RegionsName::Together => Self::Together,
        }
    }
}

impl From<HistoryName> for brt::HistoryKind {
    fn from(name: HistoryName) -> Self {
        match name {
            HistoryName::Lit => Self::Lit,
            HistoryName::Shadower => Self::Shadower,
        }
    }
}

impl From<AcceleratorName> for brt::Accelerator {
    fn from(name: AcceleratorName) -> Self {
        match name {
            AcceleratorName::Bvh => Self::Bvh,
            AcceleratorName::None => Self::None,
            AcceleratorName::Extents => Self::Extents,
            AcceleratorName::Grid => Self::Grid,
        }
    }
}
