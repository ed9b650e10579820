//! The same scenes through other ray tracers, side by side with ours.
//!
//! Each scene is written for each peer so that the pictures agree, and rendered by everybody with one thread, in turns.
//! What counts is processor time less start-up; how far the pictures agree is measured beside it, since times of
//! programs that draw different things mean nothing.

mod agreement;
mod bench;
mod deviation;
mod entrant;
mod findings;
mod history;
mod history_charts;
mod machine;
mod page;
mod picture;
mod process;
mod program;
mod table;

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;

use brt::image::{DecodeError, EncodeError, SizeMismatch};
use brt::{FileSet, Scene, Target};
use thiserror::Error;

pub use crate::paper::Watch;
use bench::Bench;
use findings::Findings;
use process::Patience;
use program::{Peer, Presence};

/// What is measured.
#[derive(Clone, Debug)]
pub struct Options {
    /// Scenes that passed their check, with their names.
    pub scenes: Vec<(String, Scene)>,
    /// Longer sides of the pictures; errors are measured at the first.
    pub sizes: Vec<u32>,
    /// Runs of which the median counts.
    pub repeat: u32,
    /// How long a single run may take.
    pub timeout: Duration,
    /// Only one sample per pixel, no anti-aliasing.
    pub plain: bool,
    /// Where to add the medians, if anywhere.
    pub record: Option<Recording>,
    /// The program `brt`.
    pub ours: PathBuf,
}

/// A history that medians are added to.
#[derive(Clone, Debug)]
pub struct Recording {
    /// A file of this module's; made if need be.
    pub file: PathBuf,
    /// What is measured: a version, a commit. On one line.
    pub label: String,
}

/// What came of it.
#[derive(Clone, Debug)]
pub struct Summary {
    /// The table for a terminal.
    pub table: String,
    /// What is missing, what could not be written for a peer, what went wrong.
    pub notes: Vec<String>,
    /// The page that was written; `peers.csv` lies beside it.
    pub page: PathBuf,
}

/// Why nothing was measured.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum PeersError {
    /// The user stopped it.
    #[error("stopped")]
    Cancelled,
    /// The folder cannot be made.
    #[error("cannot write {}", path.display())]
    File {
        /// The folder.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// A file cannot be read.
    #[error("cannot read {}", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// A file is no history; it is left as it is.
    #[error("{}, line {line}: {problem}", path.display())]
    History {
        /// The file.
        path: PathBuf,
        /// The first bad line, counted from 1.
        line: usize,
        /// What is wrong with it.
        problem: String,
    },
    /// Our own program does not work.
    #[error("{scene}: brt itself {problem}")]
    Ours {
        /// The scene.
        scene: String,
        /// What happened.
        problem: String,
    },
    /// A picture of ours cannot be read.
    #[error(transparent)]
    Decode(#[from] DecodeError),
    /// A file cannot be written, or a picture does not fit into the page.
    #[error(transparent)]
    Encode(#[from] EncodeError),
    /// Pictures are not of one size.
    #[error(transparent)]
    Size(#[from] SizeMismatch),
}

/// Measures, and writes `peers.csv` and `peers.html`, through `files`, into the folder, which is made if need be. Medians
/// are added to the history with them, if there is to be one. The scenes as the peers read them stay in the folder, too.
///
/// # Errors
/// See [`PeersError`]. A peer that is missing, fails or hangs is no error but a note.
pub fn run(options: &Options, folder: &Path, files: &FileSet, watch: Watch) -> Result<Summary, PeersError> {
    // A bad history should not be found after minutes of measuring.
    let history = options.record.as_ref().map(|record| history::read(&record.file)).transpose()?;
    fs::create_dir_all(folder).map_err(|source| PeersError::File { path: folder.to_owned(), source })?;
    let load_before = machine::load();
    let patience = Patience { timeout: options.timeout, cancel: watch.cancel };
    let mut notes = Vec::new();
    let mut conditions = vec![machine::processor(), format!("Measured on {} (UTC)", machine::today())];
    conditions.push(format!("brt {}", env!("CARGO_PKG_VERSION")));
    let present = find_peers(patience, &mut notes, &mut conditions)?;
    let mut bench = Bench::new(options, folder, watch, &present, notes);
    for (name, scene) in &options.scenes {
        bench.measure(name, scene)?;
    }
    let mut findings = bench.finish(conditions);
    findings.conditions.extend(noise(&findings, load_before));
    let new = options.record.as_ref().map_or(Vec::new(), |record| {
        history::records(&findings, &machine::today(), &record.label, &findings.processor)
    });
    findings.history = [history.unwrap_or_default(), new.clone()].concat();
    write(files, folder.join("peers.csv"), &table::csv(&findings))?;
    let page = folder.join("peers.html");
    write(files, page.clone(), &page::html(&findings))?;
    if let Some(record) = &options.record {
        history::append(files, &record.file, &new)?;
    }
    files.commit().map_err(EncodeError::Io)?;
    let mut table = table::text(&findings);
    table.push('\n');
    for condition in &findings.conditions {
        table.push_str(&format!("\n{condition}"));
    }
    Ok(Summary { table, notes: findings.notes, page })
}

fn find_peers(
    patience: Patience,
    notes: &mut Vec<String>,
    conditions: &mut Vec<String>,
) -> Result<Vec<Peer>, PeersError> {
    let mut present = Vec::new();
    for peer in Peer::ALL {
        let name = peer.name();
        match peer.presence(patience).map_err(|_| PeersError::Cancelled)? {
            Presence::Installed(version) => {
                conditions.push(format!("{name} {version}"));
                present.push(peer);
            }
            Presence::Absent => notes.push(format!(
                "{name} is not installed; on Debian and its relatives: apt-get install {}",
                peer.command()
            )),
            Presence::Broken(problem) => notes.push(format!("{name} is left out: {problem}")),
        }
    }
    if present.is_empty() {
        notes.insert(0, "no peer can be run, only brt is measured".to_owned());
    }
    Ok(present)
}

/// How much the times are to be trusted.
fn noise(findings: &Findings, load_before: Option<f64>) -> Vec<String> {
    /// Runs of the same work that differ more than this were disturbed.
    const QUIET: f64 = 0.1;
    let mut lines = Vec::new();
    if let Some(spread) = findings.spread() {
        let word = if spread > QUIET { "noisy" } else { "quiet" };
        let percent = 100.0 * spread;
        lines.push(format!(
            "A {word} machine: runs of the same work differ by {percent:.0} % (min to max, in the middle)"
        ));
    } else {
        lines.push("One run each: how noisy the machine is is not known".to_owned());
    }
    lines.extend(load_before.map(|load| format!("Load of the machine before: {load:.1}")));
    lines
}

/// Completes a file, which appears with the others of the set.
fn write(files: &FileSet, path: PathBuf, text: &str) -> Result<(), EncodeError> {
    let mut file = files.open(&Target::File(path))?;
    file.write_all(text.as_bytes())?;
    Ok(file.commit()?)
}
