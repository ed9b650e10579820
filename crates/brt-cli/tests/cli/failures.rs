//! What cannot be done ends with exit code 1, and leaves files as they were.

use std::fs;

use crate::bench::{Bench, SCENE};

#[test]
fn files_that_are_not_there_or_not_scenes() {
    let bench = Bench::new();
    bench.write("part.stl", "solid cube");
    for (arguments, part) in [
        ("render missing.toml", "missing.toml"),
        ("render part.stl", "part.stl"),
        ("render ball.toml -s 8x8 -o no/such/folder.png", "folder.png"),
        ("render ball.toml -s 8x8 --stats no/such/folder.json", "folder.json"),
        ("inspect missing.toml", "missing.toml"),
        ("convert missing.nff a.toml", "missing.nff"),
        ("compare missing.png ball.toml", "missing.png"),
        ("compare ball.toml ball.toml", "ball.toml"),
    ] {
        let ended = bench.run(arguments);
        assert_eq!(ended.code, Some(1), "{arguments}: {}", ended.errors);
        assert!(ended.errors.starts_with("error: ") && ended.errors.contains(part), "{}", ended.errors);
    }
    assert_eq!(bench.files(), ["ball.toml", "part.stl"]);
}

#[test]
fn a_scene_of_ours_is_found_by_its_name() {
    let errors = Bench::new().run("render seed-a").errors;
    assert!(
        errors.ends_with("hint: `brt scene seed-a -o seed-a.toml` writes our scene of that name\n"),
        "{errors}"
    );
}

#[test]
fn errors_in_scenes_are_drawn_and_nothing_is_written() {
    let bench = Bench::new();
    bench.write("bad.toml", &SCENE.replace("radius = 1", "radius = -1"));
    bench.write("bad.png", "a picture of before");
    let ended = bench.run("render bad.toml -s 8x8");
    assert_eq!(ended.code, Some(1));
    for part in
        ["error: `radius` is -1", "bad.toml:19:", "radius = -1", "^", "expected a finite number above 0"]
    {
        assert!(ended.errors.contains(part), "{part}: {}", ended.errors);
    }
    assert_eq!(bench.read("bad.png"), b"a picture of before");
    assert_eq!(bench.files(), ["bad.png", "bad.toml", "ball.toml"]);
    let piped = bench.run_with_input("render - -o a.png", "size = 3\n");
    assert_eq!(piped.code, Some(1));
    assert!(piped.errors.contains("standard input:1:"), "{}", piped.errors);
}

#[test]
fn standard_input_says_what_it_was_taken_for() {
    let bench = Bench::new();
    let empty = bench.run_with_input("inspect -", "");
    assert_eq!((empty.code, empty.errors.as_str()), (Some(1), "error: standard input is empty\n"));
    let odd = bench.run_with_input("inspect -", "hello\n");
    assert_eq!(odd.code, Some(1));
    let hint =
        "hint: read as TOML, since it looks like nothing else; `--input-format` names another format\n";
    assert!(odd.errors.ends_with(hint), "{}", odd.errors);
    for (arguments, input) in [("inspect -", "size = 3\n"), ("inspect - --input-format toml", "hello\n")] {
        assert!(!bench.run_with_input(arguments, input).errors.contains("hint"), "{arguments}");
    }
}

#[test]
fn a_size_that_is_not_used_is_not_checked() {
    let bench = Bench::new();
    bench.write("huge.toml", &format!("size = [400000, 400000]\n{SCENE}"));
    bench.done("render huge.toml -s 8x8 --samples 1 --no-save");
    bench.done("inspect huge.toml");
    let ended = bench.run("render huge.toml --no-save");
    assert_eq!(ended.code, Some(1));
    assert!(
        ended.errors.contains("400000×400000") && ended.errors.contains("--max-pixels"),
        "{}",
        ended.errors
    );
}

#[test]
fn limits_are_refused_before_anything_is_rendered() {
    let bench = Bench::new();
    for (arguments, part) in [
        ("render ball.toml -s 100x100 --max-pixels 9999", "--max-pixels"),
        ("render ball.toml -s 4000000000x4000000000", "--max-pixels"),
        ("render ball.toml -s 20000000x1", "side"),
        ("render ball.toml --max-memory 10kB", "`--max-memory SIZE` allows more"),
        ("render ball.toml --max-memory 80", "`--max-memory SIZE` allows more"),
    ] {
        let ended = bench.run(arguments);
        assert_eq!(ended.code, Some(1), "{arguments}: {}", ended.errors);
        assert!(ended.errors.contains(part), "{}", ended.errors);
    }
    assert_eq!(bench.files(), ["ball.toml"]);
}

#[test]
fn a_layer_that_cannot_be_written_keeps_the_old_picture() {
    let bench = Bench::new();
    bench.write("a.png", "a picture of before");
    fs::create_dir(bench.path("a.depth.png")).unwrap();
    let ended = bench.run("render ball.toml a.png -s 8x8 --layers depth");
    assert_eq!(ended.code, Some(1));
    assert_eq!(bench.read("a.png"), b"a picture of before");
    assert_eq!(bench.files(), ["a.depth.png", "a.png", "ball.toml"]);
}
