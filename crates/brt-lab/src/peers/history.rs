//! Medians of many runs of `brt peers`, kept in one file from version to version.

use std::path::Path;
use std::{fs, io};

use brt::FileSet;
use csv::{ReaderBuilder, StringRecord};

use super::entrant::Program;
use super::findings::{Findings, Row};
use super::program::Peer;
use super::{PeersError, write};
use crate::csv_text;

/// What the columns of the file are called.
const COLUMNS: &str =
    "date,label,processor,scene,width,height,samples,method,ns_per_pixel,ratio_povray,ratio_tachyon";

/// A method of ours on a scene at a size, in one run.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Record {
    pub(super) date: String,
    /// What was measured: a version, a commit.
    pub(super) label: String,
    pub(super) processor: String,
    pub(super) scene: String,
    pub(super) size: [u32; 2],
    /// Per pixel.
    pub(super) samples: u32,
    pub(super) method: String,
    pub(super) ns_per_pixel: f64,
    /// How many times as long each of [`Peer::ALL`] took, with its own anti-aliasing if samples are more than one.
    pub(super) ratios: [Option<f64>; 2],
}

/// The records of a run.
pub(super) fn records(findings: &Findings, date: &str, label: &str, processor: &str) -> Vec<Record> {
    let record = |row: &Row| {
        let Program::Ours(method) = row.entrant.program else { return None };
        let ns_per_pixel = row.median()?;
        let ratio = |peer| {
            let same = (row.scene.as_str(), row.size);
            let mut rows = findings.rows_of(same, row.entrant.class);
            Some(rows.find(|r| r.entrant.program == Program::Other(peer))?.median()? / ns_per_pixel)
        };
        Some(Record {
            date: date.to_owned(),
            label: label.to_owned(),
            processor: processor.to_owned(),
            scene: row.scene.clone(),
            size: row.size,
            samples: row.entrant.class.samples(),
            method: method.to_owned(),
            ns_per_pixel,
            ratios: Peer::ALL.map(|peer| ratio(peer).filter(|ratio| ratio.is_finite())),
        })
    };
    findings.rows.iter().filter_map(record).collect()
}

/// Reads a file; none or an empty one is a history that begins.
pub(super) fn read(path: &Path) -> Result<Vec<Record>, PeersError> {
    parse(&text_of(path)?).map_err(|(line, problem)| PeersError::History {
        path: path.to_owned(),
        line,
        problem,
    })
}

/// Adds records to a file, once the set is committed. What is there stays as it is, to the byte.
pub(super) fn append(files: &FileSet, path: &Path, records: &[Record]) -> Result<(), PeersError> {
    read(path)?;
    let mut text = text_of(path)?;
    if text.is_empty() {
        text.push_str(COLUMNS);
    }
    if !text.ends_with('\n') {
        text.push('\n');
    }
    text.push_str(&csv_text::lines(records.iter().map(fields)));
    Ok(write(files, path.to_owned(), &text)?)
}

fn text_of(path: &Path) -> Result<String, PeersError> {
    match fs::read_to_string(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(String::new()),
        other => other.map_err(|source| PeersError::Unreadable { path: path.to_owned(), source }),
    }
}

fn fields(record: &Record) -> [String; 11] {
    let ratio = |ratio: Option<f64>| ratio.map_or(String::new(), |ratio| format!("{ratio:.4}"));
    [
        record.date.clone(),
        record.label.clone(),
        record.processor.clone(),
        record.scene.clone(),
        record.size[0].to_string(),
        record.size[1].to_string(),
        record.samples.to_string(),
        record.method.clone(),
        format!("{:.3}", record.ns_per_pixel),
        ratio(record.ratios[0]),
        ratio(record.ratios[1]),
    ]
}

/// The records, or the number of the first bad line and what is wrong with it.
fn parse(text: &str) -> Result<Vec<Record>, (usize, String)> {
    match text.lines().next() {
        None => return Ok(Vec::new()),
        Some(COLUMNS) => {}
        Some(_) => return Err((1, format!("not a history: expected the columns {COLUMNS}"))),
    }
    let mut reader = ReaderBuilder::new().flexible(true).from_reader(text.as_bytes());
    let read = |line: Result<StringRecord, csv::Error>| {
        let line = line.map_err(|error| (0, error.to_string()))?;
        let number = line.position().map_or(0, |position| position.line() as usize);
        parse_line(&line).map_err(|problem| (number, problem))
    };
    reader.records().map(read).collect()
}

