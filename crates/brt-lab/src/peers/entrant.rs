//! Who runs against whom, and by which command.

use std::path::Path;
use std::process::Command;

use super::program::Peer;

/// What a program's runs are compared with: those that do about the same work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Class {
    /// One sample per pixel.
    Plain,
    /// Each program's usual anti-aliasing.
    AntiAliased,
}

impl Class {
    pub(super) const ALL: [Self; 2] = [Self::Plain, Self::AntiAliased];

    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Plain => "one sample per pixel",
            Self::AntiAliased => "anti-aliased",
        }
    }

    /// Ours, per pixel.
    pub(super) fn samples(self) -> u32 {
        match self {
            Self::Plain => 1,
            Self::AntiAliased => 16,
        }
    }
}

/// Ours or another's.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Program {
    /// With this method.
    Ours(&'static str),
    Other(Peer),
}

/// A program with options.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Entrant {
    pub(super) name: &'static str,
    pub(super) class: Class,
    pub(super) program: Program,
}

const fn entrant(name: &'static str, class: Class, program: Program) -> Entrant {
    Entrant { name, class, program }
}

/// Everybody; in each class ours come first, and `full` before all.
pub(super) const ENTRANTS: [Entrant; 10] = [
    entrant("brt full", Class::Plain, Program::Ours("full")),
    entrant("brt border", Class::Plain, Program::Ours("border")),
    entrant("brt certified", Class::Plain, Program::Ours("certified")),
    entrant("POV-Ray", Class::Plain, Program::Other(Peer::PovRay)),
    entrant("Tachyon", Class::Plain, Program::Other(Peer::Tachyon)),
    entrant("brt full, 16 samples", Class::AntiAliased, Program::Ours("full")),
    entrant("brt border, 16 samples", Class::AntiAliased, Program::Ours("border")),
    entrant("brt certified, 16 samples", Class::AntiAliased, Program::Ours("certified")),
    entrant("POV-Ray +A0.1 +AM2", Class::AntiAliased, Program::Other(Peer::PovRay)),
    entrant("Tachyon -aasamples 12", Class::AntiAliased, Program::Other(Peer::Tachyon)),
];

/// A scene at a size, written for everybody.
pub(super) struct Task<'a> {
    /// Our own program.
    pub(super) ours: &'a Path,
    /// Where the files are; programs run in it, since some may only read and write below where they run.
    pub(super) folder: &'a Path,
    /// The scene's file for us.
    pub(super) toml: &'a str,
    /// Files for the others, without extension.
    pub(super) stem: &'a str,
    pub(super) size: [u32; 2],
    /// Are highlights Phong's?
    pub(super) has_phong: bool,
}

impl Entrant {
    /// The command that renders with one thread, to a file of 16-bit linear values or to nowhere.
    pub(super) fn command(&self, task: &Task, picture: Option<&str>) -> Command {
        let mut command = match self.program {
            Program::Ours(method) => {
                let mut command = ours(method, self.class.samples(), task, picture);
                command.args(["-j", "1"]);
                command
            }
            Program::Other(Peer::PovRay) => povray(self.class, task, picture),
            Program::Other(Peer::Tachyon) => tachyon(self.class, task, picture),
        };
        command.current_dir(task.folder);
        command
    }
}

/// The command for the picture that anti-aliased ones are measured against: every sample traced, so many that more would
/// change little. Nobody's time is taken, so all processors work.
pub(super) fn reference_command(task: &Task, picture: &str) -> Command {
    let mut command = ours("full", 256, task, Some(picture));
    command.current_dir(task.folder);
    command
}

fn ours(method: &str, samples: u32, task: &Task, picture: Option<&str>) -> Command {
    let [width, height] = task.size;
    let mut command = Command::new(task.ours);
    command.args(["render", task.toml, "-q", "--method", method, "--samples", &samples.to_string()]);
    command.args(["-s", &format!("{width}x{height}")]);
    // The tolerance of `certified` is in units of what is stored.
    command.arg("--linear");
    match picture {
        Some(file) => command.args(["--bits", "16", "-o", file]),
        None => command.arg("--no-save"),
    };
    command
}

fn povray(class: Class, task: &Task, picture: Option<&str>) -> Command {
    let [width, height] = task.size;
    let mut command = Command::new(Peer::PovRay.command());
    command.args(["-D", "-P", "-UA", "+WT1", &format!("+W{width}"), &format!("+H{height}")]);
    command.arg(format!("+I{}.pov", task.stem));
    match class {
        Class::Plain => command.arg("-A"),
        Class::AntiAliased => command.args(["+A0.1", "+AM2"]),
    };
    match picture {
        Some(file) => command.args([format!("+O{file}"), "+FP16".to_owned(), "File_Gamma=1.0".to_owned()]),
        None => command.arg("-F"),
    };
    command
}

fn tachyon(class: Class, task: &Task, picture: Option<&str>) -> Command {
    let [width, height] = task.size.map(|side| side.to_string());
    let mut command = Command::new(Peer::Tachyon.command());
    command.arg(format!("{}.dat", task.stem)).args(["-numthreads", "1", "-res", &width, &height]);
    if task.has_phong {
        command.arg("-shade_phong");
    }
    if class == Class::AntiAliased {
        command.args(["-aasamples", "12"]);
    }
    match picture {
        Some(file) => command.args(["-format", "PPM48", "-o", file]),
        None => command.arg("-nosave"),
    };
    command
}
