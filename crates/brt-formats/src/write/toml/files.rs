//! Large meshes and pictures of a scene in files of their own, beside it.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use brt_scene::{Mesh, Scene, Texels};

use super::Writer;
use super::texture::png;
use crate::write::{FileBeside, ply};

/// A mesh of as many triangles is better kept out of a text that people edit.
const LARGE: usize = 1000;

/// The scene as text, and the files that it names. Their names start with `stem`; a picture that `lies_there` already
/// is named as it is.
pub(crate) fn write_beside(
    scene: &Scene,
    stem: &str,
    lies_there: &dyn Fn(&Texels) -> bool,
) -> (String, Vec<FileBeside>) {
    let beside =
        Outside { stem, lies_there, files: Vec::new(), taken: HashSet::new(), names: HashMap::new() };
    let mut out = Writer { outside: Some(beside), ..Writer::default() };
    out.scene(scene);
    (out.text, out.outside.map_or_else(Vec::new, |outside| outside.files))
}

/// The files beside a scene under construction.
pub(in crate::write) struct Outside<'w> {
    stem: &'w str,
    lies_there: &'w dyn Fn(&Texels) -> bool,
    files: Vec<FileBeside>,
    /// In lower case: some systems do not tell `A` from `a`.
    taken: HashSet<String>,
    /// By place in memory.
    names: HashMap<*const (), String>,
}

impl Outside<'_> {
    /// The file of a mesh, if it is large.
    pub(super) fn mesh(&mut self, mesh: &Arc<Mesh>, name: Option<&str>) -> Option<String> {
        if !is_large(mesh) {
            return None;
        }
        let place = Arc::as_ptr(mesh).cast::<()>();
        Some(self.file(place, name.unwrap_or("mesh"), "ply", || ply::write(mesh)))
    }

    /// The file of a picture.
    pub(super) fn picture(&mut self, texels: &Arc<Texels>) -> String {
        let place = Arc::as_ptr(texels).cast::<()>();
        if !self.names.contains_key(&place) && (self.lies_there)(texels) {
            self.names.insert(place, texels.name.clone());
        }
        let name = texels.name.rsplit(['/', '\\']).next().unwrap_or_default();
        let name = name.rsplit_once('.').map_or(name, |(name, _)| name);
        self.file(place, name, "png", || png(texels))
    }

    fn file(
        &mut self,
        place: *const (),
        name: &str,
        extension: &str,
        bytes: impl FnOnce() -> Vec<u8>,
    ) -> String {
        if let Some(known) = self.names.get(&place) {
            return known.clone();
        }
        let base = format!("{}.{}", self.stem, plain(name));
        let numbered = (2_u64..).map(|n| format!("{base}-{n}.{extension}"));
        let mut candidates = std::iter::once(format!("{base}.{extension}")).chain(numbered);
        let taken = &mut self.taken;
        let file = candidates.find(|file| taken.insert(file.to_lowercase())).unwrap_or_default();
        self.files.push(FileBeside { name: file.clone(), bytes: bytes() });
        self.names.insert(place, file.clone());
        file
    }
}

/// Is a mesh kept out of the text?
pub(super) fn is_large(mesh: &Mesh) -> bool {
    mesh.triangles.len() >= LARGE
}

/// A part of a file's name that all systems take.
fn plain(name: &str) -> String {
    const LONGEST: usize = 40;
    let kept = |c: char| if c.is_ascii_alphanumeric() || c == '_' { c } else { '-' };
    let name: String = name.chars().take(LONGEST).map(kept).collect();
    let name = name.trim_matches('-');
    if name.is_empty() { "part".to_owned() } else { name.to_owned() }
}
