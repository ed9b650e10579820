//! IndexedFaceSet: polygons, with colours and normals per point, per corner or per face.

use brt_geometry::Vec3;
use brt_image::Rgb;
use brt_scene::MaterialId;

use super::syntax::Node;
use crate::common::counted_points;
use crate::import::{Affine, CREASE_DEG, Crease, Draft, Geometry, Stop, fan_or_cut, fault, srgb};

/// Adds the faces.
pub(super) fn add(node: &Node, place: &Affine, material: MaterialId, draft: &mut Draft) -> Result<(), Stop> {
    let triples = |list: &[f64]| list.chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect::<Vec<[f64; 3]>>();
    let of = |field: &str, list: &str| node.node(field).map_or(Vec::new(), |n| triples(n.numbers(list)));
    let points: Vec<Vec3> = of("coord", "point").into_iter().map(Vec3::from).collect();
    let colors: Vec<Rgb> = of("color", "color").into_iter().map(srgb).collect();
    let normals: Vec<Vec3> = of("normal", "vector").into_iter().map(Vec3::from).collect();

    let colors = Attribute::new(node, "color", colors);
    // Normals per face are those that faces have anyway.
    let normals = Attribute::new(node, "normal", normals).filter(|a| a.per_vertex);
    let mut faces =
        Faces { node, points: &points, colors, normals, geometry: Geometry::default(), corner: 0, face: 0 };
    let indices = node.numbers("coordIndex");
    let mut start = 0;
    for (i, &index) in indices.iter().enumerate() {
        if index < 0.0 {
            faces.add(start..i, draft)?;
            start = i + 1;
        }
    }
    faces.add(start..indices.len(), draft)?;
    let mut geometry = faces.geometry;
    if !node.is("ccw", true) {
        geometry.triangles.iter_mut().for_each(|t| t.swap(1, 2));
    }
    let angle = node.numbers("creaseAngle").first().map_or(CREASE_DEG, |angle| angle.to_degrees());
    Ok(draft.add_geometry(geometry.moved(place), Some(&Crease::new(angle)), material, None)?)
}

/// Values per vertex (by an index of their own or by that of the point) or per face.
struct Attribute<'n, T> {
    values: Vec<T>,
    indices: &'n [f64],
    per_vertex: bool,
}

impl<'n, T: Copy> Attribute<'n, T> {
    fn new(node: &'n Node, name: &str, values: Vec<T>) -> Option<Self> {
        let indices = node.numbers(&format!("{name}Index"));
        let per_vertex = node.is(&format!("{name}PerVertex"), true);
        (!values.is_empty()).then_some(Self { values, indices, per_vertex })
    }

    fn of(&self, point: usize, corner: usize, face: usize) -> Option<T> {
        let own = if self.per_vertex { corner } else { face };
        let index = match (self.indices.get(own), self.per_vertex) {
            (Some(&index), _) => index as usize,
            (None, true) => point,
            (None, false) => face,
        };
        self.values.get(index).copied()
    }
}

struct Faces<'n> {
    node: &'n Node,
    points: &'n [Vec3],
    colors: Option<Attribute<'n, Rgb>>,
    normals: Option<Attribute<'n, Vec3>>,
    geometry: Geometry,
    /// Place in the lists of indices, in which −1 counts too.
    corner: usize,
    face: usize,
}

impl Faces<'_> {
    fn add(&mut self, range: std::ops::Range<usize>, draft: &mut Draft) -> Result<(), Stop> {
        let corners = &self.node.numbers("coordIndex")[range.clone()];
        if corners.is_empty() {
            return Ok(());
        }
        self.corner = range.start;
        let mut points = Vec::new();
        for &index in corners {
            let Some(&p) = self.points.get(index as usize) else {
                let count = counted_points(self.points.len());
                let message = format!("face {} uses point {index}, but the list has {count}", self.face);
                return Err(fault(message, Some(self.node.span.clone())));
            };
            points.push(p);
        }
        let cut = fan_or_cut(&points);
        draft.expect(corners.len(), cut.len())?;
        let first = self.geometry.positions.len() as u32;
        for (k, (&index, p)) in corners.iter().zip(points).enumerate() {
            self.geometry.positions.push(p);
            let place = (index as usize, self.corner + k, self.face);
            if let Some(colors) = &self.colors {
                let color = colors.of(place.0, place.1, place.2);
                self.geometry.colors.push(color.unwrap_or(Rgb::WHITE));
            }
            if let Some(normals) = &self.normals {
                let normal = normals.of(place.0, place.1, place.2);
                self.geometry.normals.push(normal.unwrap_or(Vec3::ZERO));
            }
        }
        self.geometry.triangles.extend(cut.iter().map(|t| t.map(|k| first + k)));
        self.face += 1;
        Ok(())
    }
}
