//! Scenes written for other ray tracers.

use crate::common::{EVERYTHING, NFF, good};
use brt_formats::{Format, Limits, LoadError, OnlyRead, ParseError, Written, load, parse, write};
use brt_procedural as procedural;

/// The smallest scene with a light, a material with everything but glass, and a sphere.
const TINY: &str = r#"
size = [300, 200]
max_depth = 3
background = [0.25, 0.5, 0.75]
[camera]
eye = [0, 0, 4]
look_at = [0, 0, 0]
fov_deg = 90
[[light]]
type = "point"
position = [1, 2, 3]
color = [1, 1, 0.5]
[materials.tin]
color = [0.5, 0.25, 0.125]
ambient = 0.125
diffuse = 0.5
specular = 0.75
exponent = 20
reflection = 0.25
[[object]]
type = "sphere"
material = "tin"
center = [0, 1, -2]
radius = 1.5
"#;

fn written(format: Format, text: &str) -> (String, Vec<String>) {
    let Written { text, report, .. } = write(format, &good(Format::Toml, text).0).unwrap();
    (text, report.diagnostics.into_iter().map(|d| d.message).collect())
}

#[test]
fn pov_has_our_numbers() {
    let (text, losses) = written(Format::Pov, TINY);
    // tan 45° = 1 over the shorter side: the window is 3 wide and 2 high at distance 1.
    let expected = [
        "#version 3.7;",
        "global_settings { assumed_gamma 1 adc_bailout 0 max_trace_level 4 ambient_light rgb 1 }",
        "background { color rgb <0.25, 0.5, 0.75> }",
        "light_source { <1, 2, 3> color rgb <1, 1, 0.5> }",
        "// tin",
        "#declare M0 = material { texture { pigment { color rgb <0.5, 0.25, 0.125> } finish { ambient 0.125 \
         diffuse 0.5 phong 0.75 phong_size 20 reflection { rgb 0.25 } } } }",
        "sphere { <0, 1, -2>, 1.5 material { M0 } }",
    ];
    let lines: Vec<&str> = text.lines().filter(|line| !line.starts_with("camera")).collect();
    assert_eq!(lines[1..], expected);
    let camera = numbers(text.lines().find(|line| line.starts_with("camera")).unwrap());
    assert_close(&camera, &[0.0, 0.0, 4.0, 0.0, 0.0, -1.0, 3.0, 0.0, 0.0, 0.0, 2.0, 0.0]);
    assert_eq!(losses, [""; 0]);
}

#[test]
fn dat_is_mirrored_and_shifted_by_half_a_pixel() {
    let (text, losses) = written(Format::Dat, TINY);
    for line in [
        "BEGIN_SCENE",
        "RESOLUTION 300 200",
        "  PROJECTION PERSPECTIVE",
        "  RAYDEPTH 4",
        "  CENTER 0 0 -4",
        "LIGHT CENTER 1 2 -3 RAD 0.001 COLOR 1 1 0.5",
        "TEXDEF M0 AMBIENT 0.125 DIFFUSE 0.5 SPECULAR 0.25 OPACITY 1 PHONG PLASTIC 0.75 PHONG_SIZE 20 COLOR 0.5 0.25 \
         0.125 TEXFUNC 0",
        "SPHERE CENTER 0 1 2 RAD 1.5 M0",
        "END_SCENE",
    ] {
        assert!(text.lines().any(|l| l == line), "{line}\n{text}");
    }
    // The window is 3 × 2, a pixel 0.01: half of it is 0.005.
    let frustum = numbers(text.lines().find(|line| line.contains("FRUSTUM")).unwrap());
    assert_close(&frustum, &[-1.505, 1.495, -1.005, 0.995]);
    assert_eq!(losses, ["Tachyon shows the background where `max_depth` ends a path"]);
}

#[test]
fn what_is_lost_is_named() {
    let (text, losses) = written(Format::Pov, EVERYTHING);
    assert!(
        text.contains(
            "checker color rgb <1, 0, 0> transmit 0.5 color rgb <0, 0, 1> transmit 0.5 scale <2, 2,"
        )
    );
    assert!(
        text.contains("polygon { 9, <0, 0, 0>,") && text.contains(" no_shadow }") && text.contains(" open ")
    );
    let parts = ["cones of light", "emission", "partly there", "colours of points", "smooth meshes"];
    assert_eq!(losses.len(), parts.len(), "{losses:?}");
    for (loss, part) in losses.iter().zip(parts) {
        assert!(loss.contains(part), "{loss} does not name {part}");
    }
    assert!(losses[4].ends_with("material `zinc`"), "{losses:?}");

    let (_, losses) = written(Format::Dat, EVERYTHING);
    for part in ["background", "checkers", "refracts nothing", "no cones"] {
        assert!(losses.iter().any(|loss| loss.contains(part)), "{part}: {losses:?}");
    }
}

#[test]
fn glass_of_open_shapes_and_names_with_line_ends_are_no_trouble() {
    let text = TINY.replace("reflection = 0.25", "transmission = 1\nindex_of_refraction = 1.5").replace(
        "type = \"sphere\"\nmaterial = \"tin\"\ncenter = [0, 1, -2]",
        "name = \"a\\nb\"\ntype = \"disc\"\nmaterial = \"tin\"\nnormal = [0, 0, 1]\ncenter = [0, 1, -2]",
    );
    let (text, losses) = written(Format::Pov, &text);
    assert!(text.contains("// a b\n") && text.contains("interior { ior 1.5 }"));
    assert!(losses.iter().any(|loss| loss.contains("glass of open shapes")), "{losses:?}");
    assert!(losses.iter().any(|loss| loss.contains("wholly transparent")), "{losses:?}");
}

#[test]
fn every_procedural_scene_can_be_written() {
    for scene in procedural::ALL {
        let smallest = (1..=64).find_map(|size| scene.build(Some(size)).ok());
        let Some(built) = smallest.or_else(|| scene.build(None).ok()) else { panic!("{}", scene.name) };
        for format in [Format::Pov, Format::Dat] {
            let text = write(format, &built).unwrap().text;
            assert!(!text.contains("NaN") && !text.contains("inf"), "{} as {format:?}", scene.name);
            assert!(text.lines().count() > built.objects.len(), "{} as {format:?}", scene.name);
        }
    }
}

#[test]
fn formats_are_read_or_written() {
    let scene = good(Format::Nff, NFF).0;
    assert_eq!(write(Format::Nff, &scene), Err(OnlyRead(Format::Nff)));
    for format in Format::ALL {
        assert_eq!(write(format, &scene).is_ok(), format.writes(), "{format:?}");
    }
    let parsed = parse(Format::Pov, b"sphere { 0, 1 }", &Limits::default());
    assert!(matches!(parsed, Err(ParseError::OnlyWritten(Format::Pov))));
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.dat");
    std::fs::write(&path, "BEGIN_SCENE").unwrap();
    let error = load(&path, &Limits::default()).unwrap_err();
    assert!(
        matches!(error, LoadError::OnlyWritten { .. }) && error.to_string().contains("not read"),
        "{error}"
    );
}

/// All numbers of a line.
fn numbers(line: &str) -> Vec<f64> {
    let is_part = |c: char| c.is_ascii_digit() || ".-+e".contains(c);
    line.split(|c| !is_part(c)).filter_map(|word| word.parse().ok()).collect()
}

fn assert_close(found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len(), "{found:?}");
    assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "{found:?}");
}
