//! All integration tests of the crate in one program: each would be linked with everything else.

mod beside;
mod common;
mod corpus;
mod load;
mod memory;
mod models;
mod nff;
mod robustness;
mod round_trip;
mod scene_format_document;
mod seed_scenes;
mod textures;
mod toml_errors;
mod unseen_textures;
mod write;
