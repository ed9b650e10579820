//! All formats that are read: a folder each, and a line in [`IMPORTERS`].

#[cfg(feature = "gltf")]
mod gltf;
mod importer;
mod meshes;
mod nff;
mod obj;
mod off;
#[cfg(feature = "ply")]
mod ply;
mod sniff;
mod stl;
#[cfg(feature = "threemf")]
mod threemf;
mod toml;
mod vrml;

pub(crate) use importer::{FileReader, Importer, check_content, read};
pub(crate) use sniff::{Likeness, format_of, sure_format};

/// Every importer.
const IMPORTERS: &[&Importer] = &[
    &toml::IMPORTER,
    &nff::IMPORTER,
    &stl::IMPORTER,
    #[cfg(feature = "ply")]
    &ply::IMPORTER,
    &off::IMPORTER,
    &obj::IMPORTER,
    #[cfg(feature = "gltf")]
    &gltf::IMPORTER,
    #[cfg(feature = "threemf")]
    &threemf::IMPORTER,
    &vrml::IMPORTER,
];
