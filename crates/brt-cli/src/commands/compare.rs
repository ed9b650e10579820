//! `brt compare`: how far two pictures differ.

use std::io::{self, Read};
use std::path::{Path, PathBuf};

use brt::image::{self, PictureLimits, Sink, decode_picture, heat_rows, read_picture};
use brt::{Comparison, Encoding, Output, Target};
use clap::Args;

use crate::context::Context;
use crate::exit::{Failure, Outcome, wrong_use};
use crate::json::{self, ComparisonJson};
use crate::output;
use crate::scene_input::{is_dash, same_file};
use crate::values;

/// Options of `brt compare`.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// The picture that is right
    #[arg(value_name = "REF")]
    reference: PathBuf,
    /// The picture that is judged; `-` reads standard input
    #[arg(value_name = "TEST")]
    test: PathBuf,
    /// Print the measures as JSON
    #[arg(long)]
    json: bool,
    /// Exit with 3 if a difference is greater than this, in levels of 255
    #[arg(long, value_name = "LEVELS", allow_negative_numbers = true, value_parser = values::not_negative)]
    max_error: Option<f64>,
    /// Write a picture of the differences: black 0, violet 1 level, then red to yellow
    #[arg(long, value_name = "OUT")]
    heat_map: Option<PathBuf>,
    /// Refuse pictures of more pixels
    #[arg(long, value_name = "N", default_value_t = PictureLimits::default().pixels, help_heading = "Limits",
          allow_negative_numbers = true, value_parser = values::count)]
    max_pixels: u64,
}

/// Compares two pictures. Alpha counts as a fourth channel.
pub(crate) fn run(options: &Options, context: &Context) -> Result<Outcome, Failure> {
    if is_dash(&options.reference) && is_dash(&options.test) {
        return Err(wrong_use("standard input holds one picture, expected a file for the other"));
    }
    let map = options.heat_map.as_deref().map(|path| HeatMap::open(options, path, context)).transpose()?;
    let limits = PictureLimits { pixels: options.max_pixels };
    let reference = read(&options.reference, limits)?;
    let test = read(&options.test, limits)?;
    let comparison = image::compare(&reference, &test)?;
    if let Some(map) = map {
        map.write(&reference, &test)?;
        context.files.commit()?;
    }
    if let Some(path) = only_one_without_alpha(options, &reference, &test) {
        output::note(&format!("{} has no alpha: compared as if it were opaque", path.display()));
    }
    if options.json {
        output::line(&json::text(&ComparisonJson::from(&comparison))?)?;
    } else {
        output::line(&describe(&comparison))?;
        if comparison.max_error == 1.0 && [&reference, &test].into_iter().all(has_whole_levels) {
            output::line(
                "one level is what rounding to 8 bits alone may make: the unrounded pictures may be closer",
            )?;
        }
    }
    let over = options.max_error.is_some_and(|limit| comparison.max_error > limit);
    Ok(if over { Outcome::OverLimit } else { Outcome::Done })
}

/// Reads a picture; `-` is that on standard input.
fn read(path: &Path, limits: PictureLimits) -> Result<image::Picture, Failure> {
    if !is_dash(path) {
        return Ok(read_picture(path, limits)?);
    }
    let mut bytes = Vec::new();
    io::stdin().lock().read_to_end(&mut bytes)?;
    Ok(decode_picture(&bytes, limits).map_err(|error| anyhow::anyhow!("standard input: {error}"))?)
}

/// The picture without alpha, if the other has one.
fn only_one_without_alpha<'o>(
    options: &'o Options,
    reference: &image::Picture,
    test: &image::Picture,
) -> Option<&'o Path> {
    match (reference.has_alpha(), test.has_alpha()) {
        (true, false) => Some(&options.test),
        (false, true) => Some(&options.reference),
        _ => None,
    }
}

/// A picture of the differences that is to be written.
struct HeatMap {
    file: Box<dyn Sink>,
    encoding: Encoding,
}

impl HeatMap {
    /// Opens the file, not over one of the pictures, before these are read, which may take long.
    fn open(options: &Options, path: &Path, context: &Context) -> Result<Self, Failure> {
        let Output { encoding, .. } = Output::to_file(path).map_err(|error| wrong_use(error.to_string()))?;
        if [&options.reference, &options.test]
            .into_iter()
            .any(|picture| !is_dash(picture) && same_file(picture, path))
        {
            return Err(wrong_use(format!("{} would overwrite a picture that is compared", path.display())));
        }
        Ok(Self { file: context.files.open(&Target::File(path.to_owned()))?, encoding })
    }

    /// Row by row: the pictures take enough memory.
    fn write(self, reference: &image::Picture, test: &image::Picture) -> Result<(), Failure> {
        let mut encoder = image::encoder(self.file, reference.size(), self.encoding)?;
        for row in heat_rows(reference, test)? {
            encoder.write(&row)?;
        }
        Ok(encoder.finish()?)
    }
}

fn describe(c: &Comparison) -> String {
    format!(
        "pixels      {}\nmean error  {:.4} levels of 255\nmax error   {}\nover 1      {}\nover 2      {}\nover 10     {}",
        c.pixels, c.mean_error, c.max_error, c.over_1, c.over_2, c.over_10
    )
}

/// Are all stored values codes of 8 bits?
fn has_whole_levels(picture: &image::Picture) -> bool {
    let pixels = picture.size().pixels() as usize;
    let is_whole = |level: &f64| level.fract() == 0.0;
    (0..pixels).all(|i| picture.levels(i).iter().chain(&[picture.alpha_level(i)]).all(is_whole))
}
