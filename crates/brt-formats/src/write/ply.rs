//! A mesh of ours as binary PLY that reads back bit by bit.

use std::fmt::Write as _;

use brt_scene::Mesh;

use crate::common::EXACT_PLY;

/// The bytes of the file: doubles, and triangles as faces of three.
pub(super) fn write(mesh: &Mesh) -> Vec<u8> {
    let mut bytes = header(mesh).into_bytes();
    let mut push = |numbers: &[f64]| numbers.iter().for_each(|x| bytes.extend(x.to_le_bytes()));
    for (i, p) in mesh.positions.iter().enumerate() {
        push(&[p.x, p.y, p.z]);
        if let Some(n) = mesh.normals.get(i) {
            push(&[n.x, n.y, n.z]);
        }
        if let Some(c) = mesh.colors.get(i) {
            push(&[c.r, c.g, c.b]);
        }
        if let Some(t) = mesh.texcoords.get(i) {
            push(t);
        }
    }
    for triangle in &mesh.triangles {
        bytes.push(3);
        triangle.iter().for_each(|i| bytes.extend(i.to_le_bytes()));
    }
    bytes
}

fn header(mesh: &Mesh) -> String {
    let mut text = format!("ply\nformat binary_little_endian 1.0\ncomment {EXACT_PLY}\n");
    // Writing to a text cannot fail.
    let _ = writeln!(text, "element vertex {}", mesh.positions.len());
    let mut properties = |are_there: bool, names: &[&str]| {
        for name in names.iter().filter(|_| are_there) {
            let _ = writeln!(text, "property double {name}");
        }
    };
    properties(true, &["x", "y", "z"]);
    properties(!mesh.normals.is_empty(), &["nx", "ny", "nz"]);
    properties(!mesh.colors.is_empty(), &["red", "green", "blue"]);
    properties(!mesh.texcoords.is_empty(), &["s", "t"]);
    let _ = writeln!(text, "element face {}", mesh.triangles.len());
    text.push_str("property list uchar uint vertex_indices\nend_header\n");
    text
}
