//! Every kind of error in our own format: its line, what is wrong, what was expected.

use crate::common::{EVERYTHING, errors, good};
use brt_formats::{Format, Limits, ParseError, parse};

const CAMERA: &str = "[camera]\neye = [0, 0, 5]\nlook_at = [0, 0, 0]\nfov_deg = 45\n";

/// The errors of a file that starts with a good camera on lines 1 to 4.
fn after_camera(text: &str) -> Vec<String> {
    errors(Format::Toml, &format!("{CAMERA}{text}"))
}

fn sphere(fields: &str) -> Vec<String> {
    after_camera(&format!(
        "[materials.m]\ncolor = [1, 1, 1]\n[[object]]\ntype = \"sphere\"\nmaterial = \"m\"\n{fields}"
    ))
}

#[test]
fn everything_is_read() {
    let (scene, report) = good(Format::Toml, EVERYTHING);
    assert!(report.diagnostics.is_empty());
    assert_eq!(scene.objects.len(), 9);
    assert_eq!(scene.materials.iter().map(|m| m.name.as_str()).collect::<Vec<_>>(), ["zinc", "a b"]);
    assert_eq!((scene.size, scene.max_depth), (Some([64, 48]), 7));
    assert_eq!(scene.objects[0].name.as_deref(), Some("bäll \"1\""));
}

#[test]
fn syntax_errors_have_a_place() {
    let found = after_camera("size = [1,,2]\n");
    assert_eq!(found.len(), 1);
    assert!(found[0].starts_with("5: "), "{found:?}");
}

#[test]
fn a_missing_camera_is_said() {
    assert_eq!(
        errors(Format::Toml, "max_depth = 3\n"),
        ["-: the file has no camera, expected a table [camera]"]
    );
}

#[test]
fn missing_fields_are_said_at_their_table() {
    assert_eq!(
        errors(Format::Toml, "\n[camera]\neye = [0, 0, 5]\n"),
        [
            "2: the camera has no `look_at`, expected `look_at = ...`",
            "2: the camera has no `fov_deg`, expected `fov_deg = ...`",
        ]
    );
    assert_eq!(sphere("radius = 1"), ["7: the sphere has no `center`, expected `center = ...`"]);
}

#[test]
fn unknown_fields_get_a_guess() {
    assert_eq!(
        sphere("center = [0, 0, 0]\nradius = 1\nradus = 2\n"),
        [concat!(
            "12: the sphere has no field `radus`, did you mean `radius`?, expected one of `type`, `material`, ",
            "`name`, `center`, `radius`"
        )]
    );
    let found = after_camera("[materials.m]\ncolor = [1, 1, 1]\nshiny = 1\n");
    assert!(found[0].starts_with("7: the material has no field `shiny`, expected one of"), "{found:?}");
    let found = errors(Format::Toml, &format!("colour = 1\n{CAMERA}"));
    assert!(found[0].starts_with("1: the file has no field `colour`, expected one of `size`"), "{found:?}");
}

#[test]
fn fields_of_another_type_are_unknown() {
    let found = sphere("center = [0, 0, 0]\nradius = 1\nnormal = [0, 1, 0]\n");
    assert!(found[0].starts_with("12: the sphere has no field `normal`"), "{found:?}");
}

#[test]
fn wrong_types_and_lengths_are_said() {
    let with_radius = |radius: &str| sphere(&format!("center = [0, 0, 0]\nradius = {radius}\n"));
    assert_eq!(with_radius("\"1\""), ["11: found text, expected a number"]);
    assert_eq!(with_radius("[1]"), ["11: found a list, expected a number"]);
    assert_eq!(with_radius("{ a = 1 }"), ["11: found a table, expected a number"]);
    assert_eq!(with_radius("2020-01-01"), ["11: found a date or time, expected a number"]);
    assert_eq!(with_radius("true"), ["11: found true or false, expected a number"]);
    let with_center = |center: &str| sphere(&format!("radius = 1\ncenter = {center}\n"));
    assert_eq!(with_center("[1, 2]"), ["11: found a list of 2 values, expected three numbers, [x, y, z]"]);
    assert_eq!(with_center("[1, 2,\n\"x\"]"), ["12: found text, expected a number"]);
}

