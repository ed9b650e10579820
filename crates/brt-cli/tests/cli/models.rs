//! Model files: framed, coloured, from standard input, and what is said about those that cannot be read.

use std::fs;

use crate::bench::{Bench, SCENE, size_of};

const OFF: &str = "OFF\n4 4 0\n0 0 0\n2 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";

fn bench() -> Bench {
    let bench = Bench::new();
    fs::write(bench.path("part.off"), OFF).unwrap();
    bench
}

#[test]
fn a_model_needs_no_camera_light_or_flag() {
    let bench = bench();
    let ended = bench.done("render part.off -s 40x30 --samples 1");
    assert_eq!((ended.text(), ended.errors.as_str()), ("", ""));
    assert_eq!(size_of(&bench.path("part.png")), [40, 30]);
}

#[test]
fn views_differ_and_take_negative_angles() {
    let bench = bench();
    let picture = |arguments: &str| {
        bench.done(&format!("render part.off a.png -s 32x32 --samples 1 {arguments}"));
        fs::read(bench.path("a.png")).unwrap()
    };
    let pictures = [
        picture(""),
        picture("--view front"),
        picture("--view top --up -z"),
        picture("--view -30,-20"),
        picture("--zoom 0.5"),
        picture("--parallel"),
        picture("--floor"),
        picture("--color #ff0000"),
        picture("--sheet"),
    ];
    for (i, a) in pictures.iter().enumerate() {
        assert!(pictures[..i].iter().all(|b| a != b), "{i}");
    }
    assert_eq!(picture("--view iso --up z"), pictures[0]);
}

