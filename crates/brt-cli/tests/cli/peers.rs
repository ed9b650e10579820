//! `brt peers` with the peers that are installed, with none, and with ones that hang or fail; `brt convert` for them.

use std::fs;
use std::time::{Duration, Instant};

use crate::bench::{Bench, Ended};

const COLUMNS: &str = "scene,width,height,entrant,class,runs,start_up_ms,ns_per_pixel,ns_per_pixel_min,\
                       ns_per_pixel_max,ratio_to_full,ratio_to_certified,mean_error,percent_over_2,\
                       rms_error,mean_error_srgb,rms_error_srgb";

/// Runs with this folder as the only one where programs are looked for.
fn run_with_path(bench: &Bench, path: &str, arguments: &str) -> Ended {
    bench.command(arguments).env("PATH", bench.path(path)).output().unwrap().into()
}

/// The fields of the file of times, without its first line, by whole rows.
fn rows(bench: &Bench, folder: &str) -> Vec<String> {
    let text = String::from_utf8(bench.read(&format!("{folder}/peers.csv"))).unwrap();
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some(COLUMNS));
    lines.map(str::to_owned).collect()
}

/// The mean error of an entrant of a row.
fn mean_error(rows: &[String], entrant: &str) -> Option<f64> {
    let row = rows.iter().find(|row| row.contains(&format!(",{entrant},one sample")))?;
    row.split(',').nth(12)?.parse().ok()
}

#[test]
fn seed_a_is_measured_with_whatever_is_installed() {
    let bench = Bench::new();
    let ended = bench.done("peers seed-a -o out --sizes 32 --repeat 1");
    assert!(ended.text().contains("brt full") && ended.text().contains("peers.html"), "{}", ended.text());
    let rows = rows(&bench, "out");
    assert!(rows.iter().all(|row| row.starts_with("seed-a,32,32,")), "{rows:?}");
    assert!(mean_error(&rows, "brt border").is_some());
    for peer in ["POV-Ray", "Tachyon"] {
        let is_missing = ended.errors.contains(&format!("{peer} is not installed"));
        match mean_error(&rows, peer) {
            Some(error) => assert!(error <= 1.0, "{peer}: {error}"),
            None => assert!(is_missing, "{peer}: {}", ended.errors),
        }
    }
    let page = String::from_utf8(bench.read("out/peers.html")).unwrap();
    assert!(page.contains("data:image/png;base64,") && page.contains("seed-a"));
    for file in ["out/seed-a.toml", "out/seed-a-32x32.pov", "out/seed-a-32x32.dat"] {
        assert!(bench.path(file).exists(), "{file}");
    }
    assert!(!bench.path("out/seed-a-32x32-picture.ppm").exists());
}

#[test]
fn without_peers_ours_are_measured_and_it_is_said_how_to_get_them() {
    let bench = Bench::new();
    fs::create_dir(bench.path("nothing")).unwrap();
    let ended = run_with_path(&bench, "nothing", "peers ball.toml -o out --sizes 32 --repeat 1");
    assert_eq!(ended.code, Some(0), "{}", ended.errors);
    for part in ["only brt is measured", "apt-get install povray", "apt-get install tachyon"] {
        assert!(ended.errors.contains(part), "{part}: {}", ended.errors);
    }
    let rows = rows(&bench, "out");
    assert_eq!(rows.len(), 6, "ours in two classes: {rows:?}");
    assert!(rows.iter().all(|row| row.starts_with("ball,32,32,")));
}

#[cfg(unix)]
fn fake(bench: &Bench, name: &str, script: &str) {
    use std::os::unix::fs::PermissionsExt;
    fs::create_dir_all(bench.path("fake")).unwrap();
    let file = format!("fake/{name}");
    bench.write(&file, &format!("#!/bin/sh\n{script}\n"));
    fs::set_permissions(bench.path(&file), fs::Permissions::from_mode(0o755)).unwrap();
}

