//! `--background`: a colour, or none.

use brt::Transfer;
use brt::image::{Picture, PictureLimits, decode_picture};

use crate::bench::Bench;

const QUICK: &str = "-s 64x48 --samples 4";

/// A ball and a mirror ball before a blue background, without a floor.
const BALLS: &str = r#"
background = [0, 0, 1]
[camera]
eye = [0, 0, 8]
look_at = [0, 0, 0]
fov_deg = 40
[[light]]
type = "directional"
direction = [0, 0, -1]
color = [1, 1, 1]
[materials.clay]
color = [0.9, 0.35, 0.2]
[materials.mirror]
color = [1, 1, 1]
ambient = 0
diffuse = 0
reflection = 1
[[object]]
type = "sphere"
material = "clay"
center = [-1, 0, 0]
radius = 1
[[object]]
type = "sphere"
material = "mirror"
center = [1.5, 0, 0]
radius = 1
"#;

fn bench() -> Bench {
    let bench = Bench::new();
    bench.write("balls.toml", BALLS);
    bench
}

fn picture(bench: &Bench, arguments: &str, name: &str) -> Picture {
    bench.done(&format!("render balls.toml {name} {QUICK} {arguments}"));
    decode_picture(&bench.read(name), PictureLimits::default()).unwrap()
}

const CORNER: usize = 0;
/// In the middle of the mirror ball, which shows what is behind the eye.
const MIRROR: usize = 24 * 64 + 44;
const BALL: usize = 24 * 64 + 23;

#[test]
fn a_colour_is_the_background_also_in_mirrors() {
    let bench = bench();
    let own = picture(&bench, "", "own.png");
    assert_eq!([own.levels(CORNER), own.levels(MIRROR)], [[0.0, 0.0, 255.0]; 2]);
    let red = picture(&bench, "--background red", "red.png");
    assert_eq!([red.levels(CORNER), red.levels(MIRROR)], [[208.0, 48.0, 48.0]; 2]);
    let code = picture(&bench, "--background #102030", "code.png");
    assert_eq!(code.levels(CORNER), [16.0, 32.0, 48.0]);
    assert!(!own.has_alpha() && !red.has_alpha());
}

#[test]
fn transparent_leaves_the_background_out_but_not_of_mirrors() {
    let bench = bench();
    for (name, white) in [("a.png", 255.0), ("a.exr", 255.0)] {
        let open = picture(&bench, "--background transparent", name);
        assert_eq!((open.levels(CORNER), open.alpha_level(CORNER)), ([0.0; 3], 0.0), "{name}");
        assert_eq!(open.levels(MIRROR), [0.0, 0.0, white], "{name}");
        assert_eq!([open.alpha_level(MIRROR), open.alpha_level(BALL)], [255.0; 2], "{name}");
        // Some of the four samples of an edge pixel are covered.
        let parts: Vec<f64> = (0..64 * 48).map(|i| open.alpha_level(i)).collect();
        assert!(parts.iter().any(|&alpha| alpha > 60.0 && alpha < 195.0), "{name}");
    }
    let deep = picture(&bench, "--no-background --bits 16", "deep.png");
    assert_eq!((deep.alpha_level(CORNER), deep.alpha_level(BALL)), (0.0, 255.0));
    picture(&bench, "--no-background", "b.png");
    assert!(bench.read("a.png") == bench.read("b.png"));
}

#[test]
fn edges_have_the_colour_of_what_covers_them() {
    let bench = bench();
    let open = picture(&bench, "--no-background --bits 16 --linear", "a.png");
    let clay = [0.9, 0.35, 0.2];
    for i in (0..64 * 48).filter(|&i| open.alpha_level(i) > 0.0 && i % 64 < 32) {
        // All are shades of clay: neither the background nor black is mixed in.
        let [r, g, b] = open.levels(i);
        let shade = r / clay[0];
        assert!((g - shade * clay[1]).abs() < 0.01 && (b - shade * clay[2]).abs() < 0.01, "pixel {i}");
        assert!(Transfer::Linear.encode(shade / 255.0) > 0.1, "pixel {i}");
    }
}

#[test]
fn every_method_and_number_of_threads_gives_the_same_alpha() {
    let bench = bench();
    for method in ["full", "item-buffer", "scan-line", "pencil", "border", "certified"] {
        let arguments = format!("--no-background --method {method}");
        let one = picture(&bench, &format!("{arguments} -j 1"), "one.png");
        for threads in [2, 3] {
            picture(&bench, &format!("{arguments} -j {threads}"), "many.png");
            assert!(bench.read("one.png") == bench.read("many.png"), "{method} {threads}");
        }
        let full = picture(&bench, "--no-background --method full", "full.png");
        for i in 0..64 * 48 {
            assert_eq!(one.alpha_level(i), full.alpha_level(i), "{method}, pixel {i}");
        }
    }
    picture(&bench, "--no-background --method pixel-selected", "a.png");
}

#[test]
fn verification_layers_pixels_and_sheets_know_alpha() {
    let bench = bench();
    let render = |arguments: &str| bench.done(&format!("render balls.toml {QUICK} {arguments}"));
    for output in ["a.png", "a.exr", "a.png --filter gaussian"] {
        let ended =
            render(&format!("-o {output} --no-background --verify --max-error 1 --layers depth,error"));
        assert!(ended.text().starts_with("3,072 pixels checked, greatest error"), "{}", ended.text());
        assert!(ended.text().contains(", 0 above 1"), "{}", ended.text());
    }
    let layer = decode_picture(&bench.read("a.depth.png"), PictureLimits::default()).unwrap();
    assert!(!layer.has_alpha());
    assert!(render("--no-background --pixel 0,0").text().contains("alpha    0"));
    assert!(render("--no-background --pixel 44,24").text().contains("alpha    1"));
    let sheet = picture(&bench, "--no-background --sheet", "sheet.png");
    assert_eq!(sheet.alpha_level(CORNER), 0.0);
}

#[test]
fn what_cannot_be_transparent_is_wrong_use() {
    let bench = bench();
    let refused = |arguments: &str, part: &str| {
        let ended = bench.run(&format!("render balls.toml {arguments}"));
        assert_eq!(ended.code, Some(2), "{arguments}: {}", ended.errors);
        assert!(ended.errors.contains(part), "{arguments}: {}", ended.errors);
    };
    let ppm = ".ppm cannot hold a transparent background; .png and .exr can";
    refused("-o a.ppm --background transparent", ppm);
    refused("-o a.ppm --no-background", ppm);
    refused("--background mauve", "or transparent");
    refused("--background red --no-background", "cannot be used with");
    assert_eq!(bench.files(), ["ball.toml", "balls.toml"]);
}

#[test]
fn comparing_says_where_alpha_is_missing() {
    let bench = bench();
    picture(&bench, "--no-background", "open.png");
    picture(&bench, "", "closed.png");
    let same = bench.done("compare open.png open.png --max-error 0");
    assert_eq!(same.errors, "");
    let ended = bench.run("compare open.png closed.png --max-error 254");
    assert_eq!(ended.code, Some(3));
    assert!(ended.errors.contains("closed.png has no alpha: compared as if it were opaque"));
    assert!(ended.text().contains("max error   255"), "{}", ended.text());
}
