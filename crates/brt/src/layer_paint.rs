//! Layers of a picture as colours for picture files, and as values for EXR: those of the renderer, and the error.

use brt_image::{Encoding, heat_color};
use brt_render::{Layer, LayerPainter, LayerRows, Rows};
use brt_scene::Scene;

use crate::layers::PictureLayer;
use crate::measure::error_levels;

/// Turns rows of any layer into colours or values.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PicturePainter {
    painter: LayerPainter,
    /// How the picture is stored, whose error is shown.
    encoding: Encoding,
}

impl PicturePainter {
    pub(crate) fn new(scene: &Scene, encoding: Encoding) -> Self {
        Self { painter: LayerPainter::new(scene), encoding }
    }

    /// One colour for each pixel of the rows.
    pub(crate) fn colors(&self, layer: PictureLayer, rows: &Rows) -> Vec<[f32; 3]> {
        match rows_of(layer, rows) {
            Some(data) => self.painter.colors(data),
            None => self.errors(rows).into_iter().map(|e| heat_color(f64::from(e))).collect(),
        }
    }

    /// The values of each of the layer's channels.
    pub(crate) fn values(&self, layer: PictureLayer, rows: &Rows) -> Vec<Vec<f32>> {
        match rows_of(layer, rows) {
            Some(data) => self.painter.values(data),
            None => vec![self.errors(rows)],
        }
    }

    fn errors(&self, rows: &Rows) -> Vec<f32> {
        let full = rows.full_pixels().unwrap_or(rows.pixels());
        error_levels(self.encoding, rows.pixels(), full).map(|levels| levels as f32).collect()
    }
}

/// What the renderer made for a layer; `None` for the error.
fn rows_of(layer: PictureLayer, rows: &Rows) -> Option<&LayerRows> {
    let source: Layer = layer.source()?;
    rows.layers.iter().find(|data| data.layer() == source)
}

#[cfg(test)]
mod tests {
    use super::*;
    use brt_geometry::{Vec3, vec3};
    use brt_render::SampleState;
    use brt_scene::{Camera, Projection};

    #[test]
    fn each_layer_finds_its_rows() {
        let rows = Rows {
            first: 0,
            width: 2,
            colors: vec![[0.0; 3], [1.0; 3]],
            alpha: None,
            full: Some(vec![[0.0; 3], [0.0; 3]]),
            full_alpha: None,
            layers: vec![
                LayerRows::State(vec![SampleState::Traced, SampleState::Filled]),
                LayerRows::Surface(vec![7, u32::MAX]),
            ],
        };
        let scene = Scene::new(Camera {
            eye: vec3(0.0, 0.0, 10.0),
            look_at: Vec3::ZERO,
            up: vec3(0.0, 1.0, 0.0),
            projection: Projection::Perspective { fov_deg: 40.0 },
        });
        let painter = PicturePainter::new(&scene, Encoding::default());
        assert_eq!(painter.colors(PictureLayer::State, &rows), [[1.0; 3], [0.0; 3]]);
        assert_eq!(painter.values(PictureLayer::Surface, &rows), [[7.0, -1.0]]);
        assert_eq!(painter.values(PictureLayer::Error, &rows), [[0.0, 255.0]]);
    }
}
