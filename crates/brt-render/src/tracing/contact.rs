//! Where glass touches glass.
//!
//! Faces of two transparent solids that touch lie in one plane, and what leaves a plane does not meet it again. So a ray that
//! crosses one face crosses the other with it: it leaves one solid and enters the next at once, and is refracted by the ratio
//! of their indices; between equal ones it goes straight on.

use brt_geometry::Ray;

use super::interaction::Interaction;
use super::search::Met;
use crate::products::PreparedScene;

/// Index of refraction where a ray comes from, over that beyond the face which it meets `here`.
///
/// `nearest` finds the nearest of the primitives that pass, along a ray.
pub(super) fn refraction_ratio(
    scene: &PreparedScene,
    ray: &Ray,
    here: &Interaction,
    nearest: impl FnOnce(&Ray, &dyn Fn(u32) -> bool) -> Option<Met>,
) -> f64 {
    let own = here.material.index_of_refraction;
    let other = match scene.contacts.binary_search(&here.carrier) {
        Ok(_) => nearest(ray, &|id| is_opposite(scene, here.primitive, id))
            .map_or(1.0, |met| scene.material_of(met.primitive).index_of_refraction),
        Err(_) => 1.0,
    };
    if here.from_behind { own / other } else { other / own }
}

/// Is it a face of glass in the same plane that looks to the other side?
fn is_opposite(scene: &PreparedScene, face: u32, other: u32) -> bool {
    let plane = |id: u32| scene.primitives[id as usize].plane();
    scene.carrier(other) == scene.carrier(face)
        && scene.material_of(other).transmission > 0.0
        && plane(face).zip(plane(other)).is_some_and(|(a, b)| a.normal.dot(b.normal) < 0.0)
}
