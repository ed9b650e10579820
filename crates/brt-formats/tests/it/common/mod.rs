//! Shared by the tests of this crate.
#![allow(dead_code, reason = "every test file uses a part of it")]

use std::path::PathBuf;

use brt_formats::{Format, Limits, ParseError, parse};
use brt_scene::{Report, Scene, Severity};

/// A file of the project.
pub(crate) fn project_file(path: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../..").join(path)
}

/// A scene that must be read, and its report.
pub(crate) fn good(format: Format, text: &str) -> (Scene, Report) {
    let (scene, report) = parse(format, text.as_bytes(), &Limits::default())
        .unwrap_or_else(|error| panic!("{error:?}\n{text}"));
    (scene.into_inner(), report)
}

/// The errors of a text that must not be read, as `line: message, expected ...`.
pub(crate) fn errors(format: Format, text: &str) -> Vec<String> {
    match parse(format, text.as_bytes(), &Limits::default()) {
        Err(ParseError::Malformed(report)) => {
            assert!(report.has_errors());
            listed(&report, text, Severity::Error)
        }
        other => panic!("not malformed: {other:?}\n{text}"),
    }
}

/// The warnings of a text that must be read, as `line: message`.
pub(crate) fn warnings(format: Format, text: &str) -> Vec<String> {
    listed(&good(format, text).1, text, Severity::Warning)
}

fn listed(report: &Report, text: &str, severity: Severity) -> Vec<String> {
    let diagnostics = report.diagnostics.iter().filter(|d| d.severity == severity);
    diagnostics
        .map(|d| {
            let expected = d.expected.as_ref().map(|e| format!(", expected {e}")).unwrap_or_default();
            let line = d.span.as_ref().map(|s| (text[..s.start].matches('\n').count() + 1).to_string());
            format!("{}: {}{expected}", line.unwrap_or("-".into()), d.message)
        })
        .collect()
}

/// A picture as PNG.
pub(crate) fn png(width: u32, height: u32, rgba: &[[u8; 4]]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.write_header().unwrap().write_image_data(rgba.as_flattened()).unwrap();
    bytes
}

/// Red and green above blue and white, the last half transparent.
pub(crate) const FOUR: [[u8; 4]; 4] =
    [[255, 0, 0, 255], [0, 255, 0, 255], [0, 0, 255, 255], [255, 255, 255, 128]];

/// A small scene with one of everything.
pub(crate) const EVERYTHING: &str = r#"# everything
size = [64, 48]
max_depth = 7
background = [0.1, 0.2, 0.3]
[camera]
eye = [0, 1, 8]
look_at = [0, 0, 0]
up = [0, 1, 0.5]
fov_deg = 40.5
[[light]]
type = "point"
position = [1, 2, 3]
color = [1, 1, 1]
[[light]]
type = "directional"
direction = [0, -1, 0]
color = [0.5, 0.5, 0.5]
[[light]]
type = "spot"
position = [0, 5, 0]
direction = [0, -1, 0]
color = [1, 1, 1]
outer_deg = 30
[materials.zinc]
color = [1, 1, 1]
[materials."a b"]
color = [1, 0, 0]
checker = { color = [0, 0, 1], size = 2, axis = "z" }
highlight = "blinn"
transmission = 0.5
index_of_refraction = 1.5
casts_shadow = false
emission = [0.5, 0, 0]
opacity = 0.5
[[object]]
type = "sphere"
name = "bäll \"1\""
material = "zinc"
center = [0, 0, 0]
radius = 1
[[object]]
type = "plane"
material = "a b"
normal = [0, 1, 0]
distance = -1
[[object]]
type = "polygon"
material = "zinc"
outline = [[0, 0, 0], [3, 0, 0], [3, 3, 0], [0, 3, 0]]
holes = [[[1, 1, 0], [1, 2, 0], [2, 2, 0]]]
[[object]]
type = "disc"
material = "zinc"
center = [0, 0, 0]
normal = [0, 0, 2]
radius = 1
[[object]]
type = "cylinder"
material = "zinc"
base = [0, 0, 0]
top = [0, 1, 0]
radius = 0.5
[[object]]
type = "cone"
material = "zinc"
base = [0, 0, 0]
base_radius = 1
top = [0, 1, 0]
top_radius = 0
capped = false
[[object]]
type = "mesh"
material = "zinc"
positions = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
normals = [[0, 0, 1], [0, 0, 1], [0, 0, 1]]
colors = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
triangles = [[0, 1, 2]]
[meshes.leaf]
positions = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
triangles = [[0, 1, 2]]
[[object]]
type = "mesh"
material = "zinc"
mesh = "leaf"
[[object]]
type = "mesh"
material = "zinc"
mesh = "leaf"
transform = [[1, 0, 0, 3], [0, -1, 0, 0], [0, 0, 1, 0]]
"#;

/// A small NFF file with one of everything.
pub(crate) const NFF: &str = "# all
b 0.1 0.2 0.3
v
from 0 -5 3
at 0 0 0
up 0 0 1
angle 45
hither 1
resolution 64 64
l 4 3 2
l 1 -4 4 0.5 0.5 0.5
f 1 0.75 0.33 0.8 0 100000 0 1
p 4
12 12 -0.5
-12 12 -0.5
-12 -12 -0.5
12 -12 -0.5
f 1 1 1 0.1 0.5 30 0.9 1.5
s 0 0 0 0.5
c 0 0 0 0.1 0 0 1 0.1
c 0 0 0 0.2 0 0 1 0
pp 3
0 0 0 0 0 1
1 0 0 0 0 1
0 1 0 0 0 1
pp 4
1 0 0 0 0 1
1 1 0 0 0 1
0.5 1 0 0 0 1
0 1 0 0 0 1
";
