//! All files of a set appear, or none.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

use super::sink::Sink;
use super::{FileSet, Target};

/// A folder with the old files `a` and `c`; `b` is not there.
struct Bench(tempfile::TempDir);

impl Bench {
    fn new() -> Self {
        let bench = Self(tempfile::tempdir().unwrap());
        fs::write(bench.path("a"), "old a").unwrap();
        fs::write(bench.path("c"), "old c").unwrap();
        bench
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn target(&self, name: &str) -> Target {
        Target::File(self.path(name))
    }

    /// Names and contents of all files, sorted.
    fn state(&self) -> Vec<(String, String)> {
        let content = |path: &Path| fs::read_to_string(path).unwrap_or_else(|_| "(folder)".to_owned());
        let entry = |e: fs::DirEntry| (e.file_name().into_string().unwrap(), content(&e.path()));
        let mut all: Vec<_> = fs::read_dir(self.0.path()).unwrap().map(|e| entry(e.unwrap())).collect();
        all.sort();
        all
    }

    /// Three new files, complete but for the set's commit.
    fn complete(&self) -> FileSet {
        let set = FileSet::new();
        let sinks: Vec<_> = ["a", "b", "c"].map(|name| begin(&set, &self.target(name))).into();
        sinks.into_iter().for_each(|sink| sink.commit().unwrap());
        set
    }
}

fn begin(set: &FileSet, target: &Target) -> Box<dyn Sink> {
    let mut sink = set.open(target).unwrap();
    sink.write_all(b"new").unwrap();
    sink
}

fn as_before() -> Vec<(String, String)> {
    [("a", "old a"), ("c", "old c")].map(|(name, text)| (name.to_owned(), text.to_owned())).into()
}

fn message<R>(result: io::Result<R>) -> String {
    match result {
        Ok(_) => panic!("it went well"),
        Err(error) => error.to_string(),
    }
}

#[test]
fn nothing_is_in_place_before_all_are_complete() {
    let bench = Bench::new();
    let set = FileSet::new();
    let (a, b) = (begin(&set, &bench.target("a")), begin(&set, &bench.target("b")));
    a.commit().unwrap();
    assert_eq!(fs::read_to_string(bench.path("a")).unwrap(), "old a");
    assert!(message(set.commit()).contains("b: it is not complete"));
    b.commit().unwrap();
    set.commit().unwrap();
    let new = |name: &str| (name.to_owned(), "new".to_owned());
    assert_eq!(bench.state(), [new("a"), new("b"), ("c".to_owned(), "old c".to_owned())]);
}

#[test]
fn a_set_does_not_forget_a_file_that_was_given_up() {
    let bench = Bench::new();
    let set = FileSet::new();
    let (a, b) = (begin(&set, &bench.target("a")), begin(&set, &bench.target("b")));
    a.commit().unwrap();
    drop(b);
    assert!(message(set.commit()).contains("b: it is not complete"));
    assert_eq!(fs::read_to_string(bench.path("a")).unwrap(), "old a");
    // Begun anew, it is like any other.
    begin(&set, &bench.target("b")).commit().unwrap();
    set.commit().unwrap();
    assert_eq!(fs::read_to_string(bench.path("b")).unwrap(), "new");
}

#[test]
fn a_set_that_is_dropped_or_aborted_leaves_no_trace() {
    let bench = Bench::new();
    drop(bench.complete());
    assert_eq!(bench.state(), as_before());

    let set = bench.complete();
    let half = begin(&set, &bench.target("d"));
    assert!(set.abort_handle().abort(Duration::ZERO));
    assert_eq!(bench.state(), as_before());
    drop(half);
    assert!(message(set.commit()).contains("given up"));
    assert!(message(set.open(&bench.target("a"))).contains("given up"));
    assert_eq!(bench.state(), as_before());
}

#[test]
fn an_abort_after_the_commit_says_that_files_are_in_place() {
    let bench = Bench::new();
    let set = bench.complete();
    set.commit().unwrap();
    assert!(!set.abort_handle().abort(Duration::ZERO));
    assert_eq!(bench.state().len(), 3);
}

/// The last of three cannot be put in place: those before it are taken back, the new one and the replaced one.
#[test]
fn if_one_file_cannot_be_put_in_place_the_others_are_taken_back() {
    let bench = Bench::new();
    let set = bench.complete();
    let part = |e: &(String, String)| e.0.starts_with(".c.") && e.0.ends_with(".part");
    let part = bench.state().into_iter().find(part).unwrap().0;
    fs::remove_file(bench.path(&part)).unwrap();
    let message = message(set.commit());
    assert!(message.contains(&format!("cannot write {}", bench.path("c").display())), "{message}");
    assert!(!message.contains("new already") && !message.contains(".part"), "{message}");
    assert_eq!(bench.state(), as_before());
}

#[test]
fn a_folder_that_came_up_at_the_target_is_seen_before_anything_is_replaced() {
    let bench = Bench::new();
    let set = bench.complete();
    fs::create_dir(bench.path("b")).unwrap();
    assert!(message(set.commit()).contains("directory"));
    drop(set);
    fs::remove_dir(bench.path("b")).unwrap();
    assert_eq!(bench.state(), as_before());
}

#[test]
fn a_file_is_not_written_twice_whatever_it_is_called() {
    let bench = Bench::new();
    fs::create_dir(bench.path("sub")).unwrap();
    let set = FileSet::new();
    let _a = begin(&set, &bench.target("a"));
    assert!(message(set.open(&bench.target("sub/../a"))).contains("written twice"));
}

#[test]
fn the_next_set_in_a_folder_sweeps_what_killed_ones_left_but_not_what_others_write() {
    let bench = Bench::new();
    fs::write(bench.path(".a.png.brt-Ab3dEf7h.part"), "left").unwrap();
    let other = FileSet::new();
    let _running = begin(&other, &bench.target("a"));
    assert_eq!(bench.state().len(), 3, "{:?}", bench.state());
    drop(begin(&FileSet::new(), &bench.target("b")));
    assert_eq!(bench.state().len(), 3);
    drop(other);
    assert_eq!(bench.state(), as_before());
}

#[test]
fn names_of_255_bytes_can_be_written_and_longer_ones_are_refused_at_once() {
    let bench = Bench::new();
    let long = "l".repeat(255);
    Target::File(bench.path(&long)).open().unwrap().commit().unwrap();
    assert!(bench.path(&long).exists());
    assert!(Target::File(bench.path(&format!("{long}l"))).open().is_err());
}

#[cfg(unix)]
mod unix {
    use std::os::unix::fs::{PermissionsExt, symlink};

