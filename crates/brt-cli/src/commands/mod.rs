//! The subcommands.

pub(crate) mod compare;
pub(crate) mod convert;
pub(crate) mod formats;
pub(crate) mod inspect;
pub(crate) mod paper;
pub(crate) mod peers;
pub(crate) mod render;
pub(crate) mod scene;
mod scene_files;
pub(crate) mod shell;
mod text_file;
