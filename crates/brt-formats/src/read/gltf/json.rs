//! The JSON, and what is wrong with it in plain words.

use gltf::Document;
use gltf::json::validation::Error as Invalid;
use gltf::json::{Error, Path, Root, Value};

use brt_scene::Diagnostic;

use super::container::Json;
use super::words;
use crate::common::excerpt;
use crate::import::{Stop, fault};

/// The document, with all that it refers to.
pub(super) fn document(json: Json) -> Result<Document, Stop> {
    let root = root(json)?;
    check_version(Some(&root.asset.version), root.asset.min_version.as_deref())?;
    check_positions(&root)?;
    Document::from_json(root).map_err(|error| match error {
        gltf::Error::Validation(errors) => invalid(&errors, json),
        error => fault(error.to_string(), None),
    })
}

fn root(json: Json) -> Result<Root, Stop> {
    gltf::json::deserialize::from_slice(json.text).map_err(|error| {
        // An older glTF has other tables: its version says more than the first of them.
        let asset = value(json).map(|mut root| root["asset"].take()).unwrap_or_default();
        let version = |name: &str| asset.get(name).and_then(Value::as_str);
        match check_version(version("version"), version("minVersion")) {
            Ok(()) => broken(&error, json),
            Err(stop) => stop,
        }
    })
}

fn value(json: Json) -> Option<Value> {
    gltf::json::deserialize::from_slice(json.text).ok()
}

/// Versions 2.x can be read, as far as they can be read by those who know 2.0.
fn check_version(version: Option<&str>, least: Option<&str>) -> Result<(), Stop> {
    let number = |text: &str| {
        let (major, minor) = text.split_once('.')?;
        Some((major.parse::<u32>().ok()?, minor.parse::<u32>().ok()?))
    };
    let is_other = |text: &&str| number(text).is_none_or(|(major, _)| major != 2);
    let is_newer = |text: &&str| number(text).is_none_or(|needed| needed > (2, 0));
    match version.filter(is_other).or(least.filter(is_newer)) {
        Some(other) => {
            Err(Diagnostic::error(format!("glTF {}", excerpt(other)), None).expecting("2.0").into())
        }
        None => Ok(()),
    }
}

/// The crate's validation looks positions up before it knows that they exist.
fn check_positions(root: &Root) -> Result<(), Stop> {
    let primitives =
        root.meshes.iter().enumerate().flat_map(|(i, mesh)| mesh.primitives.iter().map(move |p| (i, p)));
    for (i, primitive) in primitives {
        if let Some(accessor) = primitive.attributes.values().find(|a| a.value() >= root.accessors.len()) {
            return Err(fault(
                format!("mesh {i} names accessor {}, which does not exist", accessor.value()),
                None,
            ));
        }
    }
    Ok(())
}

/// What keeps the JSON from being read, drawn over the file where that is text.
fn broken(error: &Error, json: Json) -> Stop {
    let text = error.to_string();
    let position = format!(" at line {} column {}", error.line(), error.column());
    let place = words::place(json.text, error.line(), error.column());
    let (message, expected) = words::plain(text.trim_end_matches(&position), &json.text[place.clone()]);
    let mut diagnostic = match json.start {
        Some(start) => Diagnostic::error(message, Some(start + place.start..start + place.end)),
        None => Diagnostic::error(format!("{message}, at byte {} of its JSON", place.start), None),
    };
    diagnostic.expected = expected;
    diagnostic.into()
}

/// The first of the properties that are wrong by themselves.
fn invalid(errors: &[(Path, Invalid)], json: Json) -> Stop {
    let Some((path, error)) = errors.first() else { return fault("not valid", None) };
    let more = if errors.len() > 1 { format!(" (and {} more)", errors.len() - 1) } else { String::new() };
    let found = value(json).and_then(|root| root.pointer(&pointer(path.as_str())).cloned());
    let found = found.map_or_else(|| "of this file".to_owned(), |value| excerpt(&value.to_string()));
    let what = match error {
        Invalid::IndexOutOfBounds => format!("refers to {found}, which does not exist"),
        Invalid::Invalid => format!("is {found}, which is not valid"),
        Invalid::Missing => "is missing".to_owned(),
        Invalid::Oversize => format!("is {found}, which is too much for this machine"),
        Invalid::Unsupported => format!("is {found}, which cannot be read"),
    };
    fault(format!("`{path}` {what}{more}"), None)
}

/// `nodes[1].mesh` as a JSON pointer.
fn pointer(path: &str) -> String {
    let parts = path.split(['.', '[', ']', '"']).filter(|part| !part.is_empty());
    parts.map(|part| format!("/{part}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_lead_to_values() {
        assert_eq!(pointer("nodes[1].mesh"), "/nodes/1/mesh");
        assert_eq!(
            pointer("meshes[0].primitives[2].attributes[\"POSITION\"]"),
            "/meshes/0/primitives/2/attributes/POSITION"
        );
    }

    #[test]
    fn versions_are_2_or_say_that_2_is_enough() {
        for (version, least, is_read) in [
            ("2.0", None, true),
            ("2.1", None, true),
            ("2.1", Some("2.0"), true),
            ("2.1", Some("2.1"), false),
            ("1.0", None, false),
            ("3.0", None, false),
            ("two", None, false),
        ] {
            assert_eq!(check_version(Some(version), least).is_ok(), is_read, "{version} {least:?}");
        }
    }
}
