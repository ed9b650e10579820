//! Meshes: inside an object, or in a table `[meshes.NAME]` that objects share.

use std::collections::HashMap;
use std::sync::Arc;

use brt_scene::Mesh;
use toml::de::{DeTable, DeValue};

use super::fields::{Fields, did_you_mean};
use super::value::{Value, colors, error, excerpt, mismatch, triangles, vectors};
use crate::LimitExceeded;
use crate::limits::Counter;
use crate::problems::Problems;

/// Fields of a mesh.
pub(super) const MESH_FIELDS: &[&str] = &["positions", "normals", "colors", "triangles"];

/// Meshes by name; `None` for those with errors.
pub(super) type Meshes<'v> = HashMap<&'v str, Option<Arc<Mesh>>>;

/// Reads the tables `[meshes.NAME]`.
pub(super) fn read_meshes<'v>(
    root: &'v DeTable,
    counter: &mut Counter,
    problems: &mut Problems,
) -> Result<Meshes<'v>, LimitExceeded> {
    let Some(value) = root.get("meshes") else { return Ok(Meshes::new()) };
    let DeValue::Table(table) = value.get_ref() else {
        problems.push(mismatch(value, "tables [meshes.NAME]"));
        return Ok(Meshes::new());
    };
    let mut entries: Vec<_> = table.iter().collect();
    entries.sort_by_key(|(key, _)| key.span().start);
    let mut meshes = Meshes::new();
    for (key, value) in entries {
        let mesh = Fields::of_value(value, "the mesh", problems).and_then(|mut fields| {
            fields.only(&[MESH_FIELDS]);
            read_mesh(&mut fields)
        });
        counter.points(mesh.as_ref().map_or(0, |m| m.positions.len()))?;
        meshes.insert(key.get_ref().as_ref(), mesh.map(Arc::new));
    }
    Ok(meshes)
}

/// The fields of a mesh.
pub(super) fn read_mesh(fields: &mut Fields) -> Option<Mesh> {
    let positions = fields.required("positions", vectors);
    let normals = fields.or("normals", Vec::new(), vectors);
    let colors = fields.or("colors", Vec::new(), colors);
    let triangles = fields.required("triangles", triangles);
    Some(Mesh {
        positions: positions?,
        normals: normals?,
        colors: colors?,
        triangles: triangles?,
        texcoords: Vec::new(),
    })
}

/// The mesh of an object: its own, or the one that its field `mesh` names.
pub(super) fn mesh_of(fields: &mut Fields, meshes: &Meshes) -> Option<Arc<Mesh>> {
    let Some(value) = fields.value("mesh") else { return read_mesh(fields).map(Arc::new) };
    if let Some(own) = MESH_FIELDS.iter().find_map(|field| fields.value(field)) {
        let message = "the mesh has a field of its own beside `mesh`";
        fields.problems.push(error(message, own, "`mesh` or the fields of a mesh, not both"));
        return None;
    }
    match named(value, meshes) {
        Ok(mesh) => mesh,
        Err(diagnostic) => {
            fields.problems.push(diagnostic);
            None
        }
    }
}

fn named(value: &Value, meshes: &Meshes) -> Result<Option<Arc<Mesh>>, brt_scene::Diagnostic> {
    let Some(name) = value.get_ref().as_str() else { return Err(mismatch(value, "the name of a mesh")) };
    meshes.get(name).cloned().ok_or_else(|| {
        // Sorted, so that the guess does not depend on the order of a hash map.
        let mut known: Vec<_> = meshes.keys().copied().take(1000).collect();
        known.sort_unstable();
        let guess = did_you_mean(name, known.into_iter());
        let message = format!("there is no mesh `{}`{guess}", excerpt(name));
        error(message, value, "the name of a table [meshes.NAME]")
    })
}
