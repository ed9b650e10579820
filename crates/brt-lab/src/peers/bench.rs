//! Runs everybody in turns.

use std::path::{Path, PathBuf};

use brt::formats::write as write_scene;
use brt::image::EncodeError;
use brt::scene::Highlight;
use brt::{FileSet, Format, Scene};

use super::entrant::{Class, ENTRANTS, Entrant, Program, Task};
use super::findings::{Findings, Row, median};
use super::process::{Patience, RunError, run};
use super::program::Peer;
use super::{Options, PeersError, Watch, machine, write};

/// Side of the picture that shows what a program needs before it renders.
const START_UP_SIDE: u32 = 16;
/// Runs for that, at least: they are short.
const START_UP_RUNS: u32 = 3;
/// A run that takes longer than this is not repeated.
const LONG_SECONDS: f64 = 5.0;

/// Everything there is to do it with, and what it has given so far.
pub(super) struct Bench<'a> {
    options: &'a Options,
    pub(super) folder: &'a Path,
    pub(super) watch: Watch<'a>,
    entrants: Vec<Entrant>,
    pub(super) findings: Findings,
}

impl<'a> Bench<'a> {
    pub(super) fn new(
        options: &'a Options,
        folder: &'a Path,
        watch: Watch<'a>,
        present: &[Peer],
        notes: Vec<String>,
    ) -> Self {
        let takes_part = |entrant: &Entrant| match entrant.program {
            _ if options.plain && entrant.class != Class::Plain => false,
            Program::Ours(_) => true,
            Program::Other(peer) => present.contains(&peer),
        };
        let entrants = ENTRANTS.into_iter().filter(takes_part).collect();
        let findings = Findings {
            conditions: Vec::new(),
            notes,
            rows: Vec::new(),
            pictures: Vec::new(),
            repeat: options.repeat,
            history: Vec::new(),
            processor: machine::processor(),
        };
        Self { options, folder, watch, entrants, findings }
    }

    pub(super) fn finish(self, conditions: Vec<String>) -> Findings {
        Findings { conditions, ..self.findings }
    }

    /// Measures a scene at all sizes.
    pub(super) fn measure(&mut self, name: &str, scene: &Scene) -> Result<(), PeersError> {
        let stem = file_stem(name);
        let toml = format!("{stem}.toml");
        write_scene_file(self.folder.join(&toml), &brt::write_toml(scene))?;
        let mut still_in = self.entrants.clone();
        let mut start_ups = Vec::new();
        for (index, &side) in self.options.sizes.iter().enumerate() {
            let size = picture_size(scene.size, side);
            let stem = format!("{stem}-{}x{}", size[0], size[1]);
            self.write_for_peers(name, scene, size, &stem, index == 0)?;
            let (ours, folder) = (self.options.ours.as_path(), self.folder);
            let task = Task { ours, folder, toml: &toml, stem: &stem, size, has_phong: has_phong(scene) };
            if index == 0 {
                start_ups = self.start_ups(name, &task, &mut still_in)?;
            }
            let mut rows = self.times(name, &task, &start_ups, &mut still_in)?;
            if index == 0 {
                self.pictures(name, &task, &mut rows, &mut still_in)?;
            }
            self.findings.rows.extend(rows);
        }
        Ok(())
    }

    fn write_for_peers(
        &mut self,
        name: &str,
        scene: &Scene,
        size: [u32; 2],
        stem: &str,
        is_first: bool,
    ) -> Result<(), PeersError> {
        let sized = Scene { size: Some(size), ..scene.clone() };
        for peer in Peer::ALL {
            let format: Format = peer.format();
            let Ok(written) = write_scene(format, &sized) else { continue };
            write_scene_file(self.folder.join(format!("{stem}.{}", format.extensions()[0])), &written.text)?;
            if is_first && self.entrants.iter().any(|e| e.program == Program::Other(peer)) {
                let notes = written.report.diagnostics.into_iter().map(|d| format!("{name}: {}", d.message));
                self.findings.notes.extend(notes);
            }
        }
        Ok(())
    }

    /// What each program needs for a picture of next to nothing.
    fn start_ups(
        &mut self,
        name: &str,
        task: &Task,
        still_in: &mut Vec<Entrant>,
    ) -> Result<Vec<(Program, f64)>, PeersError> {
        let tiny = Task {
            size: picture_size(Some(task.size), START_UP_SIDE.min(task.size[0].max(task.size[1]))),
            ..*task
        };
        let mut times: Vec<(Program, Vec<f64>)> = Vec::new();
        for _ in 0..self.options.repeat.max(START_UP_RUNS) {
            for entrant in ENTRANTS.into_iter().filter(|e| e.class == Class::Plain) {
                if !still_in.contains(&entrant) {
                    continue;
                }
                (self.watch.doing)(&format!("{name}: {} starting", entrant.name));
                let Some(seconds) = self.run(name, entrant, &tiny, None, still_in)? else { continue };
                match times.iter_mut().find(|(program, _)| *program == entrant.program) {
                    Some((_, seconds_of)) => seconds_of.push(seconds),
                    None => times.push((entrant.program, vec![seconds])),
                }
            }
        }
        let middle = |(program, mut seconds): (Program, Vec<f64>)| {
            seconds.sort_by(f64::total_cmp);
            (program, median(&seconds).unwrap_or_default())
        };
        Ok(times.into_iter().map(middle).collect())
    }