#[test]
fn numbers_must_be_finite() {
    let with_radius = |radius: &str| sphere(&format!("center = [0, 0, 0]\nradius = {radius}\n"));
    assert_eq!(with_radius("nan"), ["11: nan is not a finite number, expected a finite number"]);
    assert_eq!(with_radius("-inf"), ["11: -inf is not a finite number, expected a finite number"]);
    assert_eq!(with_radius("1e400"), ["11: this number is too large, expected a finite number"]);
    assert_eq!(
        with_radius("0xFFFFFFFFFFFFFFFFF"),
        ["11: this number is too large, expected a number of at most 63 bits"]
    );
}

#[test]
fn the_check_of_the_scene_has_places() {
    assert_eq!(
        sphere("center = [1e31, 0, 0]\nradius = -1\n"),
        [
            "10: a coordinate is not finite or too large, expected finite numbers up to 1e30",
            "11: `radius` is -1, expected a finite number above 0, from 1e-30 to 1e30",
        ]
    );
    let object = "[materials.m]\ncolor = [1, 1, 1]\n[[object]]\ntype = \"polygon\"\nmaterial = \"m\"\n";
    assert_eq!(
        after_camera(&format!("{object}outline = [[0, 0, 0], [1e-31, 0, 0], [0, 1e-31, 0]]\n")),
        ["10: the points lie within 1e-31 of each other, expected a size of at least 1e-30"]
    );
    // `up` is left out: the place is that of the camera.
    assert_eq!(
        errors(Format::Toml, "\n[camera]\neye = [0, 5, 0]\nlook_at = [0, 0, 0]\nfov_deg = 200\n"),
        [
            "2: up points along the view, expected a direction that is not parallel to look_at - eye",
            "5: the field of view is 200°, expected an angle above 0 and below 180",
        ]
    );
}

#[test]
fn unknown_words_get_a_guess() {
    assert_eq!(
        after_camera("[[light]]\ntype = \"pint\"\n"),
        [
            "6: unknown type \"pint\", did you mean `point`?, expected one of \"point\", \"spot\", \"directional\""
        ]
    );
    let object = "[[object]]\ntype = \"sphere\"\ncenter = [0, 0, 0]\nradius = 1\nmaterial = \"gren\"\n";
    assert_eq!(
        after_camera(&format!("[materials.green]\ncolor = [0, 1, 0]\n{object}")),
        [concat!(
            "11: there is no material `gren`, did you mean `green`?, ",
            "expected the name of a table [materials.NAME]"
        )]
    );
}

#[test]
fn single_brackets_where_double_ones_belong() {
    assert_eq!(
        after_camera("[object]\ntype = \"sphere\"\n"),
        ["5: found a table, expected tables [[object]], in double brackets"]
    );
}

#[test]
fn whole_numbers_have_a_range() {
    let found = errors(Format::Toml, &format!("max_depth = 1001\nsize = [0, 1.5]\n{CAMERA}"));
    assert_eq!(
        found,
        [
            "1: 1001 is out of range, expected a whole number from 0 to 1000",
            "2: found a number, expected a number of pixels",
        ]
    );
    let found = errors(Format::Toml, &format!("size = [0, 7]\n{CAMERA}"));
    assert_eq!(found, ["1: the picture has no pixels, expected a width and height of at least 1"]);
}

#[test]
fn several_errors_are_said_but_not_thousands() {
    let text = "[[object]]\ntype = \"sphere\"\n".repeat(1000);
    let found = after_camera(&text);
    assert!((20..=25).contains(&found.len()), "{}", found.len());
}

