//! Textures of things that have no place in a picture: said once per kind, with the first of them.

use std::fs;
use std::path::Path;

use crate::common::{FOUR, png, warnings};
use base64::Engine as _;
use brt_formats::{Format, Limits, import};

/// The warnings about a file in a folder with a picture and materials, as `line: message`.
fn said(format: Format, text: &str) -> Vec<String> {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a.png"), png(2, 2, &FOUR)).unwrap();
    fs::write(folder.path().join("a.mtl"), "newmtl wood\nmap_Kd a.png\nnewmtl clay\n").unwrap();
    let report = read(format, text, folder.path());
    let line = |at: usize| text[..at].matches('\n').count() + 1;
    let place = |span: Option<std::ops::Range<usize>>| span.map_or(0, |span| line(span.start));
    report.into_iter().map(|d| format!("{}: {}", place(d.span), d.message)).collect()
}

fn read(format: Format, text: &str, folder: &Path) -> Vec<brt_scene::Diagnostic> {
    import(format, text.as_bytes(), Some(folder), &Limits::default()).unwrap().report.diagnostics
}

#[test]
fn obj_faces() {
    let points = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n";
    let text = format!("{points}usemtl clay\nf 1 2 3\nusemtl wood\nf 1/1 2/1 3/1\nf 1 2 3\nf 1/1 2/1 3\n");
    assert_eq!(said(Format::Obj, &text), ["10: 2 × face without the coordinates of its texture"]);
    assert_eq!(said(Format::Obj, &format!("{points}usemtl clay\nf 1 2 3\n")), [""; 0]);
}

#[test]
fn ply_files() {
    let text = "ply\nformat ascii 1.0\ncomment TextureFile a.png\nelement vertex 3\nproperty float x\nproperty float y\n\
                property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n2 0 0\n\
                0 1 0\n3 0 1 2\n";
    assert_eq!(said(Format::Ply, text), ["0: the picture `a.png` ignored: points have no place in it"]);
    assert_eq!(said(Format::Ply, &text.replace("TextureFile a.png", "")), [""; 0]);
}

#[test]
fn vrml_shapes() {
    let text = "#VRML V2.0 utf8\nShape {\nappearance Appearance { texture ImageTexture { url \"a.png\" } }\n\
                geometry Sphere { }\n}\n";
    assert_eq!(said(Format::Vrml, text), ["3: textures ignored"]);
}

#[test]
fn toml_objects() {
    let data = base64::engine::general_purpose::STANDARD.encode(png(2, 2, &FOUR));
    let mesh = "[[object]]\ntype = \"mesh\"\nmaterial = \"m\"\npositions = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]\n\
                triangles = [[0, 1, 2]]\n";
    let sphere = "[[object]]\ntype = \"sphere\"\nmaterial = \"m\"\ncenter = [0, 0, 0]\nradius = 1\n";
    let texture = format!("texture = {{ data = \"{data}\" }}");
    let text = format!(
        "[camera]\neye = [0, 0, 5]\nlook_at = [0, 0, 0]\nfov_deg = 45\n[materials.m]\ncolor = [1, 1, 1]\n{texture}\n\
         {mesh}texcoords = [[0, 1], [1, 1], [0, 0]]\n{sphere}{mesh}{sphere}"
    );
    assert_eq!(
        warnings(Format::Toml, &text),
        [
            "16: 2 × texture not seen: a sphere has no `texcoords`, only a mesh has",
            "21: texture not seen: the mesh has no `texcoords`"
        ]
    );
    assert_eq!(warnings(Format::Toml, &text.replace(&texture, "")), [""; 0]);
}