    use super::*;

    fn set_mode(path: &Path, mode: u32) {
        fs::set_permissions(path, fs::Permissions::from_mode(mode)).unwrap();
    }

    #[test]
    fn write_protected_files_are_refused() {
        let bench = Bench::new();
        set_mode(&bench.path("a"), 0o444);
        let message = message(bench.target("a").open());
        assert!(message.ends_with("a: it is write-protected"), "{message}");
        assert_eq!(bench.state(), as_before());
    }

    #[test]
    fn nobody_else_runs_a_new_file_as_the_owner_of_the_old_one() {
        let bench = Bench::new();
        set_mode(&bench.path("a"), 0o6755);
        bench.target("a").open().unwrap().commit().unwrap();
        assert_eq!(fs::metadata(bench.path("a")).unwrap().permissions().mode() & 0o7777, 0o755);
    }

    #[test]
    fn a_link_to_nothing_is_followed() {
        let bench = Bench::new();
        fs::create_dir(bench.path("sub")).unwrap();
        symlink("sub/real", bench.path("link")).unwrap();
        begin(&FileSet::new(), &bench.target("link"));
        bench.target("link").open().unwrap().commit().unwrap();
        assert!(fs::symlink_metadata(bench.path("link")).unwrap().is_symlink());
        assert!(fs::symlink_metadata(bench.path("sub/real")).unwrap().is_file());
    }
}
