//! Signals end the command within a second, wherever it is, and leave no trace.

#![cfg(target_os = "linux")]

use std::fs;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use crate::bench::Bench;

const LONG: &str = "render ball.toml a.png -s 16000x16000 --method full --layers depth -j 2";

/// The command, listening to all signals: what a shell starts in the background ignores INT, and so do all that it starts.
fn listening(bench: &Bench, arguments: &str) -> Command {
    let mut command = Command::new("env");
    command.args(["--default-signal=INT,TERM,HUP", env!("CARGO_BIN_EXE_brt")]);
    command.args(arguments.split_whitespace()).current_dir(bench.path("")).stdin(Stdio::null());
    command
}

fn send(signal: &str, child: &Child) {
    let pid = child.id().to_string();
    assert!(Command::new("kill").args([&format!("-{signal}"), &pid]).status().unwrap().success());
}

/// The exit code, which must come soon: a second, and something for a machine that does much else.
fn code_soon(child: &mut Child) -> Option<i32> {
    let begin = Instant::now();
    while begin.elapsed() < Duration::from_secs(3) {
        if let Some(status) = child.try_wait().unwrap() {
            return Some(shell_code(status));
        }
        std::thread::sleep(Duration::from_millis(5));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    None
}

/// As a shell shows it.
fn shell_code(status: std::process::ExitStatus) -> i32 {
    use std::os::unix::process::ExitStatusExt;
    status.code().or_else(|| status.signal().map(|signal| 128 + signal)).unwrap()
}

#[test]
fn each_signal_has_its_exit_code_and_leaves_no_trace() {
    for (signal, code) in [("INT", 130), ("TERM", 143), ("HUP", 129)] {
        let bench = Bench::new();
        bench.write("a.png", "a picture of before");
        let mut child = listening(&bench, LONG).stderr(Stdio::piped()).spawn().unwrap();
        // Both temporary files are there once it renders.
        bench.wait_for_files(4, &mut child);
        send(signal, &child);
        assert_eq!(code_soon(&mut child), Some(code), "{signal}");
        assert_eq!(bench.read("a.png"), b"a picture of before");
        assert_eq!(bench.files(), ["a.png", "ball.toml"]);
        let errors = std::io::read_to_string(child.stderr.take().unwrap()).unwrap();
        assert_eq!(errors, "error: interrupted, no file was written\n", "{signal}");
    }
}

/// `timeout` signals the process, and then its group.
#[test]
fn two_signals_are_not_more_than_one() {
    for _ in 0..5 {
        let bench = Bench::new();
        let mut child = listening(&bench, LONG).stderr(Stdio::null()).spawn().unwrap();
        bench.wait_for_files(3, &mut child);
        send("TERM", &child);
        send("TERM", &child);
        assert_eq!(code_soon(&mut child), Some(143));
        assert_eq!(bench.files(), ["ball.toml"]);
    }
}

#[test]
fn a_command_that_waits_for_a_reader_can_be_stopped() {
    let bench = Bench::new();
    assert!(Command::new("mkfifo").arg(bench.path("fifo.png")).status().unwrap().success());
    let mut child = listening(&bench, "render ball.toml fifo.png -s 16x16 --stats s.json")
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    // The statistics are opened before the picture.
    bench.wait_for_files(3, &mut child);
    send("TERM", &child);
    assert_eq!(code_soon(&mut child), Some(143));
    assert_eq!(bench.files(), ["ball.toml", "fifo.png"]);
}

#[test]
fn a_command_that_writes_to_a_full_pipe_can_be_stopped() {
    let bench = Bench::new();
    let mut child =
        listening(&bench, "render ball.toml -s 3000x3000 --samples 1 --bits 16 -o - --stats s.json")
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
    bench.wait_for_files(2, &mut child);
    std::thread::sleep(Duration::from_millis(500));
    send("INT", &child);
    assert_eq!(code_soon(&mut child), Some(130));
    assert_eq!(bench.files(), ["ball.toml"]);
}

#[test]
fn ignored_signals_stay_ignored() {
    for signal in ["HUP", "INT", "TERM"] {
        let bench = Bench::new();
        let script = format!("trap '' {signal}; exec \"$0\" {LONG}");
        let mut child = Command::new("sh")
            .args(["-c", &script, env!("CARGO_BIN_EXE_brt")])
            .current_dir(bench.path(""))
            .stdin(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        bench.wait_for_files(3, &mut child);
        send(signal, &child);
        std::thread::sleep(Duration::from_millis(1200));
        let is_running = child.try_wait().unwrap().is_none();
        send("KILL", &child);
        child.wait().unwrap();
        assert!(is_running, "{signal}");
    }
}

#[test]
fn the_limit_for_sizes_of_files_is_an_error_like_a_full_disk() {
    let bench = Bench::new();
    bench.write("a.ppm", "a picture of before");
    let script = "ulimit -f 8; exec \"$0\" render ball.toml a.ppm -s 500x500 --samples 1";
    let output = Command::new("sh")
        .args(["-c", script, env!("CARGO_BIN_EXE_brt")])
        .current_dir(bench.path(""))
        .stdin(Stdio::null())
        .output()
        .unwrap();
    let errors = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{errors}");
    assert!(
        errors.starts_with("error: cannot write a.ppm: the limit for sizes of files is reached"),
        "{errors}"
    );
    assert_eq!(fs::read_to_string(bench.path("a.ppm")).unwrap(), "a picture of before");
    assert_eq!(bench.files(), ["a.ppm", "ball.toml"]);
}
