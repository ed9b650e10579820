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
    pub(super) fn add(&mut self, light: &gltf::khr_lights_punctual::Light, place: &Affine) {
        let [r, g, b] = light.color().map(|c| f64::from(c).clamp(0.0, 1.0));
        let intensity = f64::from(light.intensity());
        let intensity = if intensity.is_finite() { intensity.max(0.0) } else { 0.0 };
        let color = rgb(r, g, b) * intensity;
        let direction = place.direction(vec3(0.0, 0.0, -1.0));
        match light.kind() {
            Kind::Directional => self.0.push(Light::Directional { direction, color }),
            Kind::Point => self.0.push(Light::Point { position: place.origin, color }),
            Kind::Spot { inner_cone_angle, outer_cone_angle } => {
                let outer_deg = f64::from(outer_cone_angle).to_degrees().clamp(1e-3, 90.0);
                let inner_deg = f64::from(inner_cone_angle).to_degrees().clamp(0.0, 0.999 * outer_deg);
                let position = place.origin;
                self.0.push(Light::Spot { position, direction, color, inner_deg, outer_deg });
            }
        }
    }

    pub(super) fn finish(self, draft: &mut Draft) {
        let center = draft.scene.bounds().map_or(Vec3::ZERO, |[lo, hi]| lo + (hi - lo) * 0.5);
        let mut lights = self.0;
        let mut sum = Rgb::BLACK;
        for light in &mut lights {
            if let Light::Point { position, color } | Light::Spot { position, color, .. } = light {
                let distance = (*position - center).length_squared();
                *color = if distance > 0.0 { *color * (1.0 / distance) } else { *color };
            }
            sum = sum + light.color();
        }
        let brightest = sum.r.max(sum.g).max(sum.b);
        if !(brightest > 0.0 && brightest.is_finite()) {
            return;
        }
        for light in &mut lights {
            *light.color_mut() = light.color() * (1.0 / brightest);
        }
        draft.scene.lights = lights;
        draft.given.lights = true;
    }
}
