//! `brt inspect`, `convert`, `scene` and `formats`.

use std::fs;
use std::path::Path;

use crate::bench::Bench;

#[test]
fn inspect_counts_what_is_there() {
    let bench = Bench::new();
    let text = bench.done("inspect ball.toml");
    for part in ["1 plane, 1 sphere", "primitives  2", "without bounds", "point at (-5, 9, 6)", "clay", "40°"]
    {
        assert!(text.text().contains(part), "{part}: {}", text.text());
    }
    let json = bench.done("inspect ball.toml --json").json();
    assert_eq!(json["objects"], serde_json::json!({ "plane": 1, "sphere": 1 }));
    assert_eq!(json["bounds"], serde_json::json!([[-1.0, 0.0, -1.0], [1.0, 2.0, 1.0]]));
    assert_eq!(json["camera"]["projection"], "perspective");
    assert_eq!(json["warnings"], serde_json::json!([]));
}

#[test]
fn what_was_not_understood_is_shown_and_the_rest_is_used() {
    let bench = Bench::new();
    bench.write(
        "old.nff",
        "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 16 16\nq 1 2\ns 0 0 0 1\n",
    );
    let ended = bench.done("inspect old.nff");
    assert!(ended.errors.contains("warning: ") && ended.errors.contains("old.nff:8"), "{}", ended.errors);
    assert!(ended.text().contains("1 sphere"));
    assert!(!bench.done("render old.nff -q --samples 1").errors.contains("warning"));
}

#[test]
fn conversion_keeps_the_picture() {
    let bench = Bench::new();
    bench.done("convert ball.toml again.toml");
    for scene in ["ball", "again"] {
        bench.done(&format!("render {scene}.toml -s 64x48 --samples 1"));
    }
    assert!(bench.read("ball.png") == bench.read("again.png"));
    let piped = bench.run_with_input("convert - -", crate::bench::SCENE);
    assert_eq!(piped.stdout, bench.read("again.toml"));
}

#[test]
fn scenes_are_listed_and_written() {
    let bench = Bench::new();
    let list = bench.done("scene");
    for name in ["seed-a", "seed-b", "seed-c", "balls", "watch"] {
        assert!(list.text().lines().any(|line| line.starts_with(name)), "{name}");
    }
    bench.done("scene balls --size 1 -o balls.toml");
    assert!(bench.done("inspect balls.toml").text().contains("10 sphere"));
    let piped = bench.done("scene seed-a");
    assert!(piped.text().contains("[camera]"));
}

#[test]
fn formats_are_listed() {
    let list = Bench::new().done("formats");
    for extension in [".toml", ".nff", ".pov", ".dat", ".png", ".ppm", ".exr"] {
        assert!(list.text().contains(extension), "{extension}");
    }
}

/// What is kept as a file is what its program makes.
#[test]
fn the_gallery_is_what_its_programs_make() {
    let gallery = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/gallery");
    let mut scenes = 0;
    for file in fs::read_dir(gallery).unwrap() {
        let path = file.unwrap().path();
        if path.extension().is_some_and(|extension| extension == "toml") {
            let name = path.file_stem().unwrap().to_str().unwrap();
            let made = Bench::new().done(&format!("scene {name}"));
            assert!(
                made.text() == fs::read_to_string(&path).unwrap(),
                "brt scene {name} -o {}",
                path.display()
            );
            scenes += 1;
        }
    }
    assert!(scenes > 0);
}
