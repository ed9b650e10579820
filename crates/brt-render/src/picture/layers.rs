//! Layers: every product of the steps as rows of pixels.
//!
//! Where a pixel has several samples, layers show the one next to its middle.

use brt_geometry::{Start, Vec3};

use crate::prepare::PreparedCamera;
use crate::products::{
    Certificate, NOTHING, PerspectiveImage, PreparedScene, RayHistory, SampleGrid, SampleState, Tile,
    TileSamples,
};
use crate::settings::Layer;
use crate::tracing::Interaction;

/// Rows of a layer.
#[derive(Clone, Debug, PartialEq)]
pub enum LayerRows {
    /// Positions in [`PreparedScene::surfaces`]; `u32::MAX` for the background.
    Surface(Vec<u32>),
    /// Distances along the view in scene units; infinite for the background.
    Depth(Vec<f32>),
    /// Unit vectors in scene coordinates, towards the viewer's side; 0 for the background.
    Normal(Vec<[f32; 3]>),
    /// Ray histories.
    History(Vec<RayHistory>),
    /// States: that of the pixel's most expensive sample.
    State(Vec<SampleState>),
    /// The certificate that failed first; `None` where a sample is filled, and of other methods.
    Certificates(Vec<Option<Certificate>>),
}

impl LayerRows {
    /// Room for a layer of `count` pixels.
    pub(crate) fn empty(layer: Layer, count: usize) -> Self {
        match layer {
            Layer::Surface => Self::Surface(vec![NOTHING; count]),
            Layer::Depth => Self::Depth(vec![f32::INFINITY; count]),
            Layer::Normal => Self::Normal(vec![[0.0; 3]; count]),
            Layer::History => Self::History(vec![RayHistory::default(); count]),
            Layer::State => Self::State(vec![SampleState::Pending; count]),
            Layer::Certificates => Self::Certificates(vec![None; count]),
        }
    }

    /// The layer that these are rows of.
    pub fn layer(&self) -> Layer {
        match self {
            Self::Surface(_) => Layer::Surface,
            Self::Depth(_) => Layer::Depth,
            Self::Normal(_) => Layer::Normal,
            Self::History(_) => Layer::History,
            Self::State(_) => Layer::State,
            Self::Certificates(_) => Layer::Certificates,
        }
    }

    /// Number of pixels.
    pub(crate) fn len(&self) -> usize {
        match self {
            Self::Surface(v) => v.len(),
            Self::Depth(v) => v.len(),
            Self::Normal(v) => v.len(),
            Self::History(v) => v.len(),
            Self::State(v) => v.len(),
            Self::Certificates(v) => v.len(),
        }
    }

    /// Splits off the first `count` pixels.
    pub(crate) fn split_front(&mut self, count: usize) -> Self {
        fn split<T>(v: &mut Vec<T>, count: usize) -> Vec<T> {
            let rest = v.split_off(count);
            std::mem::replace(v, rest)
        }
        match self {
            Self::Surface(v) => Self::Surface(split(v, count)),
            Self::Depth(v) => Self::Depth(split(v, count)),
            Self::Normal(v) => Self::Normal(split(v, count)),
            Self::History(v) => Self::History(split(v, count)),
            Self::State(v) => Self::State(split(v, count)),
            Self::Certificates(v) => Self::Certificates(split(v, count)),
        }
    }

    /// Copies a run of pixels of the same layer.
    pub(crate) fn copy_run(&mut self, to: usize, from: &Self, start: usize, count: usize) {
        fn copy<T: Copy>(to: &mut [T], at: usize, from: &[T], start: usize, count: usize) {
            to[at..at + count].copy_from_slice(&from[start..start + count]);
        }
        match (self, from) {
            (Self::Surface(a), Self::Surface(b)) => copy(a, to, b, start, count),
            (Self::Depth(a), Self::Depth(b)) => copy(a, to, b, start, count),
            (Self::Normal(a), Self::Normal(b)) => copy(a, to, b, start, count),
            (Self::History(a), Self::History(b)) => copy(a, to, b, start, count),
            (Self::State(a), Self::State(b)) => copy(a, to, b, start, count),
            (Self::Certificates(a), Self::Certificates(b)) => copy(a, to, b, start, count),
            _ => debug_assert!(false, "rows of two different layers"),
        }
    }
}

/// What layers are made of.
pub(crate) struct LayerSources<'a> {
    pub(crate) scene: &'a PreparedScene,
    pub(crate) camera: &'a PreparedCamera,
    pub(crate) grid: &'a SampleGrid,
    pub(crate) tile: &'a Tile,
    pub(crate) samples: &'a TileSamples,
    pub(crate) perspective: &'a PerspectiveImage,
}

/// A layer of a tile.
pub(crate) fn tile_layer(layer: Layer, sources: &LayerSources) -> LayerRows {
    let middles = sources.middles();
    match layer {
        Layer::Surface => LayerRows::Surface(middles.map(|i| sources.perspective.surface[i]).collect()),
        Layer::Depth => {
            LayerRows::Depth(middles.map(|i| sources.first_hit(i).map_or(f32::INFINITY, |h| h.0)).collect())
        }
        Layer::Normal => {
            LayerRows::Normal(middles.map(|i| sources.first_hit(i).map_or([0.0; 3], |h| h.1)).collect())
        }
        Layer::History => LayerRows::History(middles.map(|i| sources.samples.history[i]).collect()),
        Layer::State => LayerRows::State(sources.states()),
        Layer::Certificates => LayerRows::Certificates(middles.map(|i| sources.samples.cause[i]).collect()),
    }
}

impl LayerSources<'_> {
    /// Positions of the samples next to the pixels' middles.
    fn middles(&self) -> impl Iterator<Item = usize> + use<> {
        let (tile, n) = (*self.tile, self.grid.per_side);
        let along = move |length: u32| (0..length / n).map(move |p| p * n + n / 2);
        along(tile.height).flat_map(move |y| along(tile.width).map(move |x| tile.index(x, y)))
    }

    /// Depth and shading normal of a sample's first hit.
    fn first_hit(&self, index: usize) -> Option<(f32, [f32; 3])> {
        let primitive = self.perspective.primitive[index];
        if primitive == NOTHING {
            return None;
        }
        let x = self.tile.x + index as u32 % self.tile.width;
        let y = self.tile.y + index as u32 / self.tile.width;
        let ray = self.camera.sample_ray([x, y]);
        let hit = self.scene.primitives[primitive as usize].first_hit(&ray, Start::Elsewhere);
        let Vec3 { x, y, z } = Interaction::at(self.scene, &ray, primitive, hit.t).normal;
        Some((hit.t as f32, [x as f32, y as f32, z as f32]))
    }

    /// The greatest state among each pixel's samples.
    fn states(&self) -> Vec<SampleState> {
        let n = self.grid.per_side;
        let columns = self.tile.width / n;
        let mut states = vec![SampleState::Pending; (columns * (self.tile.height / n)) as usize];
        for (index, &state) in (0_u32..).zip(&self.samples.state) {
            let (x, y) = (index % self.tile.width / n, index / self.tile.width / n);
            let pixel = &mut states[(y * columns + x) as usize];
            *pixel = state.max(*pixel);
        }
        states
    }
}
