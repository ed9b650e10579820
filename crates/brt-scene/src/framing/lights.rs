//! Three lights that show the shape of things, whatever it is.

use brt_image::{Rgb, rgb};

use crate::{Camera, Light};

/// A key light from the upper left of the picture, a fill light from the right, and a head light at the eye, which
/// casts no shadow that could be seen. Together they leave nothing that is seen quite dark.
pub fn studio_lights(camera: &Camera) -> Vec<Light> {
    let grey = |strength: f64| -> Rgb { rgb(strength, strength, strength) };
    let Some(forward) = (camera.look_at - camera.eye).try_normalize() else { return Vec::new() };
    let right = forward.cross(camera.up).try_normalize().unwrap_or_default();
    let up = right.cross(forward);
    vec![
        Light::Directional { direction: right * 0.55 - up * 0.75 + forward * 0.6, color: grey(0.72) },
        Light::Directional { direction: forward * 0.5 - right * 0.8 - up * 0.2, color: grey(0.28) },
        Light::Point { position: camera.eye, color: grey(0.25) },
    ]
}
