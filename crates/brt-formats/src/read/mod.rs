//! All formats that are read: a folder each, and a line in [`IMPORTERS`].

mod gltf;
mod importer;
mod meshes;
mod nff;
mod obj;
mod off;
mod ply;
mod sniff;
mod stl;
mod threemf;
mod toml;
mod vrml;

pub(crate) use importer::{FileReader, Importer, check_content, read};
pub(crate) use sniff::{Likeness, format_of, sure_format};

/// Every importer.
const IMPORTERS: [&Importer; 9] = [
    &toml::IMPORTER,
    &nff::IMPORTER,
    &stl::IMPORTER,
    &ply::IMPORTER,
    &off::IMPORTER,
    &obj::IMPORTER,
    &gltf::IMPORTER,
    &threemf::IMPORTER,
    &vrml::IMPORTER,
];