fn parse_line(line: &StringRecord) -> Result<Record, String> {
    let fields: Vec<String> = line.iter().map(str::to_owned).collect();
    let count = fields.len();
    let [date, label, processor, scene, width, height, samples, method, ns, ratios @ ..] = fields.as_slice()
    else {
        return Err(wrong_count(count));
    };
    let [povray, tachyon] = ratios else { return Err(wrong_count(count)) };
    let ratio = |text: &str| if text.is_empty() { Ok(None) } else { number(text).map(Some) };
    Ok(Record {
        date: date.clone(),
        label: label.clone(),
        processor: processor.clone(),
        scene: scene.clone(),
        size: [whole(width)?, whole(height)?],
        samples: whole(samples)?,
        method: method.clone(),
        ns_per_pixel: number(ns)?,
        ratios: [ratio(povray)?, ratio(tachyon)?],
    })
}

fn wrong_count(count: usize) -> String {
    format!("{count} fields instead of {}", COLUMNS.split(',').count())
}

fn whole(text: &str) -> Result<u32, String> {
    text.parse().map_err(|_| format!("`{text}` is not a whole number"))
}

fn number(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok().filter(|n| n.is_finite() && *n >= 0.0);
    number.ok_or_else(|| format!("`{text}` is not a number, at least 0"))
}

#[cfg(test)]
pub(super) mod tests {
    use brt::image::EncodeError;

    use super::super::findings::tests::example;
    use super::*;

    /// Two runs, the second of them twice as fast.
    pub(in super::super) fn two_runs() -> Vec<Record> {
        let first = records(&example(), "2026-01-01", "0.1", "Fast 3000");
        let faster = |r: &Record| Record {
            label: "0.2".into(),
            ns_per_pixel: 0.5 * r.ns_per_pixel,
            ratios: r.ratios.map(|ratio| ratio.map(|r| 2.0 * r)),
            ..r.clone()
        };
        let second: Vec<Record> = first.iter().map(faster).collect();
        [first, second].concat()
    }

    #[test]
    fn records_are_ours_with_the_ratios_of_peers_of_the_same_class() {
        let records = two_runs();
        assert_eq!(records.len(), 2 * 6);
        let Record { method, samples, ns_per_pixel, ratios, .. } = &records[2];
        assert_eq!((method.as_str(), *samples, *ns_per_pixel), ("certified", 1, 200.0));
        assert_eq!(*ratios, [Some(1.25), Some(1.5)]);
        assert_eq!((records[3].samples, records[3].ratios[0]), (16, Some(500.0 / 350.0)));
    }

    #[test]
    fn what_was_added_is_read_and_what_was_there_stays() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("history.csv");
        assert_eq!(read(&path).unwrap(), []);
        let both = two_runs();
        let files = FileSet::new();
        let add = |records| {
            append(&files, &path, records).and_then(|()| Ok(files.commit().map_err(EncodeError::Io)?))
        };
        add(&both[..6]).unwrap();
        let before = fs::read_to_string(&path).unwrap();
        // An editor may have taken the last end of line.
        fs::write(&path, before.trim_end()).unwrap();
        add(&both[6..]).unwrap();
        assert!(fs::read_to_string(&path).unwrap().starts_with(&before));
        let read = read(&path).unwrap();
        assert_eq!(read.len(), 12);
        assert_eq!((&read[0].scene, &read[11].label), (&"a,b".to_owned(), &"0.2".to_owned()));
    }

    #[test]
    fn a_bad_file_is_refused_with_its_line_and_left_as_it_is() {
        let good = csv_text::lines([fields(&two_runs()[0])]);
        for (text, part) in [
            ("a,b\n".to_owned(), "line 1: not a history"),
            (format!("{COLUMNS}\n{good}a\n"), "line 3: 1 fields instead of 11"),
            (format!("{COLUMNS}\n{}", good.replace("32,32", "32,x")), "line 2: `x` is not a whole number"),
            (format!("{COLUMNS}\n{}", good.replace("100.000", "NaN")), "line 2: `NaN` is not a number"),
            (format!("{COLUMNS}\n{}", good.replace("b\"", "b")), "line 2: 4 fields instead of 11"),
        ] {
            let folder = tempfile::tempdir().unwrap();
            let path = folder.path().join("history.csv");
            fs::write(&path, &text).unwrap();
            let error = append(&FileSet::new(), &path, &two_runs()).unwrap_err().to_string();
            assert!(error.contains(part), "{error}");
            assert_eq!(fs::read_to_string(&path).unwrap(), text);
        }
    }
}
