//! Textures that are not seen, since what has them has no place in a picture.

use brt_scene::{Object, Place, Scene, Shape};

use super::scene::Places;
use crate::common::Problems;
use crate::import::Notices;

/// Warns of them, once for each kind of object.
pub(super) fn note_textures(scene: &Scene, places: &Places, problems: &mut Problems) {
    let mut notices = Notices::default();
    for (i, object) in scene.objects.iter().enumerate() {
        if !shows_texture(object) && has_texture(object, scene) {
            let what = match &object.shape {
                Shape::Mesh(_) => "texture not seen: the mesh has no `texcoords`".to_owned(),
                other => format!("texture not seen: a {} has no `texcoords`, only a mesh has", other.kind()),
            };
            notices.note(&what, places.span(Place::Object(i, "material")).unwrap_or_default());
        }
    }
    notices.into_report().diagnostics.into_iter().for_each(|warning| problems.push(warning));
}

fn shows_texture(object: &Object) -> bool {
    matches!(&object.shape, Shape::Mesh(mesh) if !mesh.texcoords.is_empty())
}

fn has_texture(object: &Object, scene: &Scene) -> bool {
    scene.materials.get(object.material.0 as usize).is_some_and(|material| material.texture.is_some())
}
