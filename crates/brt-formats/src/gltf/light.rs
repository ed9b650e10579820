//! Lights of KHR_lights_punctual.
//!
//! Theirs have physical units and fall off with distance; ours do not. So each counts with what reaches the middle of
//! the scene, and all together are scaled until that is 1 in the brightest channel.

use brt_geometry::{Vec3, vec3};
use brt_image::{Rgb, rgb};
use brt_scene::Light;
use gltf::khr_lights_punctual::Kind;

use crate::import::{Affine, Draft};

/// Lights with their physical strength.
#[derive(Default)]
pub(super) struct Lights(Vec<Light>);

impl Lights {
    pub(super) fn add(
        &mut self,
        light: &gltf::khr_lights_punctual::Light,
        place: &Affine,
        node: usize,
        draft: &mut Draft,
    ) {
        let [r, g, b] = light.color().map(|c| f64::from(c).clamp(0.0, 1.0));
        let intensity = f64::from(light.intensity());
        let intensity = if intensity.is_finite() { intensity.max(0.0) } else { 0.0 };
        let color = rgb(r, g, b) * intensity;
        let direction = place.direction(vec3(0.0, 0.0, -1.0));
        match light.kind() {
            Kind::Directional => self.0.push(Light::Directional { direction, color }),
            Kind::Point => self.0.push(Light::Point { position: place.origin, color }),
            Kind::Spot { .. } => {
                draft.notices.note("spot lights shine in all directions", format!("node {node}"));
                self.0.push(Light::Point { position: place.origin, color });
            }
        }
    }

    pub(super) fn finish(self, draft: &mut Draft) {
        let center = draft.scene.bounds().map_or(Vec3::ZERO, |[lo, hi]| lo + (hi - lo) * 0.5);
        let mut lights = self.0;
        let mut sum = Rgb::BLACK;
        for light in &mut lights {
            if let Light::Point { position, color } = light {
                let distance = (*position - center).length_squared();
                *color = if distance > 0.0 { *color * (1.0 / distance) } else { *color };
            }
            sum = sum + color_of(light);
        }
        let brightest = sum.r.max(sum.g).max(sum.b);
        if !(brightest > 0.0 && brightest.is_finite()) {
            return;
        }
        for light in &mut lights {
            let (Light::Point { color, .. } | Light::Directional { color, .. }) = light;
            *color = *color * (1.0 / brightest);
        }
        draft.scene.lights = lights;
        draft.given.lights = true;
    }
}

fn color_of(light: &Light) -> Rgb {
    let (Light::Point { color, .. } | Light::Directional { color, .. }) = light;
    *color
}
