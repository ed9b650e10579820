//! The shapes of `[[object]]`.

use brt_scene::Shape;

use super::fields::Fields;
use super::files::Files;
use super::mesh::{MESH_FIELDS, Meshes, meshes_of};
use super::value::{boolean, loops, number, one_of, vector, vectors};

/// Fields that every object has.
const COMMON: &[&str] = &["type", "material", "name"];

#[derive(Clone, Copy)]
enum Kind {
    Sphere,
    Plane,
    Polygon,
    Disc,
    Cylinder,
    Cone,
    Mesh,
}

const KINDS: [(&str, Kind); 7] = [
    ("sphere", Kind::Sphere),
    ("plane", Kind::Plane),
    ("polygon", Kind::Polygon),
    ("disc", Kind::Disc),
    ("cylinder", Kind::Cylinder),
    ("cone", Kind::Cone),
    ("mesh", Kind::Mesh),
];

/// Reads the shape that the field `type` names; several where a file has several.
pub(super) fn read_shapes(fields: &mut Fields, meshes: &Meshes, files: &mut Files) -> Option<Vec<Shape>> {
    let kind = fields.required("type", |value| one_of("type", value, &KINDS))?;
    let (what, known) = describe(kind);
    fields.now_called(what);
    let is_mesh = matches!(kind, Kind::Mesh);
    fields.only(&[COMMON, known, if is_mesh { &["transform", "mesh", "import"] } else { &[] }]);
    let shape = match kind {
        Kind::Sphere => sphere(fields),
        Kind::Plane => plane(fields),
        Kind::Polygon => polygon(fields),
        Kind::Disc => disc(fields),
        Kind::Cylinder => cylinder(fields),
        Kind::Cone => cone(fields),
        Kind::Mesh => {
            let found = meshes_of(fields, meshes, files)?;
            return Some(found.into_iter().map(Shape::Mesh).collect());
        }
    };
    shape.map(|shape| vec![shape])
}

/// What messages call a kind, and its own fields.
fn describe(kind: Kind) -> (&'static str, &'static [&'static str]) {
    match kind {
        Kind::Sphere => ("the sphere", &["center", "radius"]),
        Kind::Plane => ("the plane", &["normal", "distance"]),
        Kind::Polygon => ("the polygon", &["outline", "holes"]),
        Kind::Disc => ("the disc", &["center", "normal", "radius"]),
        Kind::Cylinder => ("the cylinder", &["base", "top", "radius", "capped"]),
        Kind::Cone => ("the cone", &["base", "base_radius", "top", "top_radius", "capped"]),
        Kind::Mesh => ("the mesh", MESH_FIELDS),
    }
}

// All fields are read before the first `?`, so that every error of an object is said.

fn sphere(fields: &mut Fields) -> Option<Shape> {
    let center = fields.required("center", vector);
    let radius = fields.required("radius", number);
    Some(Shape::Sphere { center: center?, radius: radius? })
}

fn plane(fields: &mut Fields) -> Option<Shape> {
    let normal = fields.required("normal", vector);
    let distance = fields.required("distance", number);
    Some(Shape::Plane { normal: normal?, distance: distance? })
}

fn polygon(fields: &mut Fields) -> Option<Shape> {
    let outline = fields.required("outline", vectors);
    let holes = fields.or("holes", Vec::new(), loops);
    Some(Shape::Polygon { outline: outline?, holes: holes? })
}

fn disc(fields: &mut Fields) -> Option<Shape> {
    let center = fields.required("center", vector);
    let normal = fields.required("normal", vector);
    let radius = fields.required("radius", number);
    Some(Shape::Disc { center: center?, normal: normal?, radius: radius? })
}

fn cylinder(fields: &mut Fields) -> Option<Shape> {
    let base = fields.required("base", vector);
    let top = fields.required("top", vector);
    let radius = fields.required("radius", number);
    let capped = fields.or("capped", true, boolean);
    Some(Shape::Cylinder { base: base?, top: top?, radius: radius?, capped: capped? })
}

fn cone(fields: &mut Fields) -> Option<Shape> {
    let base = fields.required("base", vector);
    let base_radius = fields.required("base_radius", number);
    let top = fields.required("top", vector);
    let top_radius = fields.required("top_radius", number);
    let capped = fields.or("capped", true, boolean);
    Some(Shape::Cone {
        base: base?,
        base_radius: base_radius?,
        top: top?,
        top_radius: top_radius?,
        capped: capped?,
    })
}
