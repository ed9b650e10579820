//! `--sheet`: four views of a scene in one picture.

use brt::framing::View;
use brt::image::encoder;
use brt::{Given, PictureSize, Rows, Run, Scene, Settings};

use super::failure;
use super::options::Options;
use super::targets::Targets;
use crate::exit::Failure;
use crate::interrupt;

/// In reading order: the whole, and the three sides that drawings show.
const VIEWS: [[View; 2]; 2] = [[View::Iso, View::Front], [View::Right, View::Top]];

/// Renders the views and writes them as one picture.
pub(super) fn render(
    options: &Options,
    targets: &Targets,
    scene: &mut Scene,
    given: &Given,
    settings: &Settings,
) -> Result<(), Failure> {
    let output = &targets.picture;
    let Some(target) = &output.target else { return Ok(()) };
    let [width, height] = settings.size;
    let mut file = encoder(target.open()?, PictureSize::new(width, height), output.encoding)?;
    options.view.paint(scene, given)?;
    options.view.stand(scene, given);
    for (views, height) in VIEWS.into_iter().zip(halves(height)) {
        let mut cell = |i: usize| {
            let size = [halves(width)[i], height];
            cell(options, scene, given, views[i], &Settings { size, ..settings.clone() })
        };
        let cells = [cell(0)?, cell(1)?];
        let [left, right] = halves(width).map(|width| width as usize);
        for (left, right) in cells[0].chunks_exact(left).zip(cells[1].chunks_exact(right)) {
            file.write(&[left, right].concat())?;
        }
    }
    Ok(file.finish()?)
}

/// The pixels of one view.
fn cell(
    options: &Options,
    scene: &mut Scene,
    given: &Given,
    view: View,
    settings: &Settings,
) -> Result<Vec<[f32; 3]>, Failure> {
    options.view.look(scene, given, Some(view), settings.size);
    let run = Run { threads: options.thread_count(), cancel: Some(interrupt::listen()), ..Run::default() };
    let mut rows: Vec<Rows> = Vec::new();
    brt::render(scene, settings, &run, &mut rows).map_err(|error| failure(error.into()))?;
    Ok(rows.into_iter().flat_map(|rows| rows.colors).collect())
}

/// Two parts of a length, the first not shorter than the second; neither is nothing if the length is at least 2.
fn halves(length: u32) -> [u32; 2] {
    [length.div_ceil(2), length / 2]
}
