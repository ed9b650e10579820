//! Why there is no picture.

use brt_scene::Problem;
use thiserror::Error;

/// What keeps a sink from taking rows.
pub type SinkError = Box<dyn std::error::Error + Send + Sync>;

/// Why there is no picture.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum RenderError {
    /// The caller set the cancel flag.
    #[error("cancelled")]
    Cancelled,
    /// The sink took no more rows.
    #[error(transparent)]
    Sink(SinkError),
    /// The settings cannot be met.
    #[error("{0}")]
    Settings(String),
    /// The camera cannot look.
    #[error("camera: {0}")]
    Camera(Problem),
    /// No threads could be started.
    #[error("cannot start threads: {0}")]
    Threads(#[from] std::io::Error),
}
