//! The whole file: picture, camera, lights, materials, objects.

use std::collections::HashMap;
use std::ops::Range;
use std::sync::Arc;

use brt_geometry::{Affine, vec3};
use brt_image::Rgb;
use brt_scene::{Camera, Diagnostic, Material, MaterialId, Object, Place, Projection, Scene, Shape};
use toml::de::{DeTable, DeValue};

use super::fields::{Fields, did_you_mean};
use super::files::Files;
use super::light::read_light;
use super::material::read_material;
use super::mesh::{Meshes, read_meshes};
use super::shape::read_shapes;
use super::value::{Value, color, error, matrix, mismatch, number, one_of, size, text, vector, whole};
use crate::common::{Budget, Cost, Halt, Problems, excerpt};

const KNOWN: &[&str] =
    &["size", "max_depth", "background", "camera", "light", "materials", "meshes", "object"];

/// A scene whose parts remember the values that they were read from.
pub(super) struct Read<'v, 'a> {
    pub(super) scene: Scene,
    pub(super) places: Places<'v, 'a>,
}

/// The values that the parts of a scene were read from.
pub(super) struct Places<'v, 'a> {
    root: &'v DeTable<'a>,
    lights: Vec<&'v Value<'a>>,
    materials: Vec<&'v Value<'a>>,
    objects: Vec<&'v Value<'a>>,
}

impl Places<'_, '_> {
    /// The place in the file: the field's value, or its table where the field is left out.
    pub(super) fn span(&self, place: Place) -> Option<Range<usize>> {
        let (table, field) = match place {
            Place::Scene(field) => return self.root.get(field).map(Value::span),
            Place::Camera(field) => (self.root.get("camera"), field),
            Place::Light(i, field) => (self.lights.get(i).copied(), field),
            Place::Material(i, field) => (self.materials.get(i).copied(), field),
            Place::Object(i, field) => (self.objects.get(i).copied(), field),
        };
        let value = table?.get_ref().get(field);
        Some(value.or(table)?.span())
    }
}

/// Reads the file's tables. What has errors is left out or replaced, so that the rest can still be checked.
pub(super) fn read_scene<'v, 'a>(
    root: &'v DeTable<'a>,
    files: &mut Files,
    budget: &Budget,
    problems: &mut Problems,
) -> Result<Read<'v, 'a>, Halt> {
    let mut fields = Fields::of_file(root, problems);
    fields.only(&[KNOWN]);
    let mut scene = Scene::new(stand_in());
    scene.size = fields.or("size", None, |v| size(v).map(Some)).flatten();
    let depth = |v: &Value| whole(v, Scene::GREATEST_MAX_DEPTH, "a whole number from 0 to 1000");
    scene.max_depth = fields.or("max_depth", scene.max_depth, depth).unwrap_or(scene.max_depth);
    scene.background = fields.or("background", Rgb::BLACK, color).unwrap_or(Rgb::BLACK);
    match fields.value("camera") {
        Some(value) => scene.camera = read_camera(value, fields.problems).unwrap_or(scene.camera),
        None => {
            let message = "the file has no camera";
            fields.problems.push(Diagnostic::error(message, None).expecting("a table [camera]"));
        }
    }
    if let Some(size) = scene.size {
        budget.limits().allow_picture(size)?;
    }
    let places = Places { root, lights: Vec::new(), materials: Vec::new(), objects: Vec::new() };
    let mut read = Read { scene, places };
    read_lights(&mut read, problems);
    let names = read_materials(&mut read, files, problems);
    let meshes = read_meshes(root, budget, problems)?;
    for value in tables(root, "object", problems) {
        if problems.is_full() {
            break;
        }
        let objects = read_object(value, &names, &meshes, files, problems).unwrap_or_default();
        for object in objects {
            spend(&object.shape, budget)?;
            read.scene.objects.push(object);
            read.places.objects.push(value);
        }
    }
    Ok(read)
}

/// A camera without faults, for files whose own has some.
fn stand_in() -> Camera {
    Camera {
        eye: vec3(0.0, 0.0, 1.0),
        look_at: vec3(0.0, 0.0, 0.0),
        up: vec3(0.0, 1.0, 0.0),
        projection: Projection::Perspective { fov_deg: 45.0 },
    }
}

fn read_camera(value: &Value, problems: &mut Problems) -> Option<Camera> {
    #[derive(Clone, Copy)]
    enum Kind {
        Perspective,
        Orthographic,
    }
    const KINDS: [(&str, Kind); 2] =
        [("perspective", Kind::Perspective), ("orthographic", Kind::Orthographic)];
    const COMMON: &[&str] = &["eye", "look_at", "up", "projection"];

    let mut fields = Fields::of_value(value, "the camera", problems)?;
    let kind = fields.or("projection", Kind::Perspective, |v| one_of("projection", v, &KINDS));
    let eye = fields.required("eye", vector);
    let look_at = fields.required("look_at", vector);
    let up = fields.or("up", vec3(0.0, 1.0, 0.0), vector);
    let projection = match kind? {
        Kind::Perspective => {
            fields.only(&[COMMON, &["fov_deg"]]);
            fields.required("fov_deg", number).map(|fov_deg| Projection::Perspective { fov_deg })
        }
        Kind::Orthographic => {
            fields.now_called("the orthographic camera");
            fields.only(&[COMMON, &["extent"]]);
            fields.required("extent", number).map(|extent| Projection::Orthographic { extent })
        }
    };
    Some(Camera { eye: eye?, look_at: look_at?, up: up?, projection: projection? })
}

