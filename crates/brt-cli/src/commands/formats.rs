//! `brt formats`: what can be read and written.

use brt::formats::Foreign;
use brt::{Format, PictureFormat};

use crate::exit::{Failure, Outcome};
use crate::output;

/// Lists the formats.
pub(crate) fn run() -> Result<Outcome, Failure> {
    output::line("scenes")?;
    for format in Format::ALL {
        let extensions = format.extensions().join(", .");
        output::line(&row(&format!(".{extensions}"), abilities(format), format.name()))?;
    }
    output::line("\nknown, but not read")?;
    for foreign in Foreign::ALL {
        output::line(&format!("  {:<21} {}", foreign.name, foreign.advice))?;
    }
    output::line("\npictures")?;
    for (format, name) in [
        (PictureFormat::Png, "Portable Network Graphics, 8 or 16 bits"),
        (PictureFormat::Ppm, "portable pixmap, 8 or 16 bits"),
        (PictureFormat::Exr, "OpenEXR, 32-bit floats, layers inside"),
    ] {
        output::line(&row(&format!(".{}", format.extension()), "read, write", name))?;
    }
    Ok(Outcome::Done)
}

fn row(extensions: &str, abilities: &str, name: &str) -> String {
    format!("  {extensions:<12} {abilities:<12} {name}")
}

fn abilities(format: Format) -> &'static str {
    match (format.reads(), format.writes()) {
        (true, true) => "read, write",
        (true, false) => "read",
        (false, true) => "write",
        (false, false) => "",
    }
}
