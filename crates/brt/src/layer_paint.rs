//! Layers as colours for picture files, and as values for EXR.

use brt_image::{Encoding, Transfer, heat_color, id_color};
use brt_render::{Certificate, LayerRows, RayHistory, Rows, SampleState};
use brt_scene::Scene;

use crate::layers::PictureLayer;
use crate::measure::error_levels;

/// Turns rows of a layer into colours or values.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LayerPainter {
    /// The depth that is shown half-way between white and black.
    middle_depth: f64,
    /// How the picture is stored, whose error is shown.
    encoding: Encoding,
}

impl LayerPainter {
    pub(crate) fn new(scene: &Scene, encoding: Encoding) -> Self {
        Self { middle_depth: middle_depth(scene), encoding }
    }

    /// One colour for each pixel of the rows.
    pub(crate) fn colors(&self, layer: PictureLayer, rows: &Rows) -> Vec<[f32; 3]> {
        match rows_of(layer, rows) {
            Some(LayerRows::Surface(ids)) => ids.iter().map(|&id| surface_color(id)).collect(),
            Some(LayerRows::Depth(depths)) => depths.iter().map(|&d| [self.depth_grey(d); 3]).collect(),
            Some(LayerRows::Normal(normals)) => normals.iter().map(|n| n.map(|c| 0.5 + 0.5 * c)).collect(),
            Some(LayerRows::History(histories)) => histories.iter().map(|&h| history_color(h)).collect(),
            Some(LayerRows::State(states)) => states.iter().map(|&s| [state_grey(s); 3]).collect(),
            Some(LayerRows::Certificates(causes)) => causes.iter().map(|&c| cause_color(c)).collect(),
            None => self.errors(rows).into_iter().map(|e| heat_color(f64::from(e))).collect(),
        }
    }

    /// The values of each of the layer's channels.
    pub(crate) fn values(&self, layer: PictureLayer, rows: &Rows) -> Vec<Vec<f32>> {
        match rows_of(layer, rows) {
            Some(LayerRows::Surface(ids)) => vec![ids.iter().map(|&id| surface_value(id)).collect()],
            Some(LayerRows::Depth(depths)) => vec![depths.clone()],
            Some(LayerRows::Normal(normals)) => split(normals),
            Some(LayerRows::History(_) | LayerRows::Certificates(_)) => split(&self.colors(layer, rows)),
            Some(LayerRows::State(states)) => vec![states.iter().map(|&s| state_grey(s)).collect()],
            None => vec![self.errors(rows)],
        }
    }

    /// White at the eye, ½ in the scene's middle, black infinitely far: `1 / (1 + (d / middle)²)`. The range of
    /// depths need not be known before the last row is rendered, nothing is clipped, and contrast is best where
    /// the scene is. Back again: `d = middle · √(1/grey − 1)`.
    fn depth_grey(&self, depth: f32) -> f32 {
        let ratio = f64::from(depth) / self.middle_depth;
        (1.0 / (1.0 + ratio * ratio)) as f32
    }

    fn errors(&self, rows: &Rows) -> Vec<f32> {
        let full = rows.full_pixels().unwrap_or(rows.pixels());
        error_levels(self.encoding, rows.pixels(), full).map(|levels| levels as f32).collect()
    }
}

/// What the renderer made for a layer; `None` for the error.
fn rows_of(layer: PictureLayer, rows: &Rows) -> Option<&LayerRows> {
    rows.layers.iter().find(|data| {
        matches!(
            (layer, data),
            (PictureLayer::Surface, LayerRows::Surface(_))
                | (PictureLayer::Depth, LayerRows::Depth(_))
                | (PictureLayer::Normal, LayerRows::Normal(_))
                | (PictureLayer::History, LayerRows::History(_))
                | (PictureLayer::State, LayerRows::State(_))
                | (PictureLayer::Certificates, LayerRows::Certificates(_))
        )
    })
}

