//! Which samples are traced, and the settings of each method. Paper: P1, P2, P6.

use super::{DeviationDelta, DifferenceDelta, Judge};

/// Which samples are traced.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// Every sample by the plain recursion over all primitives: the oracle.
    Reference,
    /// Every sample: standard ray tracing.
    Full,
    /// Every sample, the first hit from the perspective image (Weghorst, Hooper, Greenberg 1984).
    ItemBuffer,
    /// Every sample, rays only where mirrors, glass or shadows need them (Tadamura, Nakamae, Nishita 1985).
    ScanLine,
    /// Blocks of rays traced together, within a tolerance (Shinya, Takahashi, Naito 1987).
    Pencil(PencilSettings),
    /// Pixel-selected ray tracing (Akimoto, Mase 1986).
    PixelSelected(PixelSelectedSettings),
    /// Border ray tracing (Hashimoto, Suenaga 1987).
    Border(BorderSettings),
    /// What is not traced is proven to be within a tolerance.
    Certified(CertifiedSettings),
}

impl Method {
    /// The greatest error of a pixel against full ray tracing, in levels of 255, that the method promises.
    pub fn promised_error(&self) -> Option<f64> {
        match self {
            Self::Reference | Self::Full | Self::ItemBuffer | Self::ScanLine => Some(0.0),
            Self::Pencil(PencilSettings { tolerance, .. })
            | Self::Certified(CertifiedSettings { tolerance, .. }) => Some(*tolerance),
            Self::PixelSelected(_) | Self::Border(_) => None,
        }
    }

    /// Δ or tolerance; 0 where there is none.
    pub(super) fn threshold(&self) -> f64 {
        match self {
            Self::PixelSelected(settings) => settings.delta.0,
            Self::Pencil(settings) => settings.tolerance,
            Self::Certified(settings) => settings.tolerance,
            Self::Border(settings) => match settings.judge {
                Judge::Variance(delta) => delta.0,
                Judge::Deviation(delta) => delta.0,
                Judge::Difference(delta) => delta.0,
            },
            _ => 0.0,
        }
    }

    /// Does it look for what a bundle of rays may meet?
    pub(crate) fn needs_bounding_spheres(&self) -> bool {
        matches!(self, Self::ScanLine | Self::Pencil(_))
    }

    /// Its name on the command line and in statistics.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Reference => "reference",
            Self::Full => "full",
            Self::ItemBuffer => "item-buffer",
            Self::ScanLine => "scan-line",
            Self::Pencil(_) => "pencil",
            Self::PixelSelected(_) => "pixel-selected",
            Self::Border(_) => "border",
            Self::Certified(_) => "certified",
        }
    }
}

/// Settings of certified ray tracing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CertifiedSettings {
    /// Greatest error of a channel of a pixel against full ray tracing, in levels of 255 of the stored value before
    /// rounding; the [sink](crate::Sink::transfer) says how values are stored. 0: nothing is filled, and the picture has
    /// the bits of full ray tracing.
    pub tolerance: f64,
}

impl Default for CertifiedSettings {
    fn default() -> Self {
        Self { tolerance: 1.0 }
    }
}

/// Settings of border ray tracing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BorderSettings {
    /// Side of the first blocks in samples, 1 to 128.
    pub block: u32,
    /// How brightness is judged.
    pub judge: Judge,
    /// What happens to a block with two surfaces.
    pub regions: Regions,
}

/// What happens to a block with two surfaces. Paper: P6 (1).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Regions {
    /// The one that can be interpolated is, whatever becomes of the other.
    #[default]
    Separate,
    /// Both are interpolated or none: as in the first publication.
    Together,
}

impl Default for BorderSettings {
    fn default() -> Self {
        Self { block: 16, judge: Judge::Deviation(DeviationDelta(16.0)), regions: Regions::Separate }
    }
}

/// Settings of pixel-selected ray tracing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PixelSelectedSettings {
    /// Side of the first blocks in samples, 1 to 128.
    pub block: u32,
    /// Greatest difference of brightness from the mean.
    pub delta: DifferenceDelta,
    /// Trace the central sample of a block too?
    pub central_point: bool,
}

impl Default for PixelSelectedSettings {
    fn default() -> Self {
        Self { block: 16, delta: DifferenceDelta(16.0), central_point: false }
    }
}

/// Settings of pencil tracing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PencilSettings {
    /// Side of the first blocks in samples, 1 to 128.
    pub block: u32,
    /// Greatest error of a channel in levels of 255 of linear RGB.
    pub tolerance: f64,
}

impl Default for PencilSettings {
    fn default() -> Self {
        Self { block: 32, tolerance: 1.0 }
    }
}
