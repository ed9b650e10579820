//! Where the picture, its layers and its statistics go. What cannot be is refused before anything is rendered.

use std::io::{self, IsTerminal};
use std::path::{Path, PathBuf};

use anyhow::bail;
use brt::{Channels, Output, PictureFormat, Transfer};

use super::options::Options;
use crate::commands::text_file;
use crate::exit::{Failure, wrong_use};
use crate::scene_input::{check_distinct, is_dash};

/// Width and height are at most this: sample indices stay far below 2³².
const GREATEST_SIDE: u32 = 1 << 24;

/// All files that are written.
pub(super) struct Targets {
    pub(super) picture: Output,
    /// `-` for standard output.
    pub(super) stats: Option<PathBuf>,
}

impl Targets {
    pub(super) fn new(options: &Options) -> Result<Self, Failure> {
        let writes = !options.no_save && options.pixel.is_none();
        let picture = if writes { picture(options)? } else { Output::nowhere() };
        let picture = encoded(picture, options)?;
        let stats = options.stats.clone();
        let to_stdout = picture.target == Some(brt::Target::Stdout);
        if to_stdout && stats.as_deref().is_some_and(is_dash) {
            return Err(wrong_use("the picture and its statistics cannot both go to standard output"));
        }
        let targets = Self { picture, stats };
        check_distinct(&options.scene, &targets.files())?;
        Ok(targets)
    }

    /// All files that will be written.
    pub(super) fn files(&self) -> Vec<PathBuf> {
        let mut files = self.picture.files();
        files.extend(self.stats.iter().filter(|path| !is_dash(path)).cloned());
        files
    }
}

fn picture(options: &Options) -> Result<Output, Failure> {
    let path = options.output.clone().or_else(|| options.out.clone());
    let path = path.unwrap_or_else(|| default_path(&options.scene));
    if is_dash(&path) {
        return to_stdout(options);
    }
    Output::to_file(&path).map_err(|error| wrong_use(error.to_string()))
}

fn encoded(mut output: Output, options: &Options) -> Result<Output, Failure> {
    if options.bits.is_some() && output.encoding.format == PictureFormat::Exr {
        return Err(wrong_use("`--bits` belongs to .png and .ppm; .exr has 32-bit floats"));
    }
    if options.compression.is_some() && output.encoding.format != PictureFormat::Png {
        return Err(wrong_use("`--compression` belongs to .png"));
    }
    let has_alpha = options.view.backdrop().has_alpha();
    if has_alpha && !output.encoding.format.has_alpha() {
        let format = output.encoding.format.extension();
        return Err(wrong_use(format!(".{format} cannot hold a transparent background; .png and .exr can")));
    }
    output.encoding.channels = if has_alpha { Channels::Rgba } else { Channels::Rgb };
    output.encoding.compression = options.compression.map_or_else(Default::default, Into::into);
    output.encoding.depth = options.bits.unwrap_or_default();
    output.encoding.transfer = if options.linear { Transfer::Linear } else { Transfer::Srgb };
    for &layer in &options.layers {
        if !output.layers.contains(&layer) {
            output.layers.push(layer);
        }
    }
    Ok(output)
}

fn to_stdout(options: &Options) -> Result<Output, Failure> {
    if io::stdout().is_terminal() {
        return Err(wrong_use("standard output is a terminal, expected a pipe or a file for the PNG"));
    }
    text_file::check_stdout()?;
    if !options.layers.is_empty() {
        return Err(wrong_use("`--layers` writes files beside the picture, which goes to standard output"));
    }
    Ok(Output::to_stdout())
}

/// The scene's name with `.png`, in the current folder.
fn default_path(scene: &Path) -> PathBuf {
    let stem = scene.file_stem().filter(|_| !is_dash(scene));
    let mut name = stem.map_or_else(|| "scene".into(), std::ffi::OsStr::to_os_string);
    name.push(".png");
    name.into()
}

/// Refuses pictures that are too large.
pub(super) fn check_size([width, height]: [u32; 2], max_pixels: u64) -> anyhow::Result<()> {
    if u64::from(width) * u64::from(height) > max_pixels {
        bail!("a picture of {width}×{height} has more than {max_pixels} pixels (`--max-pixels` allows more)");
    }
    if width > GREATEST_SIDE || height > GREATEST_SIDE {
        bail!("a picture of {width}×{height}: each side may have up to {GREATEST_SIDE} pixels");
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictures_are_named_after_scenes() {
        assert_eq!(default_path(Path::new("a/b.toml")), Path::new("b.png"));
        assert_eq!(default_path(Path::new("-")), Path::new("scene.png"));
    }

    #[test]
    fn sizes_do_not_overflow() {
        assert!(check_size([u32::MAX, u32::MAX], 1 << 34).is_err());
        assert!(check_size([u32::MAX, 1], 1 << 34).is_err());
        assert!(check_size([1 << 17, 1 << 17], 1 << 34).is_ok());
    }
}