#[cfg(unix)]
#[test]
fn peers_that_hang_or_fail_are_left_out() {
    let bench = Bench::new();
    // `sleep` by its full name: nothing else is found with this PATH.
    fake(&bench, "povray", "case $1 in --version) echo POV-Ray 9.9.fake;; *) /bin/sleep 600;; esac");
    fake(&bench, "tachyon", "case $1 in -version) echo 9.8;; *) echo cannot read this; exit 1;; esac");
    let begin = Instant::now();
    let ended = run_with_path(&bench, "fake", "peers ball.toml -o out --sizes 32 --repeat 1 --timeout 4");
    assert!(begin.elapsed() < Duration::from_secs(60));
    assert_eq!(ended.code, Some(0), "{}", ended.errors);
    assert!(ended.text().contains("POV-Ray 9.9.fake") && ended.text().contains("Tachyon 9.8"));
    assert!(ended.errors.contains("POV-Ray did not end within 4s"), "{}", ended.errors);
    assert!(ended.errors.contains("Tachyon failed") && ended.errors.contains("cannot read this"));
    assert!(rows(&bench, "out").iter().all(|row| row.contains(",brt ") || row.contains("\"brt ")));
}

#[cfg(unix)]
#[test]
fn a_peer_that_does_not_even_tell_its_version_is_left_out() {
    let bench = Bench::new();
    fake(&bench, "povray", "/bin/sleep 600");
    let ended = run_with_path(&bench, "fake", "peers ball.toml -o out --sizes 32 --repeat 1 --timeout 1");
    assert_eq!(ended.code, Some(0), "{}", ended.errors);
    assert!(ended.errors.contains("POV-Ray is left out"), "{}", ended.errors);
}

#[test]
fn runs_are_recorded_and_drawn() {
    let bench = Bench::new();
    fs::create_dir(bench.path("nothing")).unwrap();
    let record = |label: &str| {
        let arguments = "peers ball.toml -o out --sizes 32 --repeat 1 --plain --record history.csv --label";
        run_with_path(&bench, "nothing", &format!("{arguments} {label}"))
    };
    assert_eq!(record("one").code, Some(0));
    let first = bench.read("history.csv");
    let ended = record("two");
    assert_eq!(ended.code, Some(0), "{}", ended.errors);
    let text = String::from_utf8(bench.read("history.csv")).unwrap();
    assert!(text.as_bytes().starts_with(&first));
    assert_eq!(text.lines().count(), 1 + 2 * 3, "{text}");
    assert!(text.lines().nth(4).unwrap().contains(",two,"), "{text}");
    assert!(String::from_utf8(bench.read("out/peers.html")).unwrap().contains("<h2>History</h2>"));

    bench.write("history.csv", "my notes\n");
    let ended = record("three");
    assert_eq!(ended.code, Some(1));
    assert!(ended.errors.contains("history.csv, line 1: not a history"), "{}", ended.errors);
    assert_eq!(bench.read("history.csv"), b"my notes\n");
}

#[test]
fn wrong_use_is_refused() {
    let bench = Bench::new();
    assert_eq!(bench.run("peers no-such-scene").code, Some(1));
    assert_eq!(bench.run("peers ball.toml ./ball.toml").code, Some(2));
    assert_eq!(bench.run("peers --sizes 0").code, Some(2));
    assert_eq!(bench.run("peers --repeat 0").code, Some(2));
    assert_eq!(bench.run("peers --label 0.1").code, Some(2));
}

#[test]
fn scenes_are_converted_for_other_ray_tracers() {
    let bench = Bench::new();
    bench.done("convert ball.toml ball.pov -s 64x48");
    bench.done("convert ball.toml ball.dat --size 64x48");
    assert!(String::from_utf8(bench.read("ball.pov")).unwrap().contains("+W64 +H48"));
    assert!(String::from_utf8(bench.read("ball.dat")).unwrap().contains("RESOLUTION 64 48"));
    bench.done("scene mount --size 2 -o mount.toml");
    let ended = bench.done("convert mount.toml mount.dat");
    assert!(
        ended.errors.contains("warning: ") && ended.errors.contains("refracts nothing"),
        "{}",
        ended.errors
    );
    assert_eq!(bench.run("convert ball.toml ball.stl").code, Some(2));
    let refused = bench.run("render ball.pov");
    assert_eq!(refused.code, Some(1));
    assert!(refused.errors.contains("can be written, but not read"), "{}", refused.errors);
}
