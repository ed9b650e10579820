//! `--sheet`: four views of a scene in one picture.

use brt::framing::View;
use brt::image::{PixelRows, encoder};
use brt::{Given, PictureSize, Rows, Scene, Settings};

use super::failure;
use super::options::Options;
use super::targets::Targets;
use crate::exit::Failure;

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
        let widths = halves(width);
        for row in 0..height as usize {
            let [left, right] = [0, 1].map(|i| cells[i].row(row, widths[i] as usize));
            let colors = [left.colors, right.colors].concat();
            let alpha = left.alpha.zip(right.alpha).map(|(left, right)| [left, right].concat());
            file.write_pixels(PixelRows { colors: &colors, alpha: alpha.as_deref() })?;
        }
    }
    Ok(file.finish()?)
}

/// The pixels of one view.
struct Cell {
    colors: Vec<[f32; 3]>,
    alpha: Option<Vec<f32>>,
}

impl Cell {
    fn row(&self, row: usize, width: usize) -> PixelRows<'_> {
        let run = row * width..(row + 1) * width;
        PixelRows { colors: &self.colors[run.clone()], alpha: self.alpha.as_ref().map(|a| &a[run]) }
    }
}

fn cell(
    options: &Options,
    scene: &mut Scene,
    given: &Given,
    view: View,
    settings: &Settings,
) -> Result<Cell, Failure> {
    options.view.look(scene, given, Some(view), settings.size);
    let mut rows: Vec<Rows> = Vec::new();
    brt::render(scene, settings, &options.run(), &mut rows).map_err(|error| failure(error.into()))?;
    let mut cell = Cell { colors: Vec::new(), alpha: settings.backdrop.has_alpha().then(Vec::new) };
    for rows in rows {
        cell.colors.extend(rows.colors);
        cell.alpha.iter_mut().for_each(|alpha| alpha.extend(rows.alpha.iter().flatten()));
    }
    Ok(cell)
}

/// Two parts of a length, the first not shorter than the second; neither is nothing if the length is at least 2.
fn halves(length: u32) -> [u32; 2] {
    [length.div_ceil(2), length / 2]
}