#[test]
fn strict_makes_warnings_an_error() {
    let bench = bench();
    fs::write(bench.path("odd.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\ncurv 1 2\n").unwrap();
    assert!(bench.done("render odd.obj --no-save -s 8x8").errors.contains("`curv` ignored"));
    let ended = bench.run("render odd.obj --no-save -s 8x8 --strict");
    assert_eq!(ended.code, Some(1));
    assert!(ended.errors.contains("odd.obj: 1 warning; `--strict` allows none"), "{}", ended.errors);
    bench.done("render part.off --no-save -s 8x8 --strict");
}

#[test]
fn a_texture_that_is_not_seen_is_a_warning_too() {
    let bench = bench();
    bench.done("render part.off wood.png -s 4x4 --samples 1");
    let texture = "[materials.clay]\ntexture = { file = \"wood.png\" }";
    bench.write("wood.toml", &SCENE.replace("[materials.clay]", texture));
    let ended = bench.done("inspect wood.toml");
    for part in ["texture not seen: a sphere has no `texcoords`", "wood.toml:18:", "a plane has no"] {
        assert!(ended.errors.contains(part), "{part}: {}", ended.errors);
    }
    assert_eq!(bench.run("render wood.toml --no-save -s 8x8 --strict").code, Some(1));
}

#[test]
fn formats_that_are_not_read_get_advice() {
    let bench = bench();
    fs::write(bench.path("a.step"), "ISO-10303-21;").unwrap();
    let ended = bench.run("render a.step");
    assert_eq!(ended.code, Some(1));
    assert!(ended.errors.contains("STEP files are not read; export STL, 3MF or GLB"), "{}", ended.errors);
    assert!(bench.done("formats").text().contains(".gltf, .glb"));
}

#[test]
fn a_named_format_is_believed() {
    let bench = bench();
    fs::copy(bench.path("part.off"), bench.path("part.dat")).unwrap();
    bench.done("render part.dat --input-format off --no-save -s 8x8");
    assert_eq!(bench.run("render part.dat --no-save").code, Some(1));
    assert_eq!(bench.run("render part.off --input-format step").code, Some(2));
}

#[test]
fn warnings_are_left_out_where_nobody_wants_them() {
    let bench = bench();
    bench.write("odd.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\ncurv 1 2\n");
    assert!(bench.done("inspect odd.obj").errors.contains("`curv` ignored"));
    assert_eq!(bench.done("inspect odd.obj -q").errors, "");
    assert_eq!(bench.done("convert odd.obj -q -o odd.toml").errors, "");
    bench.done("render odd.toml --no-save -s 8x8 --samples 1");
}

#[test]
fn people_read_six_digits_and_programs_all() {
    let bench = bench();
    bench.write("third.off", &OFF.replace("2 0 0", "0.12345678 0 0"));
    assert!(bench.done("inspect third.off").text().contains("(0.123457, 1, 1)"));
    assert_eq!(bench.done("inspect third.off --json").json()["bounds"][1][0], 0.12345678);
}

#[test]
fn models_are_inspected_and_converted() {
    let bench = bench();
    assert!(bench.done("inspect part.off").text().contains("1 mesh"));
    bench.done("convert part.off part.toml");
    bench.done("render part.toml --no-save -s 8x8 --samples 1");
}

/// The beginning of a hill of 1250 triangles with a picture on it.
const HILL: &str = "mtllib hill.mtl\nusemtl m\n";

#[test]
fn converted_scenes_have_files_beside_them() {
    let bench = bench();
    let mut hill = HILL.to_owned();
    for i in 0..26 * 26 {
        let (a, b) = (f64::from(i % 26), f64::from(i / 26));
        hill += &format!("v {a} {b} {}\nvt {} {}\n", libm::sin(a * 0.3), a / 25.0, b / 25.0);
    }
    for i in 0..25 * 25 {
        let p = i / 25 * 26 + i % 25 + 1;
        hill += &format!("f {p}/{p} {q}/{q} {r}/{r} {s}/{s}\n", q = p + 1, r = p + 27, s = p + 26);
    }
    bench.write("hill.obj", &hill);
    bench.write("hill.mtl", "newmtl m\nmap_Kd wood.png\n");
    bench.done("render part.off -o wood.png -s 8x8");
    bench.done("convert hill.obj out.toml");
    let is_ours = |name: &String| name.starts_with("out.");
    let ours: Vec<String> = bench.files().into_iter().filter(is_ours).collect();
    assert_eq!(ours, ["out.mesh.ply", "out.toml"]);
    let text = String::from_utf8(bench.read("out.toml")).unwrap();
    assert!(text.contains("import = \"out.mesh.ply\"") && text.contains("file = \"wood.png\""), "{text}");
    for name in ["hill.obj", "out.toml"] {
        // Of a model the camera suits the picture's shape; that of the scene was made for a square.
        bench.done(&format!("render {name} -o {name}.png -s 40x40 --samples 1"));
    }
    assert_eq!(bench.read("hill.obj.png"), bench.read("out.toml.png"));
    let piped = bench.done("convert hill.obj -");
    let piped = piped.text();
    assert!(piped.contains("data = \"") && !piped.contains("import"));

    // Again is fine; a file that no scene of ours names is left as it is.
    bench.done("convert hill.obj out.toml");
    bench.write("new.mesh.ply", "mine");
    let ended = bench.run("convert hill.obj new.toml");
    assert_eq!(ended.code, Some(1));
    assert!(ended.errors.contains("new.mesh.ply: another file is there"), "{}", ended.errors);
    assert_eq!(bench.read("new.mesh.ply"), b"mine");
    assert!(!bench.path("new.toml").exists());
    // What cannot be written in full is not begun.
    fs::create_dir(bench.path("folder.toml")).unwrap();
    let before = bench.files();
    assert_eq!(bench.run("convert hill.obj folder.toml").code, Some(1));
    assert_eq!(bench.files(), before);
}

#[test]
fn shells_and_man_are_served() {
    let bench = bench();
    for shell in ["bash", "zsh", "fish"] {
        assert!(bench.done(&format!("completions {shell}")).text().contains("render"));
    }
    assert!(bench.done("man").text().contains(".TH brt 1"));
}

#[test]
fn wrong_views_are_wrong_use() {
    let bench = bench();
    for arguments in ["--view up", "--view 1,91", "--up w", "--zoom 0", "--color mauve", "--sheet --view top"]
    {
        assert_eq!(bench.run(&format!("render part.off {arguments}")).code, Some(2), "{arguments}");
    }
}

#[test]
fn files_that_the_scene_uses_are_not_overwritten() {
    let bench = bench();
    bench.done("render part.off wood.png -s 4x4 --samples 1");
    bench.done("render part.off bumps.png -s 4x4 --samples 1");
    bench.write("wood.mtl", "newmtl wood\nmap_Kd wood.png\nmap_Bump -bm 0.5 bumps.png\n");
    // One triangle; its picture is of no use to us.
    let gltf = r#"{"asset": {"version": "2.0"}, "images": [{"uri": "bumps.png"}],
        "buffers": [{"byteLength": 36, "uri": "data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}]}"#;
    bench.write("bumps.gltf", gltf);
    bench.write(
        "wood.obj",
        "mtllib wood.mtl\nusemtl wood\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n",
    );
    let before = bench.read("wood.png");
    for arguments in [
        "render wood.obj -s 8x8",
        "render wood.obj -s 8x8 -o bumps.png",
        "render bumps.gltf -s 8x8",
        "render wood.obj -s 8x8 --stats wood.mtl -o other.png",
    ] {
        let ended = bench.run(arguments);
        assert_eq!(ended.code, Some(2), "{arguments}");
        assert!(ended.errors.contains("would overwrite a file that the scene uses"), "{}", ended.errors);
    }
    assert_eq!(bench.read("wood.png"), before);
    bench.done("render wood.obj -s 8x8 -o other.png");
}

#[test]
fn converted_models_are_framed_for_the_size_that_is_asked_for() {
    let bench = bench();
    bench.done("render part.off direct.png -s 48x16 --samples 1");
    bench.done("convert part.off part.toml -s 48x16");
    bench.done("render part.toml converted.png --samples 1");
    bench.done("compare direct.png converted.png --max-error 1");
}
