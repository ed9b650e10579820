//! Layers as colours that people can look at, and as values for files that hold such.

use brt_image::{Transfer, id_color};
use brt_scene::Scene;

use super::layers::LayerRows;
use crate::products::{Certificate, NOTHING, RayHistory, SampleState};
use crate::settings::Layer;

/// Turns rows of layers into colours or values. What a layer's picture shows depends on nothing but its rows and the
/// scene: never on what other rows hold.
#[derive(Clone, Copy, Debug)]
pub struct LayerPainter {
    /// The depth that is shown half-way between white and black.
    middle_depth: f64,
}

impl LayerPainter {
    /// For layers of a picture of this scene.
    pub fn new(scene: &Scene) -> Self {
        Self { middle_depth: middle_depth(scene) }
    }

    /// One linear colour for each pixel. Stored by the layer's [transfer function](Layer::transfer), codes of data are
    /// proportional to it.
    pub fn colors(&self, rows: &LayerRows) -> Vec<[f32; 3]> {
        match rows {
            LayerRows::Surface(ids) => ids.iter().map(|&id| surface_color(id)).collect(),
            LayerRows::Depth(depths) => depths.iter().map(|&d| [self.depth_grey(d); 3]).collect(),
            LayerRows::Normal(normals) => normals.iter().map(|n| n.map(|c| 0.5 + 0.5 * c)).collect(),
            LayerRows::History(histories) => histories.iter().map(|&h| history_color(h)).collect(),
            LayerRows::State(states) => states.iter().map(|&s| [state_grey(s); 3]).collect(),
            LayerRows::Certificates(causes) => causes.iter().map(|&c| cause_color(c)).collect(),
        }
    }

    /// The values of each of the layer's channels: what it holds itself where that is numbers, else its colours.
    pub fn values(&self, rows: &LayerRows) -> Vec<Vec<f32>> {
        match rows {
            LayerRows::Surface(ids) => vec![ids.iter().map(|&id| surface_value(id)).collect()],
            LayerRows::Depth(depths) => vec![depths.clone()],
            LayerRows::Normal(normals) => split(normals),
            LayerRows::History(_) | LayerRows::Certificates(_) => split(&self.colors(rows)),
            LayerRows::State(states) => vec![states.iter().map(|&s| state_grey(s)).collect()],
        }
    }

    /// White at the eye, ½ in the scene's middle, black infinitely far: `1 / (1 + (d / middle)²)`. The range of
    /// depths need not be known before the last row is rendered, nothing is clipped, and contrast is best where
    /// the scene is. Back again: `d = middle · √(1/grey − 1)`.
    fn depth_grey(&self, depth: f32) -> f32 {
        let ratio = f64::from(depth) / self.middle_depth;
        (1.0 / (1.0 + ratio * ratio)) as f32
    }
}

impl Layer {
    /// The transfer function of its picture: codes of data are proportional to it, false colours are colours.
    pub fn transfer(self) -> Transfer {
        match self {
            Self::Depth | Self::Normal | Self::State => Transfer::Linear,
            Self::Surface | Self::History | Self::Certificates => Transfer::Srgb,
        }
    }
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
    if id == NOTHING { [0.0; 3] } else { id_color(u64::from(id)) }
}

/// Numbers beyond 2²⁴ are rounded.
fn surface_value(id: u32) -> f32 {
    if id == NOTHING { -1.0 } else { id as f32 }
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
        LayerPainter::new(&scene)
    }

    #[test]
    fn depth_is_half_in_the_middle_of_the_scene_and_black_beyond_everything() {
        let painter = painter();
        assert!((painter.depth_grey(8.0) - 0.5).abs() < 1e-6);
        assert_eq!(painter.depth_grey(0.0), 1.0);
        assert_eq!(painter.depth_grey(f32::INFINITY), 0.0);
    }

    #[test]
    fn values_are_what_the_layer_holds_and_colors_show_it() {
        let painter = painter();
        let state = LayerRows::State(vec![SampleState::Traced, SampleState::Filled]);
        let normal = LayerRows::Normal(vec![[0.0, 0.0, 1.0], [-1.0, 0.0, 0.0]]);
        let surface = LayerRows::Surface(vec![7, NOTHING]);
        assert_eq!(painter.colors(&state), [[1.0; 3], [0.0; 3]]);
        assert_eq!(painter.colors(&normal), [[0.5, 0.5, 1.0], [0.0, 0.5, 0.5]]);
        assert_eq!(painter.values(&normal), [[0.0, -1.0], [0.0, 0.0], [1.0, 0.0]]);
        assert_eq!(painter.values(&surface), [[7.0, -1.0]]);
        assert_eq!(painter.colors(&surface)[1], [0.0; 3]);
    }
}
