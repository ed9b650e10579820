//! From the scene as data to the scene as the tracers want it.

mod camera;
mod flatten;
mod mesh;

pub use camera::PreparedCamera;

use brt_geometry::Bvh;
use brt_scene::{Light, Scene};

use crate::products::{PreparedLight, PreparedScene};
use flatten::Flattened;

/// Flattens a scene and builds its BVH. The scene must have passed [`Scene::check`].
pub fn prepare(scene: &Scene) -> PreparedScene {
    let Flattened { primitives, infos, surfaces, normals } = Flattened::of(scene);
    let mut boxes = Vec::with_capacity(primitives.len());
    let mut unbounded = Vec::new();
    for (id, primitive) in (0_u32..).zip(&primitives) {
        match primitive.bounds() {
            Some(bounds) => boxes.push((id, bounds)),
            None => unbounded.push(id),
        }
    }
    PreparedScene {
        bvh: Bvh::build(&boxes),
        primitives,
        infos,
        surfaces,
        normals,
        unbounded,
        lights: scene.lights.iter().map(prepare_light).collect(),
        materials: scene.materials.clone(),
        background: scene.background,
    }
}

fn prepare_light(light: &Light) -> PreparedLight {
    match light {
        Light::Point { position, color } => PreparedLight::Point { position: *position, color: *color },
        Light::Directional { direction, color } => PreparedLight::Directional {
            towards: -direction.try_normalize().unwrap_or_default(),
            color: *color,
        },
    }
}
