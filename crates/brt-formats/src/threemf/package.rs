//! The zip file around the model.

use std::io::{Cursor, Read};

use zip::ZipArchive;

use crate::import::{Stop, fault};
use crate::{LimitKind, Limits};

/// The model's XML. What a part says about its own size is not trusted: reading stops at the limit of bytes.
pub(super) fn model_part(bytes: &[u8], limits: &Limits) -> Result<Vec<u8>, Stop> {
    let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(|error| broken(&error))?;
    let name = model_name(&mut archive, limits)?;
    read_part(&mut archive, &name, limits)
}

/// The relations name the model; files of careless programs have it at the usual place.
fn model_name(archive: &mut ZipArchive<Cursor<&[u8]>>, limits: &Limits) -> Result<String, Stop> {
    let is_model = |name: &str| name.to_ascii_lowercase().ends_with(".model");
    if let Ok(relations) = read_part(archive, "_rels/.rels", limits) {
        let text = String::from_utf8_lossy(&relations);
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

fn read_part(archive: &mut ZipArchive<Cursor<&[u8]>>, name: &str, limits: &Limits) -> Result<Vec<u8>, Stop> {
    let part = archive.by_name(name).map_err(|error| broken(&error))?;
    let mut content = Vec::new();
    part.take(limits.bytes.saturating_add(1))
        .read_to_end(&mut content)
        .map_err(|error| fault(format!("`{name}` cannot be unpacked: {error}"), None))?;
    limits.allows(LimitKind::Bytes, content.len() as u64)?;
    Ok(content)
}

fn broken(error: &zip::result::ZipError) -> Stop {
    fault(format!("not a zip file that can be read: {error}"), None)
}
