//! The Neutral File Format: what its words become, and what is said about the rest.

use crate::common::{NFF, errors, good, warnings};
use brt_formats::{Format, Limits, ParseError, parse};
use brt_geometry::vec3;
use brt_image::rgb;
use brt_scene::{Light, Projection, Scene, Shape};

const VIEW: &str = "v\nfrom 0 -5 3\nat 0 0 0\nup 0 0 1\nangle 45\nhither 1\nresolution 64 64\nl 9 9 9\n";

/// The scene of a file that starts with a good view and light on lines 1 to 8 and a fill on line 9.
fn scene(text: &str) -> (Scene, Vec<String>) {
    let text = format!("{VIEW}f 1 1 1 1 0 1 0 1\n{text}");
    (good(Format::Nff, &text).0, warnings(Format::Nff, &text))
}

fn kinds(scene: &Scene) -> Vec<&'static str> {
    scene.objects.iter().map(|object| object.shape.kind()).collect()
}

#[test]
fn everything_is_read() {
    let (scene, report) = good(Format::Nff, NFF);
    assert!(report.diagnostics.is_empty(), "{report:?}");
    assert_eq!(kinds(&scene), ["polygon", "sphere", "cylinder", "cone", "mesh"]);
    assert_eq!(scene.size, Some([64, 64]));
    assert_eq!(scene.camera.eye, vec3(0.0, -5.0, 3.0));
    assert_eq!(scene.camera.up, vec3(0.0, 0.0, 1.0));
    assert_eq!(scene.camera.projection, Projection::Perspective { fov_deg: 45.0 });
    assert_eq!(scene.background, rgb(0.1, 0.2, 0.3));
    let Shape::Mesh(mesh) = &scene.objects[4].shape else { panic!("the last is a mesh") };
    assert_eq!((mesh.positions.len(), mesh.triangles.len()), (5, 3));
}

#[test]
fn fills_become_materials() {
    let (scene, _) = good(Format::Nff, NFF);
    let glass = &scene.materials[1];
    assert_eq!((glass.ambient, glass.diffuse, glass.specular), (0.0, 0.1, 0.5));
    assert_eq!((glass.exponent, glass.reflection, glass.transmission), (30.0, 0.5, 0.9));
    assert_eq!((glass.index_of_refraction, glass.casts_shadow), (1.5, false));
    assert!(scene.materials[0].casts_shadow);
}

#[test]
fn equal_fills_are_one_material() {
    let (scene, _) = scene("s 0 0 0 1\nf 1 0 0 1 0 1 0 1\ns 1 0 0 1\nf 1 1 1 1 0 1 0 1\ns 2 0 0 1\n");
    assert_eq!(scene.materials.len(), 2);
    assert_eq!(scene.objects[0].material, scene.objects[2].material);
}

#[test]
fn lights_without_colour_share_the_intensity() {
    let (scene, _) = good(Format::Nff, NFF);
    let color = Light::color;
    // √2 / 2 for two lights
    let share = 2.0_f64.sqrt() / 2.0;
    assert_eq!(color(&scene.lights[0]), rgb(share, share, share));
    assert_eq!(color(&scene.lights[1]), rgb(0.5, 0.5, 0.5));
}

#[test]
fn words_may_be_spread_over_lines() {
    let (scene, warnings) = scene("c\n0 0 0 -2\n\n# between\n0 0\n5 2 s 0 0\n0 1");
    assert_eq!(kinds(&scene), ["cylinder", "sphere"]);
    assert_eq!(warnings, [""; 0]);
}

#[test]
fn what_cannot_be_seen_is_left_out() {
    let text = "s 0 0 0 0\nc 0 0 0 1 0 0 0 2\nc 0 0 0 0 0 0 1 0\np 2\n0 0 0\n1 1 1\n\
                p 3\n0 0 0\n1 1 1\n2 2 2\npp 3\n0 0 0 0 0 1\n0 0 0 0 0 1\n0 0 0 0 0 1\ns 0 0 0 1\n";
    let (scene, warnings) = scene(text);
    assert_eq!(kinds(&scene), ["sphere"]);
    assert_eq!(
        warnings,
        [
            "10: a sphere without a radius: left out",
            "11: a cone without a height or a radius: left out",
            "12: a cone without a height or a radius: left out",
            "13: a polygon of fewer than three different points: left out",
            "16: a polygon without an area: left out",
            "20: a patch without an area: left out",
        ]
    );
}

