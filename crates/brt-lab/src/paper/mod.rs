//! `brt paper`: every table and figure of the paper, measured here, as one page. Paper: P1–P20.
//!
//! Each experiment writes tables; charts, numbers and verdicts follow from them and from nothing else.

mod contenders;
mod experiments;
mod findings;
mod fit;
mod lab;
mod page;
mod picture;
mod subjects;
mod table;
mod verdicts;

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use brt::image::EncodeError;
use brt::{FileSet, RenderError, Scene, Target};
use thiserror::Error;

use findings::Findings;
use lab::Lab;
use subjects::Subjects;

/// What is measured, and how long.
#[derive(Clone, Debug)]
pub struct Options {
    /// Widths (and heights) of the pictures of Figs. 1–4.
    pub sizes: Vec<u32>,
    /// Repetitions of each time; the median counts.
    pub repeat: u32,
    /// Smaller pictures, fewer repetitions.
    pub quick: bool,
    /// A scene in place of the paper's three, and its name.
    pub scene: Option<(String, Scene)>,
}

impl Options {
    /// The paper's sizes and one beyond.
    pub const SIZES: [u32; 5] = [128, 256, 512, 1024, 2048];
    /// The sizes of a quick look.
    pub const QUICK_SIZES: [u32; 3] = [128, 256, 512];
    /// Repetitions unless told otherwise.
    pub const REPEAT: u32 = 3;
}

/// How the work is watched and stopped.
#[derive(Clone, Copy)]
pub struct Watch<'a> {
    /// Hears what is being measured.
    pub doing: &'a dyn Fn(&str),
    /// Stops the work when set.
    pub cancel: Option<&'a AtomicBool>,
}

/// Why there is no page.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum PaperError {
    /// A rendering failed or was cancelled.
    #[error(transparent)]
    Render(#[from] RenderError),
    /// A file could not be written, or a picture of the page not be encoded.
    #[error(transparent)]
    Encode(#[from] EncodeError),
    /// A named scene could not be built.
    #[error("{0}")]
    Scene(String),
    /// The folder could not be made.
    #[error("cannot write {}: {source}", path.display())]
    Write {
        /// The folder.
        path: PathBuf,
        /// What stood against it.
        source: io::Error,
    },
}

/// How the claims fared.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Summary {
    /// The page.
    pub page: PathBuf,
    /// Each claim with its verdict, such as `("P8", "holds")`.
    pub verdicts: Vec<(String, &'static str)>,
}

/// Measures everything and writes the page and its tables, through `files`, into a folder, which is made if need be.
///
/// # Errors
/// If a rendering is cancelled or a file cannot be written. Files are written last, and all appear or none.
pub fn run(options: &Options, folder: &Path, files: &FileSet, watch: Watch) -> Result<Summary, PaperError> {
    let subjects = Subjects::new(options)?;
    let lab = Lab::new(options, watch);
    let mut findings = Findings::default();
    let mut figures = Vec::new();
    for experiment in experiments::ALL {
        figures.push(experiment(&lab, &subjects, &mut findings)?);
    }
    let verdicts = verdicts::all(&findings, &subjects);
    findings.tables.push(verdicts::table(&verdicts, &findings));
    findings.tables.push(findings.numbers_table());
    let html = page::html(&lab, &subjects, &findings, &figures, &verdicts);

    fs::create_dir_all(folder).map_err(|source| PaperError::Write { path: folder.to_owned(), source })?;
    for table in &findings.tables {
        write_file(files, folder.join(format!("{}.csv", table.name)), &table.csv())?;
    }
    let page = folder.join("paper.html");
    write_file(files, page.clone(), &html)?;
    files.commit().map_err(EncodeError::Io)?;
    Ok(Summary { page, verdicts: verdicts.iter().map(|v| (v.claim.to_owned(), v.outcome.name())).collect() })
}

fn write_file(files: &FileSet, path: PathBuf, text: &str) -> Result<(), EncodeError> {
    let mut file = files.open(&Target::File(path))?;
    file.write_all(text.as_bytes())?;
    Ok(file.commit()?)
}
