//! Meshes: inside an object, or in a table `[meshes.NAME]` that objects share.

use std::collections::HashMap;
use std::sync::Arc;

use brt_scene::Mesh;
use toml::de::{DeTable, DeValue};

use super::fields::{Fields, did_you_mean};
use super::files::Files;
use super::value::{Value, colors, error, mismatch, pairs, triangles, vectors};
use crate::common::{Budget, Cost, Halt, Problems, excerpt};

/// Fields of a mesh.
pub(super) const MESH_FIELDS: &[&str] = &["positions", "normals", "colors", "texcoords", "triangles"];

/// Meshes by name; `None` for those with errors.
pub(super) type Meshes<'v> = HashMap<&'v str, Option<Arc<Mesh>>>;

/// Reads the tables `[meshes.NAME]`.
pub(super) fn read_meshes<'v>(
    root: &'v DeTable,
    budget: &Budget,
    problems: &mut Problems,
) -> Result<Meshes<'v>, Halt> {
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
        budget.spend(Cost::Point, mesh.as_ref().map_or(0, |m| m.positions.len()) as u64)?;
        meshes.insert(key.get_ref().as_ref(), mesh.map(Arc::new));
    }
    Ok(meshes)
}

/// The fields of a mesh.
pub(super) fn read_mesh(fields: &mut Fields) -> Option<Mesh> {
    let positions = fields.required("positions", vectors);
    let normals = fields.or("normals", Vec::new(), vectors);
    let colors = fields.or("colors", Vec::new(), colors);
    let texcoords = fields.or("texcoords", Vec::new(), pairs);
    let triangles = fields.required("triangles", triangles);
    Some(Mesh {
        positions: positions?,
        normals: normals?,
        colors: colors?,
        texcoords: texcoords?,
        triangles: triangles?,
    })
}

/// The meshes of an object: its own, the one that its field `mesh` names, or those of the file that `import` names.
pub(super) fn meshes_of(fields: &mut Fields, meshes: &Meshes, files: &mut Files) -> Option<Vec<Arc<Mesh>>> {
    let (mesh, import) = (fields.value("mesh"), fields.value("import"));
    let own = MESH_FIELDS.iter().find_map(|field| fields.value(field));
    let read = match (mesh, import, own) {
        (None, None, _) => return read_mesh(fields).map(|mesh| vec![Arc::new(mesh)]),
        (Some(_), Some(import), _) => {
            let message = "the mesh has both `mesh` and `import`";
            Err(error(message, import, "one of them"))
        }
        (Some(_), _, Some(own)) => {
            let message = "the mesh has a field of its own beside `mesh`";
            Err(error(message, own, "`mesh` or the fields of a mesh, not both"))
        }
        (_, Some(_), Some(own)) => {
            let message = "the mesh has a field of its own beside `import`";
            Err(error(message, own, "`import` or the fields of a mesh, not both"))
        }
        (Some(value), None, None) => named(value, meshes).map(|mesh| mesh.map(|mesh| vec![mesh])),
        (None, Some(value), None) => files.meshes(value, fields.problems).map(Some),
    };
    read.unwrap_or_else(|diagnostic| {
        fields.problems.push(diagnostic);
        None
    })
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
