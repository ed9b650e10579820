//! What cannot be printed is an error; a reader that went away is none.

#![cfg(target_os = "linux")]

use std::fs::File;
use std::process::{Command, Stdio};

use crate::bench::{Bench, Ended};

const PRINTING: [&str; 10] = [
    "inspect ball.toml",
    "inspect ball.toml --json",
    "compare a.png a.png",
    "formats",
    "man",
    "completions bash",
    "--help",
    "scene",
    "render ball.toml -s 16x16 --samples 1 --no-save --verify",
    "render ball.toml -s 16x16 --samples 1 --pixel 3,4",
];

fn bench() -> Bench {
    let bench = Bench::new();
    bench.done("render ball.toml a.png -s 16x16 --samples 1");
    bench
}

#[test]
fn a_full_disk_is_reported() {
    let bench = bench();
    for arguments in PRINTING.into_iter().chain(["render ball.toml -s 16x16 -o -", "convert ball.toml -"]) {
        let full = File::options().write(true).open("/dev/full").unwrap();
        let ended: Ended = bench.command(arguments).stdout(full).output().unwrap().into();
        assert_eq!(ended.code, Some(1), "brt {arguments}: {}", ended.errors);
        assert!(ended.errors.starts_with("error: cannot write standard output: "), "{}", ended.errors);
    }
}

#[test]
fn a_reader_that_went_away_is_no_error() {
    let bench = bench();
    let scenes_and_pictures = [
        "render ball.toml -s 16x16 -o -",
        "render ball.toml -s 16x16 --sheet -o -",
        "convert ball.toml -",
        "scene balls",
    ];
    for arguments in PRINTING.into_iter().chain(scenes_and_pictures) {
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let ended: Ended = bench.command(arguments).stdout(writer).output().unwrap().into();
        assert_eq!((ended.code, ended.errors.as_str()), (Some(0), ""), "brt {arguments}");
    }
}

/// The command with a redirection.
fn run_in_shell(bench: &Bench, arguments: &str, redirection: &str) -> Ended {
    let script = format!("exec \"$0\" {arguments} {redirection}");
    let mut shell = Command::new("sh");
    shell.args(["-c", &script, env!("CARGO_BIN_EXE_brt")]).current_dir(bench.path(""));
    shell.stdin(Stdio::null()).output().unwrap().into()
}

#[test]
fn a_picture_for_a_closed_standard_output_is_refused_before_it_is_rendered() {
    let bench = Bench::new();
    let run = |redirection: &str| run_in_shell(&bench, "render ball.toml -s 16x16 -o -", redirection);
    let closed = run(">&-");
    assert_eq!(closed.code, Some(1));
    assert!(
        closed.errors.starts_with("error: cannot write standard output: it is closed\n"),
        "{}",
        closed.errors
    );
    assert_eq!(run(">/dev/null").code, Some(0));
}
