//! The files of one command: all or none, each once, and only where one may write.

use std::fs;

use crate::bench::Bench;

const QUICK: &str = "-s 16x16 --samples 1";

#[test]
fn a_picture_is_not_lost_to_its_statistics_or_layers_under_another_name() {
    let bench = Bench::new();
    fs::create_dir(bench.path("sub")).unwrap();
    for arguments in [
        "-o z.png --stats ./z.png",
        "-o z.png --stats sub/../z.png",
        "-o z.png --layers depth --stats sub/../z.depth.png",
        "-o sub/../z.png --stats z.png",
        "--stats ./ball.png",
        "-o z.png --stats sub/../ball.toml",
    ] {
        let ended = bench.run(&format!("render ball.toml {QUICK} {arguments}"));
        assert_eq!(ended.code, Some(2), "{arguments}: {}", ended.errors);
        assert!(ended.errors.contains("written twice") || ended.errors.contains("overwrite"), "{arguments}");
    }
    assert_eq!(bench.files(), ["ball.toml", "sub"]);
}

/// The statistics cannot be written once everything is rendered, as on a full disk: the picture stays the old one, too.
#[cfg(target_os = "linux")]
#[test]
fn if_one_file_cannot_be_written_the_others_stay_as_they_were() {
    let bench = Bench::new();
    bench.write("a.png", "a picture of before");
    bench.write("a.depth.png", "depths of before");
    let ended = bench.run(&format!("render ball.toml a.png {QUICK} --layers depth --stats /dev/full"));
    assert_eq!(ended.code, Some(1), "{}", ended.errors);
    assert!(ended.errors.contains("/dev/full"), "{}", ended.errors);
    assert_eq!(bench.read("a.png"), b"a picture of before");
    assert_eq!(bench.read("a.depth.png"), b"depths of before");
    assert_eq!(bench.files(), ["a.depth.png", "a.png", "ball.toml"]);
}

#[test]
fn what_killed_runs_left_is_removed_by_the_next_one() {
    let bench = Bench::new();
    let mut child = bench.command("render ball.toml a.png -s 16000x16000 --method full").spawn().unwrap();
    bench.wait_for_files(2, &mut child);
    child.kill().unwrap();
    child.wait().unwrap();
    assert_eq!(bench.files().len(), 2, "{:?}", bench.files());
    bench.done(&format!("render ball.toml b.png {QUICK}"));
    assert_eq!(bench.files(), ["b.png", "ball.toml"]);
}

#[test]
fn what_a_running_command_writes_stays() {
    let bench = Bench::new();
    let mut child = bench.command("render ball.toml a.png -s 16000x16000 --method full").spawn().unwrap();
    bench.wait_for_files(2, &mut child);
    bench.done(&format!("render ball.toml b.png {QUICK}"));
    let files = bench.files();
    child.kill().unwrap();
    child.wait().unwrap();
    assert_eq!(files.len(), 3, "{files:?}");
}

#[test]
fn long_names_are_written_and_messages_name_the_target_alone() {
    let bench = Bench::new();
    let name = format!("{}.png", "l".repeat(251));
    bench.done(&format!("render ball.toml {name} {QUICK}"));
    assert!(bench.path(&name).exists());
    let ended = bench.run(&format!("render ball.toml l{name} {QUICK}"));
    assert_eq!(ended.code, Some(1));
    assert!(!ended.errors.contains(".part"), "{}", ended.errors);
}

#[cfg(unix)]
#[test]
fn protected_files_stay_and_links_are_followed() {
    use std::os::unix::fs::{PermissionsExt, symlink};

    let bench = Bench::new();
    bench.write("a.png", "a picture of before");
    fs::set_permissions(bench.path("a.png"), fs::Permissions::from_mode(0o444)).unwrap();
    let ended = bench.run(&format!("render ball.toml a.png {QUICK}"));
    assert_eq!(ended.code, Some(1));
    assert_eq!(ended.errors, "error: cannot write a.png: it is write-protected\n");
    symlink("real.png", bench.path("link.png")).unwrap();
    bench.done(&format!("render ball.toml link.png {QUICK}"));
    assert!(fs::symlink_metadata(bench.path("link.png")).unwrap().is_symlink());
    assert!(fs::symlink_metadata(bench.path("real.png")).unwrap().is_file());
}

/// Each part of the sheet is what `--view` renders: no pixel depends on what stands beside it.
#[test]
fn a_sheet_holds_the_four_views() {
    let bench = Bench::new();
    bench.write("part.off", "OFF\n4 4 0\n0 0 0\n2 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n");
    let picture = |name: &str, arguments: &str| {
        bench.done(&format!("render part.off {name} {arguments}"));
        brt::image::read_picture(&bench.path(name), brt::image::PictureLimits::default()).unwrap()
    };
    for threads in [1, 3] {
        let sheet = picture("sheet.png", &format!("--sheet -s 301x280 -j {threads}"));
        for (view, [x, y], size) in [
            ("iso", [0, 0], [151, 140]),
            ("front", [151, 0], [150, 140]),
            ("right", [0, 140], [151, 140]),
            ("top", [151, 140], [150, 140]),
        ] {
            let [width, height] = size;
            let alone = picture("view.png", &format!("--view {view} -s {width}x{height}"));
            for (row, column) in (0..height).flat_map(|row| (0..width).map(move |column| (row, column))) {
                let both = (sheet.levels((y + row) * 301 + x + column), alone.levels(row * width + column));
                assert_eq!(both.0, both.1, "{view} {column},{row}");
            }
        }
    }
}
