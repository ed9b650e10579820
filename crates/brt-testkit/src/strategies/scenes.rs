//! Random scenes with random views.

use std::fmt;

use brt_formats::write_toml;
use brt_geometry::{Affine, Vec3, vec3};
use brt_image::rgb;
use brt_scene::{Camera, Light, Material, MaterialId, Object, Projection, Scene, Shape};
use proptest::prelude::*;

use super::materials::{any_color, any_material};
use super::shapes::any_shape;
use super::{direction, point};

/// A random scene; its debug form is its file.
#[derive(Clone)]
pub struct AnyScene(pub Scene);

impl fmt::Debug for AnyScene {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("\n")?;
        f.write_str(&write_toml(&self.0))
    }
}

/// Scenes of up to `most_objects` objects that are fit to be rendered.
pub fn any_scene(most_objects: usize) -> impl Strategy<Value = AnyScene> {
    let objects = prop::collection::vec((any_shape(), 0_u32..4, any_placement()), 0..=most_objects);
    let materials = prop::collection::vec(any_material(), 4);
    let lights = prop::collection::vec(any_light(), 0..4);
    (objects, materials, lights, any_view(), any_color(), 0_u32..5)
        .prop_map(|(objects, materials, lights, view, background, max_depth)| {
            let objects = objects
                .into_iter()
                .map(|(shape, material, placement)| {
                    placed(Object::new(shape, MaterialId(material)), placement)
                })
                .collect();
            let mut scene = Scene {
                background,
                max_depth,
                lights,
                objects,
                materials: materials.into_iter().zip(0..).map(named).collect(),
                ..Scene::new(view.camera)
            };
            view.place.apply_to(&mut scene);
            AnyScene(scene)
        })
        .prop_filter("fit to be rendered", |scene| scene.0.check().is_empty())
}

/// Mostly where the mesh is; else turned, stretched, mirrored and moved.
fn any_placement() -> impl Strategy<Value = Affine> {
    let axis = || prop::array::uniform3(-1.5..1.5_f64).prop_map(Vec3::from);
    let map = (axis(), axis(), axis(), point(1.0))
        .prop_map(|(a, b, c, offset)| Affine { axes: [a, b, c], offset })
        .prop_filter("keeps volumes", |map| map.determinant().abs() > 0.05);
    prop_oneof![2 => Just(Affine::IDENTITY), 1 => map]
}

fn placed(object: Object, placement: Affine) -> Object {
    match &object.shape {
        Shape::Mesh(_) => Object { transform: placement, ..object },
        _ => object,
    }
}

/// Scenes of these shapes, each with the number of one of three materials that nothing is seen through, and often a floor.
pub(super) fn dull_scene_of(
    shapes: impl Strategy<Value = Vec<(Shape, u32)>>,
) -> impl Strategy<Value = AnyScene> {
    // No glass: between hundreds of faces its rays would never end.
    let dull = any_material().prop_map(|material| Material { transmission: 0.0, opacity: 1.0, ..material });
    let materials = prop::collection::vec(dull, 3);
    let lights = prop::collection::vec(any_light(), 1..4);
    let camera = (point(4.0), point(1.0), direction(), any_projection())
        .prop_map(|(eye, look_at, up, projection)| Camera { eye, look_at, up, projection });
    (shapes, materials, lights, camera, any_color(), any::<bool>())
        .prop_map(|(shapes, materials, lights, camera, background, has_floor)| {
            let floor = Shape::Plane { normal: vec3(0.0, 1.0, 0.0), distance: -1.5 };
            let shapes = shapes.into_iter().chain(has_floor.then_some((floor, 0)));
            let objects = shapes.map(|(shape, material)| Object::new(shape, MaterialId(material)));
            let materials = materials.into_iter().zip(0..).map(named);
            AnyScene(Scene {
                background,
                max_depth: 2,
                lights,
                objects: objects.collect(),
                materials: materials.collect(),
                ..Scene::new(camera)
            })
        })
        .prop_filter("fit to be rendered", |scene| scene.0.check().is_empty())
}

