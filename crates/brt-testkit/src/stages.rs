//! The products of the steps as pictures that people can look at.

use brt_image::{depth_color, id_color};
use brt_render::{Certificate, Layer, SampleState};

use crate::Rendered;

/// A product of the renderer, in the order in which they are made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// A layer.
    Layer(Layer),
    /// What comes out in the end.
    Picture,
}

impl Stage {
    /// All stages of `border`.
    pub const ALL: [Self; 6] = [
        Self::Layer(Layer::Surface),
        Self::Layer(Layer::Depth),
        Self::Layer(Layer::Normal),
        Self::Layer(Layer::State),
        Self::Layer(Layer::History),
        Self::Picture,
    ];

    /// Its name in file names.
    pub fn name(self) -> &'static str {
        match self {
            Self::Layer(Layer::Surface) => "surface",
            Self::Layer(Layer::Depth) => "depth",
            Self::Layer(Layer::Normal) => "normal",
            Self::Layer(Layer::State) => "state",
            Self::Layer(Layer::History) => "history",
            Self::Layer(Layer::Certificates) => "certificates",
            Self::Picture => "picture",
        }
    }
}

/// A stage in colours: ids and histories in false colours, traced samples white, filled ones black.
pub fn stage_colors(rendered: &Rendered, stage: Stage) -> Vec<[f32; 3]> {
    let surface_color = |&id: &u32| if id == u32::MAX { [0.0; 3] } else { id_color(u64::from(id)) };
    match stage {
        Stage::Layer(Layer::Surface) => rendered.surface.iter().map(surface_color).collect(),
        Stage::Layer(Layer::Depth) => depth_colors(&rendered.depth),
        Stage::Layer(Layer::Normal) => rendered.normal.iter().map(|n| n.map(|c| 0.5 + 0.5 * c)).collect(),
        Stage::Layer(Layer::State) => rendered.state.iter().map(|&s| state_color(s)).collect(),
        Stage::Layer(Layer::History) => rendered.history.iter().map(|h| id_color(h.0)).collect(),
        Stage::Layer(Layer::Certificates) => rendered.certificates.iter().map(|&c| cause_color(c)).collect(),
        Stage::Picture => rendered.colors.clone(),
    }
}

fn depth_colors(depths: &[f32]) -> Vec<[f32; 3]> {
    let finite = || depths.iter().copied().filter(|d| d.is_finite()).map(f64::from);
    let nearest = finite().fold(f64::INFINITY, f64::min);
    // Floors reach to the horizon: what is farther than this is one colour.
    let farthest = finite().fold(0.0, f64::max).min(4.0 * nearest);
    depths.iter().map(|&d| depth_color(f64::from(d), nearest, farthest)).collect()
}

fn cause_color(cause: Option<Certificate>) -> [f32; 3] {
    cause.map_or([0.0; 3], |certificate| id_color(certificate as u64))
}

fn state_color(state: SampleState) -> [f32; 3] {
    match state {
        SampleState::Traced => [1.0; 3],
        SampleState::Shaded => [0.5; 3],
        SampleState::Filled => [0.0; 3],
        SampleState::Pending => [1.0, 0.0, 0.0],
    }
}
