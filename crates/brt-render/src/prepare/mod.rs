//! From the scene as data to the scene as the tracers want it.

mod camera;
mod coincident;
mod flatten;
mod mesh;
mod origin;

pub use camera::PreparedCamera;

use brt_geometry::{Aabb, Bvh, Exponent, Extents, Grid, Primitive, SpatialIndex, Vec3};
use brt_image::Rgb;
use brt_scene::{CheckedScene, Light, Material, Scene, Shape};

use crate::products::{
    Beam, PreparedChecker, PreparedLight, PreparedMaterial, PreparedScene, PreparedTexture, PrimitiveInfo,
};
use crate::run::Cancel;
use crate::settings::Accelerator;
#[cfg(test)]
pub(crate) use coincident::keys_for_tests;
use coincident::{contacts, duplicates, layered, share_carriers};
use flatten::Flattened;
use origin::{of_box, origin_of};

/// So few bounded primitives are tested faster than a tree over them is entered.
const FEW: usize = 3;

/// Flattens a scene and builds an index over its primitives; `None` if that was cancelled.
pub(crate) fn prepare(
    scene: &CheckedScene,
    accelerator: Accelerator,
    cancel: Cancel,
) -> Option<PreparedScene> {
    let Placed { origin, bounds, materials, mut flat } = placed(scene, cancel)?;
    let mut carriers = share_carriers(&mut flat.primitives, &bounds, origin, cancel);
    cancel.go_on()?;
    flat.remove(&duplicates(&flat.primitives, &flat.infos, &carriers, &materials), &mut carriers);
    let Flattened { primitives, infos, surfaces, normals, colors, texcoords, .. } = flat;
    let contacts = contacts(&primitives, &infos, &carriers, &materials);
    let layered = layered(&infos, &carriers, &materials);
    let dims = |info: &PrimitiveInfo| info.casts_shadow && materials[info.material as usize].dims();
    let has_dimmers = infos.iter().any(dims);
    let mut boxes = Vec::with_capacity(primitives.len());
    let mut outside = Vec::new();
    for (id, primitive) in (0_u32..).zip(&primitives) {
        match primitive.bounds() {
            Some(bounds) => boxes.push((id, bounds)),
            None => outside.push(id),
        }
    }
    if accelerator == Accelerator::Bvh && boxes.len() <= FEW {
        outside.extend(boxes.drain(..).map(|(id, _)| id));
    }
    cancel.go_on()?;
    let index = match accelerator {
        Accelerator::None => SpatialIndex::Everything(boxes.iter().map(|b| b.0).collect()),
        Accelerator::Extents => {
            let object_of = |id: u32| surfaces[infos[id as usize].surface as usize].object;
            SpatialIndex::Extents(Extents::build(&boxes, object_of))
        }
        Accelerator::Grid => SpatialIndex::Grid(Grid::build(&boxes)),
        Accelerator::Bvh => SpatialIndex::Bvh(Bvh::build(&boxes, most_per_leaf(&primitives))),
    };
    cancel.go_on()?;
    Some(PreparedScene {
        index,
        bounds,
        origin,
        carriers,
        contacts,
        layered,
        primitives,
        infos,
        surfaces,
        normals,
        outside,
        lights: scene.lights.iter().map(|light| prepare_light(light, origin)).collect(),
        materials,
        background: scene.background,
        darkest: if has_negative_light(scene) { f32::NEG_INFINITY } else { 0.0 },
        has_dimmers,
        colors,
        texcoords,
    })
}

/// The primitives of a scene near the origin, wherever it is.
struct Placed {
    /// The point of the scene that is there.
    origin: Vec3,
    /// Around all that have a box.
    bounds: Aabb,
    materials: Vec<PreparedMaterial>,
    flat: Flattened,
}

fn placed(scene: &CheckedScene, cancel: Cancel) -> Option<Placed> {
    /// The first move is to the objects, the second to the primitives, and the third forgives the rounding of the second.
    const MOVES: u32 = 3;
    let mut origin = origin_of(scene);
    for moves in 1.. {
        let materials: Vec<_> = scene.materials.iter().map(|m| prepare_material(m, origin)).collect();
        let flat = Flattened::of(scene, origin, &materials, cancel);
        cancel.go_on()?;
        let bounds = flat.primitives.iter().filter_map(Primitive::bounds).reduce(Aabb::union);
        let bounds = bounds.unwrap_or(Aabb::around(Vec3::ZERO, Vec3::ZERO));
        // Points of no face, and faces without an area, count for the boxes of objects and not for those of primitives.
        let beside = of_box([bounds.lo, bounds.hi]);
        let moved = origin + beside;
        if moved == origin || moves == MOVES {
            return Some(Placed { origin, bounds, materials, flat });
        }
        origin = moved;
    }
    None
}

/// May anything look darker than black? Files may ask for it.
fn has_negative_light(scene: &Scene) -> bool {
    let is_negative = |c: &Rgb| c.r < 0.0 || c.g < 0.0 || c.b < 0.0;
    is_negative(&scene.background)
        || scene.materials.iter().any(|m| {
            [&m.color, &m.emission].into_iter().chain(m.checker.as_ref().map(|c| &c.color)).any(is_negative)
        })
        || scene
            .objects
            .iter()
            .any(|object| matches!(&object.shape, Shape::Mesh(mesh) if mesh.colors.iter().any(is_negative)))
}

fn prepare_light(light: &Light, origin: Vec3) -> PreparedLight {
    match light {
        Light::Point { position, color } => {
            PreparedLight::Point { position: *position - origin, color: *color, beam: None }
        }
        Light::Spot { position, direction, color, inner_deg, outer_deg } => PreparedLight::Point {
            position: *position - origin,
            color: *color,
            beam: Some(Beam::new(*direction, *inner_deg, *outer_deg)),
        },
        Light::Directional { direction, color } => PreparedLight::Directional {
            towards: -direction.try_normalize().unwrap_or_default(),
            color: *color,
        },
    }
}

pub(crate) fn prepare_material(m: &Material, origin: Vec3) -> PreparedMaterial {
    PreparedMaterial {
        color: m.color,
        emission: m.emission,
        opacity: m.opacity,
        checker: m.checker.as_ref().map(|checker| PreparedChecker::new(checker, origin)),
        texture: m.texture.as_ref().map(PreparedTexture::new),
        ambient: m.ambient,
        diffuse: m.diffuse,
        specular: m.specular,
        exponent: Exponent::new(m.exponent),
        highlight: m.highlight,
        reflection: m.reflection,
        transmission: m.transmission,
        index_of_refraction: m.index_of_refraction,
    }
}

/// How many primitives a leaf of the tree may have: to test a triangle costs less than a node, to test a cylinder or a ball
/// more.
fn most_per_leaf(primitives: &[Primitive]) -> u32 {
    let triangles = primitives.iter().filter(|primitive| matches!(primitive, Primitive::Triangle(_))).count();
    if 2 * triangles > primitives.len() { 4 } else { 1 }
}