/// Depth of the middle of the box around all bounded objects, or where that is not in front of the eye, the box's
/// diagonal; 1 where there is no box.
fn middle_depth(scene: &Scene) -> f64 {
    let Some([lo, hi]) = scene.bounds() else { return 1.0 };
    let forward = (scene.camera.look_at - scene.camera.eye).try_normalize().unwrap_or_default();
    let depth = ((lo + hi) * 0.5 - scene.camera.eye).dot(forward);
    let candidates = [depth, (hi - lo).length()];
    candidates.into_iter().find(|d| *d > 0.0 && d.is_finite()).unwrap_or(1.0)
}

fn surface_color(id: u32) -> [f32; 3] {
    if id == u32::MAX { [0.0; 3] } else { id_color(u64::from(id)) }
}

/// Numbers beyond 2²⁴ are rounded.
fn surface_value(id: u32) -> f32 {
    if id == u32::MAX { -1.0 } else { id as f32 }
}

fn history_color(history: RayHistory) -> [f32; 3] {
    id_color(history.0)
}

fn state_grey(state: SampleState) -> f32 {
    match state {
        SampleState::Traced => 1.0,
        SampleState::Shaded => 0.5,
        SampleState::Filled | SampleState::Pending => 0.0,
    }
}

/// Colours that the colour-blind tell apart (Okabe, Ito 2008).
fn cause_color(cause: Option<Certificate>) -> [f32; 3] {
    let codes = match cause {
        None => [0, 0, 0],
        Some(Certificate::Visibility) => [213, 94, 0],
        Some(Certificate::Shadow) => [230, 159, 0],
        Some(Certificate::Surface) => [204, 121, 167],
        Some(Certificate::Checker) => [240, 228, 66],
        Some(Certificate::Color) => [0, 158, 115],
        Some(Certificate::Size) => [128, 128, 128],
    };
    codes.map(|code| Transfer::Srgb.decode(f64::from(code) / 255.0) as f32)
}

fn split(colors: &[[f32; 3]]) -> Vec<Vec<f32>> {
    (0..3).map(|i| colors.iter().map(|c| c[i]).collect()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use brt_geometry::{Vec3, vec3};
    use brt_scene::{Camera, Material, Projection, Shape};

    fn painter() -> LayerPainter {
        let mut scene = Scene::new(Camera {
            eye: vec3(0.0, 0.0, 10.0),
            look_at: Vec3::ZERO,
            up: vec3(0.0, 1.0, 0.0),
            projection: Projection::Perspective { fov_deg: 40.0 },
        });
        let grey = scene.add_material(Material::matte("grey", brt_image::rgb(0.5, 0.5, 0.5)));
        scene.add(Shape::Sphere { center: vec3(0.0, 0.0, 2.0), radius: 1.0 }, grey);
        LayerPainter::new(&scene, Encoding::default())
    }

    #[test]
    fn depth_is_half_in_the_middle_of_the_scene_and_black_beyond_everything() {
        let painter = painter();
        assert!((painter.depth_grey(8.0) - 0.5).abs() < 1e-6);
        assert_eq!(painter.depth_grey(0.0), 1.0);
        assert_eq!(painter.depth_grey(f32::INFINITY), 0.0);
    }

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
                LayerRows::Normal(vec![[0.0, 0.0, 1.0], [-1.0, 0.0, 0.0]]),
                LayerRows::Surface(vec![7, u32::MAX]),
            ],
        };
        let painter = painter();
        assert_eq!(painter.colors(PictureLayer::State, &rows), [[1.0; 3], [0.0; 3]]);
        assert_eq!(painter.colors(PictureLayer::Normal, &rows), [[0.5, 0.5, 1.0], [0.0, 0.5, 0.5]]);
        assert_eq!(painter.values(PictureLayer::Normal, &rows), [[0.0, -1.0], [0.0, 0.0], [1.0, 0.0]]);
        assert_eq!(painter.values(PictureLayer::Surface, &rows), [[7.0, -1.0]]);
        assert_eq!(painter.values(PictureLayer::Error, &rows), [[0.0, 255.0]]);
    }
}
