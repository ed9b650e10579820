//! `--sheet`: four views of a scene in one picture.
//!
//! Two views that stand side by side are rendered at the same time, so that their rows can be joined as they come, and
//! memory stays proportional to the width.

use std::error::Error;
use std::fmt;
use std::iter::zip;
use std::panic::resume_unwind;
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::thread;

use brt::framing::View;
use brt::image::{BandWriter, PixelRows, encoder};
use brt::{
    CheckedScene, Given, PictureSize, RenderError, Rows, Run, Scene, Settings, Sink, SinkError, Transfer,
    Window, render as render_rows,
};

use super::options::Options;
use super::targets::Targets;
use super::{failure, fit};
use crate::context::Context;
use crate::exit::Failure;

/// In reading order: the whole, and the three sides that drawings show.
const VIEWS: [[View; 2]; 2] = [[View::Iso, View::Front], [View::Right, View::Top]];

/// Portions of rows of the left view that may wait for the right one.
const MOST_WAITING: usize = 2;

/// Renders the views and writes them as one picture.
pub(super) fn render(
    options: &Options,
    targets: &Targets,
    context: &Context,
    mut scene: Scene,
    given: &Given,
    settings: &Settings,
) -> Result<(), Failure> {
    let output = &targets.picture;
    let Some(target) = &output.target else { return Ok(()) };
    let Window { width, height, .. } = settings.whole()?;
    let mut file = encoder(context.files.open(target)?, PictureSize::new(width, height), output.encoding)?;
    options.view.paint(&mut scene, given)?;
    options.view.stand(&mut scene, given);
    let transfer = output.encoding.effective_transfer();
    for (views, height) in zip(VIEWS, halves(height)) {
        let cells = zip(views, halves(width)).map(|(view, width)| {
            let mut scene = scene.clone();
            options.view.look(&mut scene, given, Some(view), [width, height]);
            Ok((fit(scene)?, Settings { size: [width, height].map(u64::from), ..settings.clone() }))
        });
        let cells: Vec<_> = cells.collect::<Result<_, Failure>>()?;
        render_pair(&cells, options, context, &mut *file, transfer).map_err(|error| failure(error.into()))?;
    }
    file.finish().map_err(|error| failure(error.into()))?;
    Ok(context.files.commit()?)
}

/// Renders two views, the left one on a thread of its own, and writes their joined rows.
fn render_pair(
    cells: &[(CheckedScene, Settings)],
    options: &Options,
    context: &Context,
    file: &mut dyn BandWriter,
    transfer: Transfer,
) -> Result<(), RenderError> {
    let [(left, left_settings), (right, right_settings)] = cells else { return Ok(()) };
    // One thread at least for each, even if only one was asked for.
    let threads = halves(options.thread_count() as u32).map(|threads| threads.max(1) as usize);
    let run = |threads| Run { threads, ..options.run(context) };
    let (send, receive) = sync_channel(MOST_WAITING);
    let mut sender = Sender { send, transfer };
    let mut joiner = Joiner { receive, file, transfer };
    let [for_left, for_right] = threads;
    let (left, right) = thread::scope(|scope| {
        // Each side holds its end of the channel only as long as it renders: neither waits for one that has failed.
        let left = scope.spawn(move || render_rows(left, left_settings, &run(for_left), &mut sender));
        let right = render_rows(right, right_settings, &run(for_right), &mut joiner);
        drop(joiner);
        (left.join().unwrap_or_else(|panic| resume_unwind(panic)), right)
    });
    match (left, right) {
        (Ok(_), Ok(_)) => Ok(()),
        (Err(error), _) if !is_consequence(&error) => Err(error),
        (_, Err(error)) | (Err(error), _) => Err(error),
    }
}

/// Two parts of a length, the first not shorter than the second; neither is nothing if the length is at least 2.
fn halves(length: u32) -> [u32; 2] {
    [length.div_ceil(2), length / 2]
}

/// Hands the rows of the left view over.
struct Sender {
    send: SyncSender<Rows>,
    transfer: Transfer,
}

impl Sink for Sender {
    fn transfer(&self) -> Transfer {
        self.transfer
    }

    fn take(&mut self, rows: &Rows) -> Result<(), SinkError> {
        Ok(self.send.send(rows.clone()).map_err(|_| OtherEnded)?)
    }
}

/// Takes the rows of the right view, and writes them beside those of the left one.
struct Joiner<'f> {
    receive: Receiver<Rows>,
    file: &'f mut dyn BandWriter,
    transfer: Transfer,
}

impl Sink for Joiner<'_> {
    fn transfer(&self) -> Transfer {
        self.transfer
    }

    fn take(&mut self, right: &Rows) -> Result<(), SinkError> {
        let left = self.receive.recv().map_err(|_| OtherEnded)?;
        // Bands follow from height and samples, which are the same.
        if (left.first, left.count()) != (right.first, right.count()) {
            return Err("two views side by side came in different rows".into());
        }
        let joined = |row: usize| {
            let [left, right] = [&left, right].map(|rows| one_row(rows, row));
            let alpha = left.alpha.zip(right.alpha).map(|(left, right)| [left, right].concat());
            ([left.colors, right.colors].concat(), alpha)
        };
        for (colors, alpha) in (0..right.count() as usize).map(joined) {
            self.file.write_pixels(PixelRows { colors: &colors, alpha: alpha.as_deref() })?;
        }
        Ok(())
    }
}

fn one_row(rows: &Rows, row: usize) -> PixelRows<'_> {
    let width = rows.width as usize;
    let run = row * width..(row + 1) * width;
    PixelRows { colors: &rows.colors[run.clone()], alpha: rows.alpha.as_ref().map(|alpha| &alpha[run]) }
}

/// A view cannot go on because the one beside it did not.
#[derive(Debug)]
struct OtherEnded;

impl fmt::Display for OtherEnded {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("the view beside it was not rendered")
    }
}

impl Error for OtherEnded {}

fn is_consequence(error: &RenderError) -> bool {
    matches!(error, RenderError::Sink(error) if error.is::<OtherEnded>())
}
