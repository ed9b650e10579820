//! Rendering: from a scene to rows of a picture.
//!
//! [`Renderer`] reads like the paper's summary: a perspective image is made without rays, it chooses the samples that
//! are traced, and the others are filled. This crate does no input or output and prints nothing. The same settings
//! give the same bytes for every number of threads and every order of tiles.

mod error;
mod filling;
mod job;
mod margins;
mod methods;
mod perspective;
mod picture;
mod prepare;
mod products;
mod queue;
mod render_tile;
mod renderer;
mod run;
mod schedule;
mod settings;
mod tracing;

pub use error::{RenderError, SinkError};
pub use picture::{KeptRows, LayerPainter, LayerRows, Rows, Sink};
pub use prepare::PreparedCamera;
pub use products::{
    BlockCounts, Certificate, CertificateCounts, PixelCounts, PreparedScene, RayCounts, RayHistory,
    SampleGrid, SampleState, Seconds, Stats, Surface, Tries,
};
pub use renderer::{Renderer, render};
pub use run::{Progress, RayOrder, Run, TileOrder, thread_pool};
pub use settings::{
    Accelerator, Backdrop, BorderSettings, CertifiedSettings, CheckedPixels, DeviationDelta, DifferenceDelta,
    Filter, HistoryKind, Judge, Layer, Method, PencilSettings, PixelSelectedSettings, Regions, Samples,
    Settings, VarianceDelta, Window,
};
pub use tracing::FirstSeen;
