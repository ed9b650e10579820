//! How far everybody's pictures are from ours.

use std::fs;

use brt::image::{Picture, PictureLimits, read_picture};

use super::bench::Bench;
use super::deviation::Deviation;
use super::entrant::{Class, Entrant, Program, Task, reference_command};
use super::findings::{Row, Strip};
use super::process::{RunError, run};
use super::{PeersError, picture};

impl Bench<'_> {
    /// Deviations of all rows from the reference of their class, and pictures for the page.
    ///
    /// With one sample it is our `full`, with which all should agree. With more it is `full` with very many, which
    /// all try to come near to.
    pub(super) fn pictures(
        &mut self,
        name: &str,
        task: &Task,
        rows: &mut [Row],
        still_in: &mut Vec<Entrant>,
    ) -> Result<(), PeersError> {
        let mut strip = Strip { scene: name.to_owned(), pictures: Vec::new() };
        for class in Class::ALL {
            let mut rows = rows.iter_mut().filter(|row| row.entrant.class == class).peekable();
            let mut reference = match class {
                Class::AntiAliased if rows.peek().is_some() => self.reference(name, task)?,
                _ => None,
            };
            for row in rows {
                (self.watch.doing)(&format!("{name}: picture by {}", row.entrant.name));
                let Some(drawn) = self.picture(name, row.entrant, task, still_in)? else { continue };
                row.deviation =
                    reference.as_ref().map(|reference| Deviation::between(reference, &drawn)).transpose()?;
                if class == Class::Plain {
                    strip.add(row.entrant, &drawn, reference.as_ref())?;
                    reference.get_or_insert(drawn);
                }
            }
        }
        self.findings.pictures.push(strip);
        Ok(())
    }

    /// `full` with very many samples; `None` and a note if that takes too long.
    fn reference(&mut self, name: &str, task: &Task) -> Result<Option<Picture>, PeersError> {
        (self.watch.doing)(&format!("{name}: the reference of anti-aliased pictures"));
        let file = format!("{}-reference.ppm", task.stem);
        match run(&mut reference_command(task, &file), self.patience()) {
            Ok(_) => {}
            Err(RunError::Cancelled) => return Err(PeersError::Cancelled),
            Err(problem @ RunError::TimedOut(_)) => {
                self.findings.notes.push(format!("{name}: the reference of anti-aliased pictures {problem}"));
                return Ok(None);
            }
            Err(problem) => {
                return Err(PeersError::Ours { scene: name.to_owned(), problem: problem.to_string() });
            }
        }
        let path = self.folder.join(&file);
        let drawn = read_picture(&path, PictureLimits::default());
        let _ = fs::remove_file(&path);
        Ok(Some(drawn?))
    }

    fn picture(
        &mut self,
        name: &str,
        entrant: Entrant,
        task: &Task,
        still_in: &mut Vec<Entrant>,
    ) -> Result<Option<Picture>, PeersError> {
        let file = format!("{}-picture.ppm", task.stem);
        let path = self.folder.join(&file);
        if self.run(name, entrant, task, Some(&file), still_in)?.is_none() {
            return Ok(None);
        }
        let drawn = read_picture(&path, PictureLimits::default());
        // The page has a small copy; whoever wants it large has the scene.
        let _ = fs::remove_file(&path);
        match (drawn, entrant.program) {
            (Ok(picture), _) => Ok(Some(picture)),
            (Err(error), Program::Ours(_)) => Err(error.into()),
            (Err(error), Program::Other(_)) => {
                self.findings.notes.push(format!("{name}: no picture by {}: {error}", entrant.name));
                Ok(None)
            }
        }
    }
}

impl Strip {
    /// A picture and its difference from `full`, unless a look would not tell it from that.
    fn add(&mut self, entrant: Entrant, drawn: &Picture, full: Option<&Picture>) -> Result<(), PeersError> {
        if ["brt border", "brt certified"].contains(&entrant.name) {
            return Ok(());
        }
        self.pictures.push((entrant.name.to_owned(), picture::image(drawn, entrant.name)?));
        if let Some(full) = full {
            let text = format!("{}: difference from brt full", entrant.name);
            self.pictures.push((text.clone(), picture::difference(full, drawn, &text)?));
        }
        Ok(())
    }
}
