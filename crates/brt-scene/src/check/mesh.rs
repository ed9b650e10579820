//! Is a mesh fit to be rendered?

use super::{FINITE, Found, fault, in_range, is_in_range};
use crate::Mesh;

pub(super) fn check_mesh(mesh: &Mesh, found: Found) {
    if mesh.positions.iter().any(|p| !in_range(*p)) {
        found("positions", fault("a coordinate is not finite or too large", FINITE));
    }
    if !mesh.normals.is_empty() && mesh.normals.len() != mesh.positions.len() {
        let message = format!("{} normals for {} positions", mesh.normals.len(), mesh.positions.len());
        found("normals", fault(message, "a normal per position, or none"));
    }
    if !mesh.colors.is_empty() && mesh.colors.len() != mesh.positions.len() {
        let message = format!("{} colours for {} positions", mesh.colors.len(), mesh.positions.len());
        found("colors", fault(message, "a colour per position, or none"));
    }
    if mesh.colors.iter().any(|c| !c.is_finite()) {
        found("colors", fault("a channel is not a finite number", "three finite numbers"));
    }
    if !mesh.texcoords.is_empty() && mesh.texcoords.len() != mesh.positions.len() {
        let message =
            format!("{} texture coordinates for {} positions", mesh.texcoords.len(), mesh.positions.len());
        found("texcoords", fault(message, "a pair per position, or none"));
    }
    if mesh.texcoords.iter().flatten().any(|&c| !is_in_range(c)) {
        found("texcoords", fault("a coordinate is not finite or too large", FINITE));
    }
    if let Some(i) = mesh.normals.iter().position(|n| n.try_normalize().is_none()) {
        found("normals", fault(format!("normal {i} has no direction"), "three finite numbers, not all 0"));
    }
    let count = mesh.positions.len();
    let beyond = |t: &[u32; 3]| t.iter().copied().find(|&i| u64::from(i) >= count as u64);
    if let Some((t, i)) = mesh.triangles.iter().find_map(|t| Some((t, beyond(t)?))) {
        let points = if count == 1 { "point" } else { "points" };
        let message = format!("triangle {t:?} uses point {i}, but the mesh has {count} {points}");
        found("triangles", fault(message, "indices from 0 below the number of positions"));
    }
}
