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

pub use error::RenderError;
pub use methods::{
    BorderSettings, CertifiedSettings, DeviationDelta, DifferenceDelta, Judge, PencilSettings,
    PixelSelectedSettings, Regions, VarianceDelta,
};
pub use picture::{Filter, KeptRows, Layer, LayerPainter, LayerRows, Rows, Sink, SinkError};
pub use prepare::PreparedCamera;
pub use products::{
    BlockCounts, Certificate, CertificateCounts, PixelCounts, PreparedScene, RayCounts, RayHistory,
    SampleGrid, SampleState, Seconds, Stats, Surface, Tries, Window,
};
pub use renderer::{Renderer, render};
pub use run::{Progress, RayOrder, Run, TileOrder, thread_pool};
pub use settings::{Accelerator, Backdrop, CheckedPixels, HistoryKind, Method, Samples, Settings};
pub use tracing::FirstSeen;
