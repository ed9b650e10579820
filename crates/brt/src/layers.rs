//! The layers of a picture by name, and how each becomes a picture of its own.

use brt_image::Transfer;
use brt_render::Layer;

/// A layer that can be written beside the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum PictureLayer {
    /// Which surface is seen.
    Surface,
    /// How far away it is, along the view.
    Depth,
    /// Its shading normal.
    Normal,
    /// The ray history.
    History,
    /// How the pixel got its colour.
    State,
    /// Why it was not filled.
    Certificates,
    /// How far it is from full ray tracing.
    Error,
}

impl PictureLayer {
    /// All layers.
    pub const ALL: [Self; 7] = [
        Self::Surface,
        Self::Depth,
        Self::Normal,
        Self::History,
        Self::State,
        Self::Certificates,
        Self::Error,
    ];

    /// Its name in file names and on the command line.
    pub fn name(self) -> &'static str {
        self.source().map_or("error", Layer::name)
    }

    /// What its picture shows, in a line.
    pub fn summary(self) -> &'static str {
        match self {
            Self::Surface => "which surface is seen, in false colours",
            Self::Depth => {
                "distance along the view: white at the eye, grey in the scene's middle, black far away"
            }
            Self::Normal => "shading normal n as 0.5 + 0.5 n",
            Self::History => "ray history, in false colours",
            Self::State => "white: traced, grey: shaded, black: filled",
            Self::Certificates => {
                "what `certified` could not prove: red visibility, orange shadow, purple surface, yellow checker, \
                 green linear colour, grey too few samples; black: filled"
            }
            Self::Error => "difference from full ray tracing: black 0, violet 1 level, then red to yellow",
        }
    }

    /// The layer with this name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|layer| layer.name() == name)
    }

    /// What the renderer makes it of; the error comes from comparing instead.
    pub(crate) fn source(self) -> Option<Layer> {
        match self {
            Self::Surface => Some(Layer::Surface),
            Self::Depth => Some(Layer::Depth),
            Self::Normal => Some(Layer::Normal),
            Self::History => Some(Layer::History),
            Self::State => Some(Layer::State),
            Self::Certificates => Some(Layer::Certificates),
            Self::Error => None,
        }
    }

    /// The transfer function of its picture: codes of data are proportional to it, false colours are colours.
    pub(crate) fn transfer(self) -> Transfer {
        self.source().map_or(Transfer::Srgb, Layer::transfer)
    }

    /// Names of its channels in an EXR file, which holds values instead of colours where there are values.
    pub(crate) fn channels(self) -> &'static [&'static str] {
        match self {
            Self::Surface => &["surface.id"],
            Self::Depth => &["depth.Z"],
            Self::Normal => &["normal.X", "normal.Y", "normal.Z"],
            Self::History => &["history.R", "history.G", "history.B"],
            Self::State => &["state.Y"],
            Self::Certificates => &["certificates.R", "certificates.G", "certificates.B"],
            Self::Error => &["error.Y"],
        }
    }
}
