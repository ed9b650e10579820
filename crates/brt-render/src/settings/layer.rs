//! What can be made besides the picture.

/// A layer besides the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Layer {
    /// Which surface is seen.
    Surface,
    /// How far away it is, along the view.
    Depth,
    /// Its shading normal.
    Normal,
    /// The ray history.
    History,
    /// How the sample got its colour.
    State,
    /// Why certified ray tracing did not fill the sample.
    Certificates,
}

impl Layer {
    /// All layers.
    pub const ALL: [Self; 6] =
        [Self::Surface, Self::Depth, Self::Normal, Self::History, Self::State, Self::Certificates];

    /// Its name in file names.
    pub fn name(self) -> &'static str {
        match self {
            Self::Surface => "surface",
            Self::Depth => "depth",
            Self::Normal => "normal",
            Self::History => "history",
            Self::State => "state",
            Self::Certificates => "certificates",
        }
    }

    /// Is it read from the perspective image?
    pub(crate) fn needs_perspective_image(self) -> bool {
        matches!(self, Self::Surface | Self::Depth | Self::Normal)
    }
}
