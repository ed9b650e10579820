//! Wavefront OBJ with its materials.
//!
//! Not by a library: those that are kept (`tobj`) leave out smoothing groups and know no lines of errors. Faces of one
//! object, group and material are one mesh. Where the file gives no normals, its smoothing groups decide what is
//! smooth, and where it has none of those either, the angle. +y is up.

mod face;
mod map;
mod material;
mod reader;

use brt_scene::framing::Up;

use super::sniff::{first_line, words};
use super::{FileReader, Importer, Likeness};
use crate::common::Format;

/// What there is to know of the format.
pub(super) const IMPORTER: Importer = Importer {
    format: Format::Obj,
    sniff,
    reader: FileReader::Model { up: |_| Up::PlusY, read: reader::read, is_for_scenes: true },
};

/// A vertex has three numbers; in NFF `v` stands alone.
fn sniff(bytes: &[u8]) -> Likeness {
    const FIRST: [&[u8]; 6] = [b"vn", b"vt", b"o", b"g", b"mtllib", b"usemtl"];
    let mut words = words(first_line(bytes));
    let first = words.next().unwrap_or_default();
    Likeness::Line.only_if(FIRST.contains(&first) || (first == b"v" && words.next().is_some()))
}