fn named((material, number): (Material, u32)) -> Material {
    Material { name: format!("m{number}"), ..material }
}

fn any_light() -> impl Strategy<Value = Light> {
    prop_oneof![
        3 => (point(8.0), any_color()).prop_map(|(position, color)| Light::Point { position, color }),
        1 => any_spot(),
        1 => (direction(), any_color()).prop_map(|(direction, color)| Light::Directional { direction, color }),
    ]
}

fn any_spot() -> impl Strategy<Value = Light> {
    (point(8.0), direction(), any_color(), 0.0..0.99, 5.0..120.0).prop_map(
        |(position, direction, color, sharpness, outer_deg)| Light::Spot {
            position,
            direction,
            color,
            inner_deg: sharpness * outer_deg,
            outer_deg,
        },
    )
}

/// Where the eye is.
#[derive(Clone, Copy, Debug)]
enum Place {
    /// Somewhere, often far enough away to see everything.
    Anywhere,
    /// In the middle of a glass ball.
    InGlass,
    /// Exactly on an object, or as exactly as its numbers allow.
    OnObject(usize),
    /// So close that an object fills the picture.
    BeforeObject(usize),
}

#[derive(Clone, Debug)]
struct View {
    camera: Camera,
    place: Place,
}

pub(super) fn any_projection() -> impl Strategy<Value = Projection> {
    prop_oneof![
        3 => (5.0..150.0).prop_map(|fov_deg| Projection::Perspective { fov_deg }),
        1 => (0.5..12.0).prop_map(|extent| Projection::Orthographic { extent }),
    ]
}

fn any_view() -> impl Strategy<Value = View> {
    let place = prop_oneof![
        6 => Just(Place::Anywhere),
        1 => Just(Place::InGlass),
        1 => (0_usize..4).prop_map(Place::OnObject),
        1 => (0_usize..4).prop_map(Place::BeforeObject),
    ];
    (point(7.0), point(1.5), direction(), any_projection(), place).prop_map(
        |(eye, look_at, up, projection, place)| View {
            camera: Camera { eye, look_at, up, projection },
            place,
        },
    )
}

impl Place {
    fn apply_to(self, scene: &mut Scene) {
        let eye = scene.camera.eye;
        match self {
            Self::Anywhere => {}
            Self::InGlass => {
                let glass = Material {
                    transmission: 0.8,
                    index_of_refraction: 1.5,
                    casts_shadow: false,
                    ..Material::matte("glass", rgb(0.1, 0.1, 0.1))
                };
                let glass = scene.add_material(glass);
                scene.add(Shape::Sphere { center: eye, radius: 0.75 }, glass);
            }
            Self::OnObject(index) => {
                if let Some(object) = scene.objects.get(index) {
                    scene.camera.eye = object.transform.point(point_on(&object.shape));
                }
            }
            Self::BeforeObject(index) => {
                if let Some(object) = scene.objects.get(index) {
                    let on = object.transform.point(point_on(&object.shape));
                    scene.camera.eye = on + vec3(0.01, 0.02, 0.03);
                    scene.camera.look_at = on;
                }
            }
        }
    }
}

fn point_on(shape: &Shape) -> Vec3 {
    match shape {
        Shape::Sphere { center, radius } => *center + vec3(*radius, 0.0, 0.0),
        Shape::Plane { normal, distance } => *normal * (*distance / normal.length_squared()),
        Shape::Polygon { outline, .. } => (outline[0] + outline[1]) * 0.5,
        Shape::Disc { center, .. } => *center,
        Shape::Cylinder { base, .. } | Shape::Cone { base, .. } => *base,
        // Not one of its corners: see the known failures of brt-render.
        Shape::Mesh(mesh) => {
            mesh.triangles[0].iter().fold(Vec3::ZERO, |sum, &i| sum + mesh.positions[i as usize])
                * (1.0 / 3.0)
        }
    }
}
