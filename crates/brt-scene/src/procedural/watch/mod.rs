//! An opened watch movement on a dark mirror.
use crate::*;
pub(super) fn build(_s: u32) -> Scene {
    Scene::new(Camera {
        eye: brt_geometry::vec3(0.0, 0.0, 1.0),
        look_at: brt_geometry::vec3(0.0, 0.0, 0.0),
        up: brt_geometry::vec3(0.0, 1.0, 0.0),
        projection: Projection::Perspective { fov_deg: 30.0 },
    })
}
