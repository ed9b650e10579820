//! PLY (Turk 1994): points with attributes, and faces of any number of points.
//!
//! Read by the `ply-rs-bw` crate. Colours are sRGB: codes from 0 to 255, or numbers from 0 to 1. Texture coordinates
//! count from the picture's lower left corner; `comment TextureFile NAME` names it. +z is up.
//!
//! Files that `write` makes hold a mesh of ours bit by bit: their comment says so, and nothing is changed.

mod body;
mod element;
mod header;

use std::borrow::Cow;

use brt_geometry::{Vec3, vec3};
use brt_image::Rgb;
use brt_scene::framing::Up;
use brt_scene::{Material, Texture};
use ply_rs_bw::ply::{ElementDef, Header};

use super::sniff::text;
use super::{FileReader, Importer, Likeness};
use crate::common::{EXACT_PLY, Format, counted_points, excerpt};
use crate::import::{Beside, CREASE_DEG, Crease, Draft, Geometry, Pictures, Stop, fan_or_cut, fault};
use body::Body;
use element::{Face, Ignored, Vertex};

/// What there is to know of the format.
pub(super) const IMPORTER: Importer = Importer {
    format: Format::Ply,
    sniff: |bytes| {
        Likeness::Mark.only_if([&b"ply\n"[..], b"ply\r"].iter().any(|start| text(bytes).starts_with(start)))
    },
    reader: FileReader::Model { up: |_| Up::PlusZ, read, is_for_scenes: true },
};

/// Reads a file into a model.
fn read<'b>(bytes: &'b [u8], beside: &mut Beside<'b>, draft: &mut Draft<'b>) -> Result<(), Stop> {
    let (header, vertices, faces) = read_elements(bytes, draft)?;
    if faces.is_empty() && !vertices.is_empty() {
        return Err(fault("points without faces are not shown", None));
    }
    let geometry = geometry_of(&vertices, &faces, &header, draft)?;
    drop((vertices, faces));
    let material = match texture(&header, &geometry, beside, draft) {
        Some(texture) => {
            let white = Material::matte("textured", Rgb::WHITE);
            draft.add_material(Material { texture: Some(texture), ..white })?
        }
        None => draft.plain(),
    };
    let smooth = geometry.normals.is_empty() && !is_exact(&header);
    let crease = smooth.then(|| Crease::new(CREASE_DEG));
    Ok(draft.add_geometry(geometry, crease.as_ref(), material, None)?)
}

fn read_elements(bytes: &[u8], draft: &mut Draft) -> Result<(Header, Vec<Vertex>, Vec<Face>), Stop> {
    let (header, start) = header::read(bytes)?;
    check_counts(&header, bytes.len(), draft)?;
    let mut body = Body::new(bytes, start, header.encoding);
    let (mut vertices, mut faces) = (Vec::new(), Vec::new());
    for (name, element) in &header.elements {
        match name.as_str() {
            "vertex" => vertices = body.elements::<Vertex>(element, draft.budget)?,
            "face" => faces = body.elements::<Face>(element, draft.budget)?,
            _ => {
                draft.notices.note_many(
                    &format!("elements `{name}` ignored"),
                    element.count as u64,
                    name.clone(),
                );
                body.elements::<Ignored>(element, draft.budget)?;
            }
        }
    }
    Ok((header, vertices, faces))
}

/// Was it written by us, as it is in our scene?
fn is_exact(header: &Header) -> bool {
    header.comments.iter().any(|comment| comment.trim() == EXACT_PLY)
}

/// The picture that the file names, if its points lie in one.
fn texture(header: &Header, geometry: &Geometry, beside: &mut Beside, draft: &mut Draft) -> Option<Texture> {
    if draft.is_bare() {
        return None;
    }
    let named = header.comments.iter().find_map(|comment| comment.trim().strip_prefix("TextureFile"));
    let name = match named.map(str::trim).filter(|name| !name.is_empty()) {
        Some(name) if geometry.texcoords.is_empty() => {
            draft
                .notices
                .say(&format!("the picture `{}` ignored: points have no place in it", excerpt(name)));
            return None;
        }
        Some(name) => name,
        None if geometry.texcoords.is_empty() => return None,
        None => {
            draft.notices.say("texture coordinates ignored: the file names no picture");
            return None;
        }
    };
    match Pictures::new(draft.budget).get(name, || beside.read(name).map(Cow::Owned)) {
        Ok(picture) => Some(Texture::new(picture)),
        Err(why) => {
            draft.notices.say(&format!("the picture `{}` cannot be read: {why}", excerpt(name)));
            None
        }
    }
}

/// An element takes at least a byte, unless it has no properties, which would be read for ever.
fn check_counts(header: &Header, bytes: usize, draft: &mut Draft) -> Result<(), Stop> {
    for (name, ElementDef { count, .. }) in &header.elements {
        if *count > bytes {
            return Err(fault(format!("{count} elements `{name}` in a file of {bytes} bytes"), None));
        }
    }
    let count = |name: &str| header.elements.get(name).map_or(0, |element| element.count);
    Ok(draft.expect(count("vertex"), count("face"))?)
}

fn geometry_of(
    vertices: &[Vertex],
    faces: &[Face],
    header: &Header,
    draft: &mut Draft,
) -> Result<Geometry, Stop> {
    let mut geometry = Geometry::default();
    let has = |name: &str| header.elements.get("vertex").is_some_and(|v| v.properties.contains_key(name));
    for name in ["x", "y", "z"] {
        if !has(name) {
            return Err(fault(format!("points have no `{name}`"), None));
        }
    }
    geometry.positions = vertices.iter().map(|v| Vec3::from(v.position)).collect();
    if has("nx") && has("ny") && has("nz") {
        geometry.normals = vertices.iter().map(|v| vec3(v.normal[0], v.normal[1], v.normal[2])).collect();
    }
    if has("red") && has("green") && has("blue") {
        let color = if is_exact(header) { Vertex::light } else { Vertex::color };
        geometry.colors = vertices.iter().map(color).collect();
    }
    if [["s", "t"], ["u", "v"], ["texture_u", "texture_v"]]
        .iter()
        .any(|pair| pair.iter().all(|name| has(name)))
    {
        let downwards = |v: f64| if is_exact(header) { v } else { 1.0 - v };
        geometry.texcoords = vertices.iter().map(|v| [v.texcoord[0], downwards(v.texcoord[1])]).collect();
        if !is_exact(header) && geometry.drop_wild_texcoords() {
            draft.notices.say("texture coordinates that are no numbers ignored");
        }
    }
    if header.elements.get("face").is_some_and(|face| face.properties.contains_key("texcoord")) {
        draft.notices.say("texture coordinates of faces ignored: only those of points are read");
    }
    let mut points = Vec::new();
    for (i, face) in faces.iter().enumerate() {
        points.clear();
        for &index in &face.indices {
            match usize::try_from(index).ok().and_then(|index| geometry.positions.get(index)) {
                Some(&p) => points.push(p),
                None => {
                    let message = format!(
                        "face {i} uses point {index}, but the file has {}",
                        counted_points(vertices.len())
                    );
                    return Err(fault(message, None));
                }
            }
        }
        let cut = fan_or_cut(&points);
        // One for each face is expected already.
        draft.expect(0, cut.len().saturating_sub(1))?;
        geometry.triangles.extend(cut.iter().map(|t| t.map(|k| face.indices[k as usize] as u32)));
    }
    Ok(geometry)
}
