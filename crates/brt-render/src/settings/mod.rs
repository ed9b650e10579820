//! What is rendered: everything that a picture depends on besides the scene. Paper: P1.

mod judge;
mod layer;
mod method;
mod samples;
mod window;

pub use judge::{DeviationDelta, DifferenceDelta, Judge, VarianceDelta};
pub use layer::Layer;
pub use method::{BorderSettings, CertifiedSettings, Method, PencilSettings, PixelSelectedSettings, Regions};
pub use samples::{Filter, Samples};
pub use window::Window;

use brt_scene::Scene;

use crate::error::RenderError;

/// What is rendered.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Width and height of the whole picture in pixels, each at least 1; [`Window`]s of it are rendered.
    pub size: [u64; 2],
    /// Samples per pixel.
    pub samples: Samples,
    /// How samples become pixels.
    pub filter: Filter,
    /// Which samples are traced and what happens to the others.
    pub method: Method,
    /// What saves tests of primitives.
    pub accelerator: Accelerator,
    /// When two ray histories are the same.
    pub history: HistoryKind,
    /// Bounce limit instead of the scene's.
    pub max_depth: Option<u32>,
    /// Which layers are made besides the picture.
    pub layers: Vec<Layer>,
    /// Which pixels are rendered by full ray tracing too, to compare with.
    pub checked: CheckedPixels,
    /// What is behind everything.
    pub backdrop: Backdrop,
}

impl Settings {
    /// Greatest side of a block, in samples.
    pub const GREATEST_BLOCK: u32 = 128;

    /// One sample per pixel by full ray tracing, of a picture that can be rendered whole.
    pub fn new(size: [u32; 2]) -> Self {
        Self::of_virtual(size.map(u64::from))
    }

    /// The same of a picture of which windows are rendered: up to 2⁴⁰ pixels wide and high.
    pub fn of_virtual(size: [u64; 2]) -> Self {
        Self {
            size,
            samples: Samples::One,
            filter: Filter::Box,
            method: Method::Full,
            accelerator: Accelerator::Bvh,
            history: HistoryKind::Lit,
            max_depth: None,
            layers: Vec::new(),
            checked: CheckedPixels::None,
            backdrop: Backdrop::Scene,
        }
    }

    /// The window that is all of the picture.
    ///
    /// # Errors
    /// If it is too large to be rendered at once.
    pub fn whole(&self) -> Result<Window, RenderError> {
        let [width, height] = self.size;
        Window::whole(self.size).ok_or_else(|| {
            let side = Window::GREATEST_SIDE;
            RenderError::Settings(format!(
                "{width}×{height} pixels at once: each side must be from 1 to {side}"
            ))
        })
    }

    /// What is wrong with them, if anything.
    pub(crate) fn check(&self) -> Result<(), String> {
        let [width, height] = self.size;
        let sides = 1..=Window::GREATEST_PICTURE_SIDE;
        if !sides.contains(&width) || !sides.contains(&height) {
            return Err(format!("{width}×{height} pixels: each side must be from 1 to {}", sides.end()));
        }
        if self.max_depth.is_some_and(|depth| depth > Scene::GREATEST_MAX_DEPTH) {
            return Err(format!("a depth of at most {} bounces can be followed", Scene::GREATEST_MAX_DEPTH));
        }
        let threshold = self.method.threshold();
        if threshold.is_nan() || threshold < 0.0 {
            return Err(format!("the threshold {threshold} must be at least 0"));
        }
        let block = match &self.method {
            Method::PixelSelected(settings) => settings.block,
            Method::Border(settings) => settings.block,
            Method::Pencil(settings) => settings.block,
            Method::Reference
            | Method::Full
            | Method::ItemBuffer
            | Method::ScanLine
            | Method::Certified(_) => 1,
        };
        if !(1..=Self::GREATEST_BLOCK).contains(&block) {
            return Err(format!(
                "blocks of {block} samples: the side must be from 1 to {}",
                Self::GREATEST_BLOCK
            ));
        }
        Ok(())
    }

    /// Does the method or a layer read a perspective image?
    pub(crate) fn needs_perspective_image(&self) -> bool {
        !matches!(self.method, Method::Reference | Method::Full | Method::PixelSelected(_))
            || self.layers.iter().any(|layer| layer.needs_perspective_image())
    }
}

/// What the camera sees where a straight way meets nothing, or only surfaces that are partly there.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Backdrop {
    /// The scene's background.
    #[default]
    Scene,
    /// Nothing: it adds no light, and pixels get an alpha, which is 1 less the share of it that they see. Mirrors and
    /// glass still show the scene's background, and hide what is behind them.
    Transparent,
}

impl Backdrop {
    /// Do pixels get an alpha?
    pub fn has_alpha(self) -> bool {
        self == Self::Transparent
    }
}

/// Which pixels are compared with full ray tracing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum CheckedPixels {
    /// None.
    #[default]
    None,
    /// Those of the first row of every 16.
    Rows,
    /// All.
    All,
}

impl CheckedPixels {
    /// Are the pixels of this row checked?
    pub fn includes_row(self, row: u32) -> bool {
        match self {
            Self::None => false,
            Self::Rows => row.is_multiple_of(16),
            Self::All => true,
        }
    }
}

/// When two ray histories are the same. Paper: P5, reading 3.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum HistoryKind {
    /// The same surfaces are met and the same lights are seen.
    #[default]
    Lit,
    /// And lights that are not seen are hidden by the same surfaces.
    Shadower,
}

/// What saves tests of primitives.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Accelerator {
    /// Nothing: every ray is tested with every primitive. Paper: P7.
    None,
    /// A bounding sphere around each object (Whitted 1980).
    Extents,
    /// A uniform grid (Fujimoto, Tanaka, Iwata 1986).
    Grid,
    /// A bounding volume hierarchy.
    #[default]
    Bvh,
}

impl Accelerator {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::None, Self::Extents, Self::Grid, Self::Bvh];
}