fn read_lights(read: &mut Read, problems: &mut Problems) {
    for value in tables(read.places.root, "light", problems) {
        if let Some(light) = read_light(value, problems) {
            read.scene.lights.push(light);
            read.places.lights.push(value);
        }
    }
}

/// Materials in the file's order; one with errors leaves a stand-in, so that objects may name it.
fn read_materials<'v>(
    read: &mut Read<'v, '_>,
    files: &mut Files,
    problems: &mut Problems,
) -> HashMap<&'v str, MaterialId> {
    let Some(value) = read.places.root.get("materials") else {
        return HashMap::new();
    };
    let DeValue::Table(table) = value.get_ref() else {
        problems.push(mismatch(value, "tables [materials.NAME]"));
        return HashMap::new();
    };
    // The table is sorted by name.
    let mut entries: Vec<_> = table.iter().collect();
    entries.sort_by_key(|(key, _)| key.span().start);
    let mut names = HashMap::new();
    for (key, value) in entries {
        let name = key.get_ref().as_ref();
        let material = read_material(name, value, files, problems);
        let id = read.scene.add_material(material.unwrap_or_else(|| Material::matte(name, Rgb::WHITE)));
        read.places.materials.push(value);
        names.insert(name, id);
    }
    names
}

/// The objects of a table: one, or several where its mesh comes from a file of several.
fn read_object(
    value: &Value,
    names: &HashMap<&str, MaterialId>,
    meshes: &Meshes,
    files: &mut Files,
    problems: &mut Problems,
) -> Option<Vec<Object>> {
    let mut fields = Fields::of_value(value, "the object", problems)?;
    let shapes = read_shapes(&mut fields, meshes, files);
    let material = fields.required("material", |value| material_named(value, names));
    let name = fields.or("name", None, |value| text(value).map(Some));
    let rows = fields.or("transform", None, |value| matrix(value).map(Some));
    let transform = rows?.map_or(Affine::IDENTITY, Affine::from_rows);
    let (shapes, material, name) = (shapes?, material?, name?);
    let object = |shape| Object { name: name.clone(), shape, material, transform };
    Some(shapes.into_iter().map(object).collect())
}

fn material_named(value: &Value, names: &HashMap<&str, MaterialId>) -> Result<MaterialId, Diagnostic> {
    /// A guess compares with every name: not in files with thousands of them.
    const MOST_GUESSED: usize = 1000;
    let Some(name) = value.get_ref().as_str() else {
        return Err(mismatch(value, "the name of a material"));
    };
    names.get(name).copied().ok_or_else(|| {
        // Sorted, so that the guess does not depend on the order of a hash map.
        let mut known: Vec<_> = names.keys().copied().collect();
        known.sort_unstable();
        known.truncate(MOST_GUESSED);
        let guess = did_you_mean(name, known.into_iter());
        let message = format!("there is no material `{}`{guess}", excerpt(name));
        error(message, value, "the name of a table [materials.NAME]")
    })
}

/// Spends what a shape costs; its words are spent already.
fn spend(shape: &Shape, budget: &Budget) -> Result<(), Halt> {
    match shape {
        Shape::Mesh(mesh) => {
            // The points of a shared mesh were spent where it stands, those of one object's own are spent here.
            let points = if Arc::strong_count(mesh) == 1 { mesh.positions.len() } else { 0 };
            budget.spend(Cost::Point, points as u64)?;
            budget.spend(Cost::Use, 1)?;
            budget.spend(Cost::Triangle, mesh.triangles.len() as u64)
        }
        Shape::Polygon { outline, holes } => {
            let points = outline.len() + holes.iter().map(Vec::len).sum::<usize>();
            budget.spend(Cost::Point, points as u64)?;
            budget.spend(Cost::Shape, 1)
        }
        _ => budget.spend(Cost::Shape, 1),
    }
}

/// The tables `[[key]]`.
fn tables<'v, 'a>(root: &'v DeTable<'a>, key: &str, problems: &mut Problems) -> &'v [Value<'a>] {
    match root.get(key).map(|value| (value, value.get_ref())) {
        None => &[],
        Some((_, DeValue::Array(items))) => items,
        Some((value, _)) => {
            problems.push(mismatch(value, &format!("tables [[{key}]], in double brackets")));
            &[]
        }
    }
}