#[test]
fn faults_of_surfaces_lights_and_meshes_are_said() {
    let found = after_camera("[materials.m]\ncolor = [1, 1, 1]\nopacity = 1.5\nemission = [1, 1]\n");
    assert_eq!(found, ["8: found a list of 2 values, expected a colour of three numbers, [r, g, b]"]);
    let found = after_camera("[materials.m]\ncolor = [1, 1, 1]\nopacity = 1.5\n");
    assert_eq!(found, ["7: `opacity` is 1.5, expected a number from 0 to 1"]);
    let spot =
        "[[light]]\ntype = \"spot\"\nposition = [0, 0, 0]\ndirection = [0, -1, 0]\ncolor = [1, 1, 1]\n";
    assert_eq!(
        after_camera(&format!("{spot}inner_deg = 30\nouter_deg = 20\n")),
        [
            "10: the strength falls from 30° on, the cone ends at 20°, expected an angle from 0, below `outer_deg`"
        ]
    );
    assert_eq!(after_camera(spot), ["5: the spot light has no `outer_deg`, expected `outer_deg = ...`"]);
    let mesh = "[materials.m]\ncolor = [1, 1, 1]\n[meshes.leaf]\npositions = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]\n\
                triangles = [[0, 1, 2]]\n[[object]]\ntype = \"mesh\"\nmaterial = \"m\"\n";
    assert_eq!(
        after_camera(&format!("{mesh}mesh = \"leave\"\n")),
        ["13: there is no mesh `leave`, did you mean `leaf`?, expected the name of a table [meshes.NAME]"]
    );
    assert_eq!(
        after_camera(&format!(
            "{mesh}mesh = \"leaf\"\ntransform = [[1, 0, 0, 0], [0, 1, 0, 0], [1, 1, 0, 0]]\n"
        )),
        ["14: the transform leaves nothing of a volume, expected three rows that differ"]
    );
    assert_eq!(
        after_camera(&format!("{mesh}mesh = \"leaf\"\npositions = []\n")),
        [
            "14: the mesh has a field of its own beside `mesh`, expected `mesh` or the fields of a mesh, not both"
        ]
    );
}

#[test]
fn text_must_be_utf8() {
    let parsed = parse(Format::Toml, b"a = \"\xff\"", &Limits::default());
    assert!(matches!(parsed, Err(ParseError::NotUtf8 { position: 5 })));
}

#[test]
fn limits_are_kept() {
    let exceeded = |limits: Limits| match parse(Format::Toml, EVERYTHING.as_bytes(), &limits) {
        Err(ParseError::LimitExceeded(exceeded)) => exceeded.to_string(),
        other => panic!("{other:?}"),
    };
    let all = Limits::default();
    // Words cost the most here; then come points, shapes and the triangles of each object.
    let mut seen = std::collections::BTreeSet::new();
    for memory in (0..200_000).step_by(16) {
        match parse(Format::Toml, EVERYTHING.as_bytes(), &Limits { memory, ..all }) {
            Ok(_) => break,
            Err(ParseError::LimitExceeded(limit)) => {
                assert!(limit.to_string().contains("`--max-memory SIZE`"), "{limit}");
                let what = limit.to_string();
                seen.extend(
                    ["one file", "words", "points", "shapes", "objects", "triangles"]
                        .into_iter()
                        .filter(|w| what.contains(w)),
                );
            }
            Err(other) => panic!("{other:?}"),
        }
    }
    assert_eq!(seen.len(), 6, "{seen:?}");
    assert!(exceeded(Limits { max_picture_pixels: 64 * 48 - 1, ..all }).contains("a picture of 3072 pixels"));
    let exact = Limits { max_picture_pixels: 64 * 48, ..all };
    assert!(parse(Format::Toml, EVERYTHING.as_bytes(), &exact).is_ok());
}

#[test]
fn integers_keep_all_their_digits() {
    let text = format!("background = [1_000, 0x10, 123456789012345678901234567890]\n{CAMERA}");
    let (scene, _) = good(Format::Toml, &text);
    assert_eq!([scene.background.r, scene.background.g], [1000.0, 16.0]);
    assert_eq!(scene.background.b, 123_456_789_012_345_678_901_234_567_890.0);
}
