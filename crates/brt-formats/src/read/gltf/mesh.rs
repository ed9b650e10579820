//! Primitives of a mesh as triangles.

use brt_geometry::Vec3;
use brt_image::rgb;
use gltf::mesh::Mode;
use gltf::{Primitive, Semantic};

use super::accessor::{indices, rows};
use super::buffers::Buffers;
use crate::common::{Cost, counted_points};
use crate::import::{Draft, Geometry, Stop, fault};

/// The triangles of a primitive; `None` for what is none, which is said.
pub(super) fn geometry(
    primitive: &Primitive,
    texcoords: Option<u32>,
    place: &str,
    buffers: &Buffers,
    draft: &mut Draft,
) -> Result<Option<Geometry>, Stop> {
    if !matches!(primitive.mode(), Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan) {
        draft.notices.note("lines and points ignored", place.to_owned());
        return Ok(None);
    }
    let Some(positions) = primitive.get(&Semantic::Positions) else {
        draft.notices.note("mesh without positions ignored", place.to_owned());
        return Ok(None);
    };
    let count = positions.count();
    draft.expect(count, 0)?;
    if primitive.morph_targets().next().is_some() {
        draft.notices.note("morph targets ignored", place.to_owned());
    }
    let vectors = |list: Vec<[f64; 3]>| list.into_iter().map(Vec3::from).collect::<Vec<Vec3>>();
    let mut geometry =
        Geometry { positions: vectors(rows::<3>(&positions, buffers)?), ..Geometry::default() };
    if let Some(normals) = primitive.get(&Semantic::Normals).filter(|a| a.count() == count) {
        geometry.normals = vectors(rows::<3>(&normals, buffers)?);
    }
    if let Some(colors) = primitive.get(&Semantic::Colors(0)).filter(|a| a.count() == count) {
        let colors = rows::<3>(&colors, buffers)?;
        geometry.colors = colors
            .into_iter()
            .map(|c| c.map(|x| if x.is_finite() { x.clamp(0.0, 1.0) } else { 0.0 }))
            .map(|[r, g, b]| rgb(r, g, b))
            .collect();
    }
    if let Some(set) = texcoords {
        read_texcoords(&mut geometry, primitive, set, place, buffers, draft)?;
    }
    let corners = match primitive.indices() {
        Some(accessor) => {
            draft.expect(0, triangle_count(primitive.mode(), accessor.count()))?;
            indices(&accessor, buffers)?
        }
        None => {
            draft.expect(0, triangle_count(primitive.mode(), count))?;
            (0..count as u32).collect()
        }
    };
    if let Some(i) = corners.iter().find(|&&i| i as usize >= count) {
        return Err(fault(format!("{place} uses point {i}, but it has {}", counted_points(count)), None));
    }
    geometry.triangles = triangles(primitive.mode(), &corners);
    Ok(Some(geometry))
}

fn read_texcoords(
    geometry: &mut Geometry,
    primitive: &Primitive,
    set: u32,
    place: &str,
    buffers: &Buffers,
    draft: &mut Draft,
) -> Result<(), Stop> {
    let accessor = primitive.get(&Semantic::TexCoords(set));
    let Some(accessor) = accessor.filter(|a| a.count() == geometry.positions.len()) else {
        draft.notices.note("mesh without the coordinates of its texture", place.to_owned());
        return Ok(());
    };
    geometry.texcoords = rows::<2>(&accessor, buffers)?;
    if geometry.drop_wild_texcoords() {
        draft.notices.note("texture coordinates that are no numbers ignored", place.to_owned());
    }
    Ok(())
}

fn triangle_count(mode: Mode, corners: usize) -> usize {
    if mode == Mode::Triangles { corners / 3 } else { corners.saturating_sub(2) }
}

/// What a primitive costs once it is shown.
pub(super) fn bytes(primitive: &Primitive) -> u64 {
    let points = primitive.get(&Semantic::Positions).map_or(0, |accessor| accessor.count());
    let corners = primitive.indices().map_or(points, |accessor| accessor.count());
    let triangles = triangle_count(primitive.mode(), corners) as u64;
    Cost::Use.bytes().saturating_add(triangles.saturating_mul(Cost::Triangle.bytes()))
}

fn triangles(mode: Mode, corners: &[u32]) -> Vec<[u32; 3]> {
    match mode {
        Mode::TriangleStrip => {
            let ordered =
                |(i, w): (usize, &[u32])| if i % 2 == 0 { [w[0], w[1], w[2]] } else { [w[1], w[0], w[2]] };
            corners.windows(3).enumerate().map(ordered).collect()
        }
        Mode::TriangleFan => {
            let Some((&first, rest)) = corners.split_first() else { return Vec::new() };
            rest.windows(2).map(|w| [first, w[0], w[1]]).collect()
        }
        _ => corners.chunks_exact(3).map(|t| [t[0], t[1], t[2]]).collect(),
    }
}
