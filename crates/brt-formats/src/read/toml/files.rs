//! Files that a scene names: pictures and meshes, each read once.

use std::borrow::Cow;
use std::collections::HashMap;
use std::sync::Arc;

use base64::Engine as _;
use brt_scene::{Diagnostic, Mesh, Texels};

use super::value::{Value, error, text};
use crate::common::{Budget, Problems, excerpt};
use crate::import::{Beside, Meshes, Pictures};
use crate::read::meshes;

/// The files beside a scene.
pub(super) struct Files<'f, 'b> {
    beside: &'f mut Beside<'b>,
    budget: &'f Budget<'f>,
    pictures: Pictures<'f>,
    meshes: HashMap<String, Result<Vec<Arc<Mesh>>, String>>,
}

impl<'f, 'b> Files<'f, 'b> {
    pub(super) fn new(beside: &'f mut Beside<'b>, budget: &'f Budget<'f>) -> Self {
        Self { beside, budget, pictures: Pictures::new(budget), meshes: HashMap::new() }
    }

    /// The picture in a file.
    pub(super) fn picture(&mut self, value: &Value) -> Result<Arc<Texels>, Diagnostic> {
        let name = text(value)?;
        let beside = &mut *self.beside;
        self.pictures
            .get(&name, || beside.read(&name).map(Cow::Owned))
            .map_err(|why| unreadable(&name, &why, value, "a PNG or JPEG file in the scene's folder"))
    }

    /// A picture that stands in the scene itself. Files of its name are no longer looked for.
    pub(super) fn inline_picture(&mut self, value: &Value, name: &str) -> Result<Arc<Texels>, Diagnostic> {
        const EXPECTED: &str = "a PNG or JPEG file in base64";
        let data = value.get_ref().as_str().unwrap_or_default();
        let bytes = base64::engine::general_purpose::STANDARD
            .decode(data.trim())
            .map_err(|why| error(format!("this is not base64: {why}"), value, EXPECTED))?;
        self.pictures.forget(name);
        self.pictures
            .get(name, || Ok(Cow::Owned(bytes)))
            .map_err(|why| error(format!("the picture cannot be read: {why}"), value, EXPECTED))
    }

    /// The meshes in a file.
    pub(super) fn meshes(
        &mut self,
        value: &Value,
        problems: &mut Problems,
    ) -> Result<Vec<Arc<Mesh>>, Diagnostic> {
        let name = text(value)?;
        if !self.meshes.contains_key(&name) {
            let read = self.read_meshes(&name, value, problems);
            self.meshes.insert(name.clone(), read);
        }
        let known = self.meshes.get(&name).cloned().unwrap_or_else(|| Ok(Vec::new()));
        known.map_err(|why| {
            unreadable(&name, &why, value, "a PLY, STL, OBJ or OFF file in the scene's folder")
        })
    }

    fn read_meshes(
        &mut self,
        name: &str,
        value: &Value,
        problems: &mut Problems,
    ) -> Result<Vec<Arc<Mesh>>, String> {
        let bytes = self.beside.read(name)?;
        let Meshes { meshes, report } = meshes::read(name, &bytes, self.budget)?;
        if meshes.is_empty() {
            return Err("there is nothing to see in it".to_owned());
        }
        for warning in report.diagnostics {
            let message = format!("in `{}`: {}", excerpt(name), warning.message);
            problems.push(Diagnostic::warning(message, Some(value.span())));
        }
        Ok(meshes)
    }
}

fn unreadable(name: &str, why: &str, value: &Value, expected: &str) -> Diagnostic {
    error(format!("`{}` cannot be read: {why}", excerpt(name)), value, expected)
}
