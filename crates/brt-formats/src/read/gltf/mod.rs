//! glTF 2.0 (Khronos), as JSON with files beside it or as one binary file (GLB).
//!
//! JSON and its cross references are read and validated by the `gltf` crate; what buffers hold is read here, since the
//! crate's iterators trust them. Nodes that have the same mesh share it. +y is up.
//!
//! Metallic and rough surfaces become Whitted's model (`material.rs`), with the pictures of their base colours. Other
//! pictures, skins, morph targets, animations and lines are ignored and reported.

mod accessor;
mod buffers;
mod container;
mod json;
mod light;
mod material;
mod mesh;
mod nodes;
mod texture;
mod words;

use std::collections::BTreeMap;

use brt_scene::framing::Up;
use gltf::Document;

use super::sniff::text;
use super::{FileReader, Importer, Likeness};
use crate::common::{Budget, Cost, Format, Halt};
use crate::import::{Beside, Draft, Stop};
use texture::Textures;

/// What there is to know of the format.
pub(super) const IMPORTER: Importer = Importer {
    format: Format::Gltf,
    sniff: |bytes| Likeness::Mark.only_if(bytes.starts_with(b"glTF") || names_asset(text(bytes))),
    reader: FileReader::Model { up: |_| Up::PlusY, read, is_for_scenes: false },
};

/// Any program may write JSON; that of glTF must have this property.
fn names_asset(json: &[u8]) -> bool {
    const ASSET: &[u8] = b"\"asset\"";
    json.starts_with(b"{") && json.windows(ASSET.len()).any(|window| window == ASSET)
}

/// Reads a file into a model.
fn read<'b>(bytes: &'b [u8], beside: &mut Beside<'b>, draft: &mut Draft<'b>) -> Result<(), Stop> {
    let (json, binary) = container::parts(bytes)?;
    spend_json(json.text, draft.budget)?;
    let document = json::document(json)?;
    note_ignored(&document, draft);
    leave_pictures(&document, beside);
    let buffers = buffers::read(&document, binary, beside)?;
    let mut textures = Textures::new(&document, &buffers, beside, draft.budget);
    let surfaces = material::read(&document, &mut textures, draft)?;
    nodes::add(&document, &buffers, &surfaces, draft)
}

/// What the JSON costs as values: an empty node is three bytes in the file.
fn spend_json(json: &[u8], budget: &Budget) -> Result<(), Halt> {
    let count = |marks: &[u8]| json.iter().filter(|byte| marks.contains(byte)).count() as u64;
    budget.spend(Cost::Node, count(b"{"))?;
    budget.spend(Cost::Word, count(b"[,"))
}

/// Not all pictures are read; all belong to the scene.
fn leave_pictures(document: &Document, beside: &mut Beside) {
    let files = document.as_json().images.iter().filter_map(|image| image.uri.as_deref());
    files.filter(|uri| !uri.starts_with("data:")).for_each(|uri| beside.leave(&buffers::decoded(uri)));
}

fn note_ignored(document: &Document, draft: &mut Draft) {
    /// What is read here or changes nothing that is seen.
    const KNOWN: [&str; 7] = [
        "KHR_lights_punctual",
        "KHR_materials_emissive_strength",
        "KHR_materials_ior",
        "KHR_materials_transmission",
        "KHR_materials_unlit",
        "KHR_texture_transform",
        "KHR_mesh_quantization",
    ];
    let animations = document.animations().count() as u64;
    draft.notices.note_many("animations ignored", animations, "animation 0".to_owned());
    let skins = document.skins().count() as u64;
    draft.notices.note_many(
        "skins ignored: the mesh is shown in its unposed shape",
        skins,
        "skin 0".to_owned(),
    );
    let mut extensions: BTreeMap<String, (u64, usize)> = BTreeMap::new();
    for (i, material) in document.materials().enumerate() {
        for name in material.extensions().into_iter().flat_map(|map| map.keys()) {
            extensions.entry(name.clone()).or_insert((0, i)).0 += 1;
        }
        if material.volume().is_some_and(|volume| volume.attenuation_distance().is_finite()) {
            extensions.entry("attenuation of KHR_materials_volume".to_owned()).or_insert((0, i)).0 += 1;
        }
    }
    for (name, (count, first)) in extensions {
        draft.notices.note_many(&format!("{name} ignored"), count, format!("material {first}"));
    }
    for name in document.extensions_used().filter(|name| !KNOWN.contains(name)) {
        if !name.starts_with("KHR_materials") {
            draft.notices.say(&format!("{name} ignored"));
        }
    }
}