    fn times(
        &mut self,
        name: &str,
        task: &Task,
        start_ups: &[(Program, f64)],
        still_in: &mut Vec<Entrant>,
    ) -> Result<Vec<Row>, PeersError> {
        let [width, height] = task.size;
        let pixels = f64::from(width) * f64::from(height);
        let start_up = |e: Entrant| start_ups.iter().find(|(p, _)| *p == e.program).map_or(0.0, |(_, s)| *s);
        let mut rows: Vec<Row> = still_in
            .iter()
            .map(|&entrant| Row {
                scene: name.to_owned(),
                size: task.size,
                entrant,
                start_up: start_up(entrant),
                ns_per_pixel: Vec::new(),
                deviation: None,
            })
            .collect();
        for round in 0..self.options.repeat {
            for row in &mut rows {
                let last = row.ns_per_pixel.last().copied().unwrap_or_default() * 1e-9 * pixels;
                if !still_in.contains(&row.entrant) || last > LONG_SECONDS {
                    continue;
                }
                let of = self.options.repeat;
                (self.watch.doing)(&format!(
                    "{name} {width}×{height}, {} of {of}: {}",
                    round + 1,
                    row.entrant.name
                ));
                if let Some(seconds) = self.run(name, row.entrant, task, None, still_in)? {
                    row.ns_per_pixel.push(1e9 * (seconds - row.start_up).max(0.0) / pixels);
                }
            }
        }
        for row in &mut rows {
            row.ns_per_pixel.sort_by(f64::total_cmp);
        }
        rows.retain(|row| !row.ns_per_pixel.is_empty());
        Ok(rows)
    }

    pub(super) fn patience(&self) -> Patience<'a> {
        Patience { timeout: self.options.timeout, cancel: self.watch.cancel }
    }

    /// User CPU seconds; `None` and a note if a peer fails, which is out for this scene then.
    pub(super) fn run(
        &mut self,
        name: &str,
        entrant: Entrant,
        task: &Task,
        picture: Option<&str>,
        still_in: &mut Vec<Entrant>,
    ) -> Result<Option<f64>, PeersError> {
        match run(&mut entrant.command(task, picture), self.patience()) {
            Ok(ended) => Ok(Some(ended.user_seconds)),
            Err(RunError::Cancelled) => Err(PeersError::Cancelled),
            Err(problem) if matches!(entrant.program, Program::Ours(_)) => {
                Err(PeersError::Ours { scene: name.to_owned(), problem: problem.to_string() })
            }
            Err(problem) => {
                still_in.retain(|other| *other != entrant);
                let [width, height] = task.size;
                self.findings.notes.push(format!("{name} {width}×{height}: {} {problem}", entrant.name));
                Ok(None)
            }
        }
    }
}

/// The scene's own proportions, or a square.
fn picture_size(own: Option<[u32; 2]>, side: u32) -> [u32; 2] {
    let [width, height] = own.unwrap_or([1, 1]);
    let scaled = |part: u32| {
        let greatest = u64::from(width.max(height).max(1));
        ((u64::from(part) * u64::from(side) + greatest / 2) / greatest).max(1) as u32
    };
    [scaled(width), scaled(height)]
}

fn has_phong(scene: &Scene) -> bool {
    scene.materials.iter().any(|m| m.specular > 0.0 && m.highlight == Highlight::Phong)
}

/// A name that every program takes for a file.
fn file_stem(name: &str) -> String {
    let plain = |c: char| if c.is_ascii_alphanumeric() || c == '-' || c == '_' { c } else { '_' };
    name.chars().map(plain).collect()
}

/// Puts a scene in place at once, for programs to read.
fn write_scene_file(path: PathBuf, text: &str) -> Result<(), EncodeError> {
    let files = FileSet::new();
    write(&files, path, text)?;
    Ok(files.commit()?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictures_keep_the_scenes_proportions() {
        assert_eq!(picture_size(None, 512), [512, 512]);
        assert_eq!(picture_size(Some([640, 480]), 512), [512, 384]);
        assert_eq!(picture_size(Some([1, 1000]), 16), [1, 16]);
    }

    #[test]
    fn file_names_are_plain() {
        assert_eq!(file_stem("-a b/ü.x"), "-a_b___x");
    }
}
