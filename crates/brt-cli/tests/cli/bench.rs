//! A folder to work in, and what a run of the command left.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

use tempfile::TempDir;

/// A folder with a small scene in it.
pub(crate) struct Bench(TempDir);

/// How a run ended.
pub(crate) struct Ended {
    pub(crate) code: Option<i32>,
    pub(crate) stdout: Vec<u8>,
    pub(crate) errors: String,
}

/// A ball over a floor, quick to render.
pub(crate) const SCENE: &str = r#"
background = [0.1, 0.2, 0.4]
[camera]
eye = [0, 2, 8]
look_at = [0, 1, 0]
fov_deg = 40
[[light]]
type = "point"
position = [-5, 9, 6]
color = [1, 1, 1]
[materials.clay]
color = [0.9, 0.35, 0.2]
specular = 0.5
[[object]]
type = "sphere"
name = "ball"
material = "clay"
center = [0, 1, 0]
radius = 1
[[object]]
type = "plane"
material = "clay"
normal = [0, 1, 0]
distance = 0
"#;

impl Bench {
    /// A folder with `ball.toml`.
    pub(crate) fn new() -> Self {
        let bench = Self(tempfile::tempdir().unwrap());
        bench.write("ball.toml", SCENE);
        bench
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub(crate) fn write(&self, name: &str, content: &str) {
        fs::write(self.path(name), content).unwrap();
    }

    pub(crate) fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).unwrap()
    }

    /// Names of all files, sorted.
    pub(crate) fn files(&self) -> Vec<String> {
        let name = |entry: fs::DirEntry| entry.file_name().into_string().unwrap();
        let mut names: Vec<_> = fs::read_dir(self.0.path()).unwrap().map(|e| name(e.unwrap())).collect();
        names.sort();
        names
    }

    /// Waits until a command has begun so many files that there are this many in the folder.
    pub(crate) fn wait_for_files(&self, count: usize, child: &mut Child) {
        let begin = Instant::now();
        while self.files().len() < count {
            assert!(begin.elapsed() < Duration::from_secs(60), "{:?}", self.files());
            assert!(child.try_wait().unwrap().is_none(), "it ended too early");
            std::thread::sleep(Duration::from_millis(5));
        }
    }

    /// The command with arguments separated by blanks, in the folder.
    pub(crate) fn command(&self, arguments: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_brt"));
        command.args(arguments.split_whitespace()).current_dir(self.0.path()).stdin(Stdio::null());
        command
    }

    pub(crate) fn run(&self, arguments: &str) -> Ended {
        self.command(arguments).output().unwrap().into()
    }

    /// A run that must end well.
    pub(crate) fn done(&self, arguments: &str) -> Ended {
        let ended = self.run(arguments);
        assert_eq!(ended.code, Some(0), "brt {arguments}: {}", ended.errors);
        ended
    }

    pub(crate) fn run_with_input(&self, arguments: &str, input: &str) -> Ended {
        let mut command = self.command(arguments);
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().unwrap();
        child.stdin.take().unwrap().write_all(input.as_bytes()).unwrap();
        child.wait_with_output().unwrap().into()
    }
}

impl Ended {
    pub(crate) fn text(&self) -> &str {
        std::str::from_utf8(&self.stdout).unwrap()
    }

    pub(crate) fn json(&self) -> serde_json::Value {
        serde_json::from_slice(&self.stdout).unwrap()
    }
}

impl From<Output> for Ended {
    fn from(output: Output) -> Self {
        let errors = String::from_utf8(output.stderr).unwrap();
        Self { code: output.status.code(), stdout: output.stdout, errors }
    }
}

/// Width and height of a picture file.
pub(crate) fn size_of(path: &Path) -> [u32; 2] {
    let picture = brt::image::read_picture(path, brt::image::PictureLimits::default()).unwrap();
    [picture.size().width, picture.size().height]
}

/// The keys of an object, sorted.
pub(crate) fn keys(value: &serde_json::Value) -> Vec<&str> {
    let mut keys: Vec<_> = value.as_object().unwrap().keys().map(String::as_str).collect();
    keys.sort_unstable();
    keys
}