#[test]
fn bent_polygons_become_triangles() {
    let (scene, warnings) = scene("p 4\n0 0 0\n1 0 0\n1 1 0.5\n0 1 0\n");
    let Shape::Mesh(mesh) = &scene.objects[0].shape else { panic!("it is bent") };
    assert_eq!(mesh.triangles.len(), 2);
    assert_eq!(warnings, ["10: the polygon's points are not in one plane: cut into triangles"]);
}

#[test]
fn unknown_words_are_warned_of() {
    let (scene, warnings) =
        scene("f 1 1 1 1 0 1 0 1 p.png\ntess 4\ns 0 0 0 1 7\nf 1 1 1 1 0 1 0 1 # a comment\n");
    assert_eq!(kinds(&scene), ["sphere"]);
    assert_eq!(
        warnings,
        [
            "10: the texture `p.png` is left out",
            "11: `tess` is not understood: the rest of its line is left out",
            "12: the number 7 belongs to no command: left out",
        ]
    );
}

#[test]
fn missing_view_light_and_fill_are_replaced() {
    let text = "s 1 2 3 1\ns 5 2 3 1\n";
    let (scene, _) = good(Format::Nff, text);
    assert_eq!(scene.camera.look_at, vec3(3.0, 2.0, 3.0));
    assert_eq!((scene.lights.len(), scene.materials.len()), (1, 1));
    assert_eq!(
        warnings(Format::Nff, text),
        [
            "-: the file has no view `v`: everything is shown from the front, the right and above",
            "-: the file has no light: one is put beside the eye",
            "1: no fill `f` before this: white and matte",
        ]
    );
}

#[test]
fn errors_have_a_place() {
    assert_eq!(
        errors(Format::Nff, "s 0 0 0 x\ns 0 0 0 nan\nc 1 2\ns 0 0 0 1e400\np -1\np 1.5\ns 0 0"),
        [
            "1: found `x`, expected a sphere, `s x y z radius`",
            "2: `nan` is not a finite number, expected a sphere, `s x y z radius`",
            "4: found `s`, expected a cone, `c x y z radius` and `x y z radius` again",
            "4: `1e400` is not a finite number, expected a sphere, `s x y z radius`",
            "5: -1 is out of range, expected the number of points, `p count`",
            "6: 1.5 is out of range, expected the number of points, `p count`",
            "7: the file ends too early, expected a sphere, `s x y z radius`",
        ]
    );
    assert_eq!(
        errors(Format::Nff, &format!("{VIEW}f 1 1 1 1 0 1 0 1\ns 1e31 0 0 1")),
        ["10: a coordinate is not finite or too large, expected finite numbers up to 1e30"]
    );
    assert_eq!(
        errors(Format::Nff, "nff version 2.00\nviewpos 0 0 0\n"),
        ["-: there is no NFF command in this file, expected lines such as `s 0 0 0 1`"]
    );
}

#[test]
fn counts_do_not_reserve_memory() {
    let found = errors(Format::Nff, "p 4294967295\n0 0 0\n");
    assert_eq!(found, ["3: the file ends too early, expected a point of the polygon, `x y z`"]);
    let limits = Limits { memory: 2000, ..Limits::default() };
    let parsed = parse(Format::Nff, NFF.as_bytes(), &limits);
    assert!(matches!(parsed, Err(ParseError::LimitExceeded(_))));
}

#[test]
fn comments_may_be_in_any_encoding() {
    let (scene, _) = parse(Format::Nff, b"# gr\xfc\xdfe\ns 0 0 0 1\r\n", &Limits::default()).unwrap();
    assert_eq!(scene.objects.len(), 1);
}
