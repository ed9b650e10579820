//! Object File Format (Geomview): `OFF`, counts, points, faces, colours.
//!
//! Colours of points (`COFF`) and of faces are linear from 0 to 1 if they have a point, else from 0 to 255 in sRGB.
//! +z is up.

use brt_geometry::Vec3;
use brt_image::{Rgb, rgb};
use brt_scene::framing::Up;
use brt_scene::{Material, MaterialId};

use super::sniff::text;
use super::{FileReader, Importer, Likeness};
use crate::common::{Format, Word, Words, counted_points};
use crate::import::{Beside, CREASE_DEG, Crease, Draft, Geometry, Stop, fan_or_cut, fault, srgb};

/// What the first word says about the points.
struct Kind {
    normals: bool,
    colors: bool,
}

/// What there is to know of the format.
pub(super) const IMPORTER: Importer = Importer {
    format: Format::Off,
    sniff: |bytes| {
        Likeness::Start
            .only_if([&b"OFF"[..], b"COFF", b"NOFF"].iter().any(|start| text(bytes).starts_with(start)))
    },
    reader: FileReader::Model { up: |_| Up::PlusZ, read, is_for_scenes: true },
};

/// Reads a file into a model.
fn read<'b>(bytes: &'b [u8], _: &mut Beside<'b>, draft: &mut Draft<'b>) -> Result<(), Stop> {
    let mut words = Words::new(bytes);
    let kind = read_kind(&mut words)?;
    let mut count = |what| words.whole(what);
    let points = count("the number of points")?;
    let faces = count("the number of faces")?;
    count("the number of edges")?;
    draft.expect(points as usize, faces as usize)?;
    let mut geometry = Geometry::default();
    for _ in 0..points {
        draft.budget.go_on()?;
        geometry.positions.push(words.vector("a point, `x y z`")?);
        if kind.normals {
            geometry.normals.push(words.vector("the point's normal, `x y z`")?);
        }
        if kind.colors {
            let numbers: Vec<Word> = std::iter::from_fn(|| words.next_on_line()).take(4).collect();
            geometry.colors.push(color_of(&numbers).unwrap_or(rgb(0.5, 0.5, 0.5)));
        } else {
            words.skip_line();
        }
    }
    let faces = read_faces(&mut words, faces, &geometry.positions, draft)?;
    add_faces(&geometry, faces, draft)
}

fn read_kind(words: &mut Words) -> Result<Kind, Stop> {
    let Some(first) = words.peek() else {
        return Err(fault("the file holds nothing but comments", None));
    };
    let name = String::from_utf8_lossy(first.bytes).to_ascii_uppercase();
    match name.as_str() {
        "OFF" | "COFF" | "NOFF" | "CNOFF" | "STOFF" => {
            words.next();
        }
        // The word may be left out.
        _ if first.is_number() => {}
        _ => {
            let message = format!("found `{}`, expected `OFF`", first.excerpt());
            return Err(fault(message, Some(first.span)));
        }
    }
    Ok(Kind { normals: name.contains('N'), colors: name.starts_with('C') })
}

/// Triangles of the faces and the colour of each, if it has one.
type Faces = Vec<([u32; 3], Option<[u8; 3]>)>;

fn read_faces(words: &mut Words, count: u32, positions: &[Vec3], draft: &mut Draft) -> Result<Faces, Stop> {
    let mut triangles = Vec::new();
    let mut corners = Vec::new();
    for _ in 0..count {
        let start = words.peek().map(|word| word.span);
        let n = words.whole("a face, the number of its points and their indices")?;
        corners.clear();
        for _ in 0..n {
            let i = words.whole("the index of a point")?;
            if i as usize >= positions.len() {
                let message =
                    format!("a face uses point {i}, but the file has {}", counted_points(positions.len()));
                return Err(fault(message, start));
            }
            corners.push(i);
        }
        let numbers: Vec<Word> = std::iter::from_fn(|| words.next_on_line()).take(5).collect();
        let color = color_of(&numbers).map(codes);
        let points: Vec<Vec3> = corners.iter().map(|&i| positions[i as usize]).collect();
        let cut = fan_or_cut(&points);
        // One for each face is expected already.
        draft.expect(0, cut.len().saturating_sub(1))?;
        triangles.extend(cut.iter().map(|t| (t.map(|k| corners[k as usize]), color)));
    }
    Ok(triangles)
}

/// Whole numbers are codes; with a point they are light. One number is an index of a table that nobody has.
fn color_of(numbers: &[Word]) -> Option<Rgb> {
    let channels: Vec<f64> = numbers.iter().take(3).map_while(Word::finite).collect();
    let &[r, g, b] = &channels[..] else { return None };
    let whole = numbers.iter().take(3).all(|word| !word.bytes.contains(&b'.'));
    Some(if whole {
        srgb([r, g, b].map(|c| c / 255.0))
    } else {
        rgb(r.clamp(0.0, 1.0), g.clamp(0.0, 1.0), b.clamp(0.0, 1.0))
    })
}

/// Colours as what tells materials apart.
fn codes(color: Rgb) -> [u8; 3] {
    <[f64; 3]>::from(color).map(|c| (c * 255.0).round() as u8)
}

/// One mesh for each colour of faces.
fn add_faces(geometry: &Geometry, mut faces: Faces, draft: &mut Draft) -> Result<(), Stop> {
    // Stable: faces of one colour stay in the file's order.
    faces.sort_by_key(|(_, color)| *color);
    for group in faces.chunk_by(|a, b| a.1 == b.1) {
        let material = match group[0].1 {
            Some(color) => colored(color, draft)?,
            None => draft.plain(),
        };
        let part = geometry.part(group.iter().map(|(t, _)| *t).collect());
        draft.add_geometry(part, Some(&Crease::new(CREASE_DEG)), material, None)?;
    }
    Ok(())
}

fn colored(color: [u8; 3], draft: &mut Draft) -> Result<MaterialId, Stop> {
    let [r, g, b] = color;
    let linear = color.map(|c| f64::from(c) / 255.0);
    Ok(draft.add_material(Material::matte(format!("#{r:02x}{g:02x}{b:02x}"), linear.into()))?)
}
