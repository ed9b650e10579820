//! The zip file around the model.

use std::io::{BufRead, BufReader, Cursor, Read};

use zip::ZipArchive;
use zip::result::ZipError;

use crate::common::{Budget, Watched};
use crate::import::{Stop, fault};

/// Reads the model's XML while it is unpacked.
pub(super) fn read_model<T>(
    bytes: &[u8],
    budget: &Budget,
    read: impl FnOnce(&mut dyn BufRead) -> Result<T, Stop>,
) -> Result<T, Stop> {
    if !bytes.starts_with(b"PK") {
        return Err(fault("not a zip file, as a 3MF file is", None));
    }
    let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(|error| broken(&error))?;
    let name = model_name(&mut archive, budget)?;
    read_part(&mut archive, &name, budget, read)
}

/// The relations name the model; files of careless programs have it at the usual place.
fn model_name(archive: &mut ZipArchive<Cursor<&[u8]>>, budget: &Budget) -> Result<String, Stop> {
    let is_model = |name: &str| name.to_ascii_lowercase().ends_with(".model");
    /// Those that programs write have a few hundred bytes.
    const MOST_RELATIONS: u64 = 1 << 20;
    let mut text = String::new();
    let read = |part: &mut dyn BufRead| {
        part.take(MOST_RELATIONS).read_to_string(&mut text).map_err(|error| fault(error.to_string(), None))
    };
    if read_part(archive, "_rels/.rels", budget, read).is_ok() {
        let target = text
            .split("Target=\"")
            .skip(1)
            .filter_map(|rest| rest.split('"').next())
            .find(|name| is_model(name));
        let name = target.map(|target| target.trim_start_matches('/').to_owned());
        if let Some(name) = name.filter(|name| archive.index_for_name(name).is_some()) {
            return Ok(name);
        }
    }
    let found = archive
        .file_names()
        .filter_map(Result::ok)
        .map(std::borrow::Cow::into_owned)
        .find(|name| is_model(name));
    found.ok_or_else(|| fault("there is no model in this zip file", None))
}

/// Hands a part's content to a reader. What it says about its own size is not trusted, but may tell that it is too much.
fn read_part<T>(
    archive: &mut ZipArchive<Cursor<&[u8]>>,
    name: &str,
    budget: &Budget,
    read: impl FnOnce(&mut dyn BufRead) -> Result<T, Stop>,
) -> Result<T, Stop> {
    let part = archive.by_name(name).map_err(|error| broken(&error))?;
    let (packed, unpacked) = (part.compressed_size(), part.size());
    let mut watched = Watched::new(part, budget, name, packed);
    watched.allow(unpacked)?;
    let read = read(&mut BufReader::with_capacity(1 << 16, &mut watched));
    match watched.halt {
        Some(halt) => Err(halt.into()),
        None => read,
    }
}

fn broken(error: &ZipError) -> Stop {
    match error {
        ZipError::UnsupportedArchive(_) => fault(format!("not a zip file that can be read: {error}"), None),
        _ => fault("not a complete zip file: is it truncated?", None),
    }
}
