//! From resources to the scene: components are put in place, triangles sorted by colour.

use std::collections::HashMap;

use brt_geometry::Vec3;
use brt_image::Rgb;
use brt_scene::{Material, MaterialId};

use super::xml::{Component, Model, Object, Property};
use crate::Limits;
use crate::import::{Affine, CREASE_DEG, Crease, Draft, Geometry, Stop, fault};

/// Components that are visited at most: those of empty objects cost time, too.
const MOST_VISITS: u32 = 1_000_000;

/// Builds what the file asks for, or everything where it asks for nothing.
pub(super) fn build(model: &Model, draft: &mut Draft) -> Result<(), Stop> {
    let mut builder = Builder { model, draft, materials: HashMap::new(), visits: 0 };
    if model.items.is_empty() {
        let mut ids: Vec<u32> = model.objects.keys().copied().collect();
        ids.sort_unstable();
        for object in ids {
            builder.add(&Component { object, transform: Affine::IDENTITY }, &Affine::IDENTITY, 0)?;
        }
    }
    for item in &model.items {
        builder.add(item, &Affine::IDENTITY, 0)?;
    }
    Ok(())
}

struct Builder<'m, 'd> {
    model: &'m Model,
    draft: &'d mut Draft,
    materials: HashMap<[u64; 3], MaterialId>,
    visits: u32,
}

impl Builder<'_, '_> {
    fn add(&mut self, component: &Component, outer: &Affine, depth: usize) -> Result<(), Stop> {
        let id = component.object;
        let Some(object) = self.model.objects.get(&id) else {
            return Err(fault(format!("there is no object {id}"), None));
        };
        self.visits += 1;
        if depth > Limits::NESTING || self.visits > MOST_VISITS {
            return Err(fault(
                format!("components of object {id} nest too deep, or contain themselves"),
                None,
            ));
        }
        let transform = outer.after(&component.transform);
        self.mesh(id, object, &transform)?;
        object.components.iter().try_for_each(|inner| self.add(inner, &transform, depth + 1))
    }

    fn mesh(&mut self, id: u32, object: &Object, transform: &Affine) -> Result<(), Stop> {
        let count = object.positions.len();
        // What an instance costs is counted even where no triangle uses the points.
        self.draft.expect(count, 0)?;
        let mut groups: Vec<(MaterialId, Vec<[u32; 3]>)> = Vec::new();
        let mut mixed = Mixed::default();
        let mut index = HashMap::new();
        for (i, triangle) in object.triangles.iter().enumerate() {
            if let Some(v) = triangle.corners.iter().find(|&&v| v as usize >= count) {
                return Err(fault(
                    format!("triangle {i} of object {id} names point {v}, but there are {count}"),
                    None,
                ));
            }
            let material = match self.colors(triangle.property)? {
                None => self.draft.plain(),
                Some([a, b, c]) if a == b && b == c => self.material(a),
                Some(colors) => {
                    mixed.add(triangle.corners, colors);
                    continue;
                }
            };
            let group = *index.entry(material).or_insert_with(|| {
                groups.push((material, Vec::new()));
                groups.len() - 1
            });
            groups[group].1.push(triangle.corners);
        }
        let positions: Vec<Vec3> = object.positions.iter().map(|&p| transform.point(p)).collect();
        let whole = Geometry { positions, ..Geometry::default() };
        let name = object.name.as_deref();
        for (material, triangles) in groups {
            self.add_part(whole.part(triangles), material, transform, name)?;
        }
        if !mixed.triangles.is_empty() {
            let white = self.material(Rgb::WHITE);
            self.add_part(mixed.geometry(&whole), white, transform, name)?;
        }
        Ok(())
    }

    fn add_part(
        &mut self,
        mut part: Geometry,
        material: MaterialId,
        transform: &Affine,
        name: Option<&str>,
    ) -> Result<(), Stop> {
        if transform.mirrors() {
            part.triangles.iter_mut().for_each(|t| t.swap(1, 2));
        }
        Ok(self.draft.add_geometry(part, Some(&Crease::new(CREASE_DEG)), material, name)?)
    }

    /// The colours of a triangle's corners, if it has any.
    fn colors(&self, property: Property) -> Result<Option<[Rgb; 3]>, Stop> {
        let Some(colors) = property.group.and_then(|group| self.model.colors.get(&group)) else {
            return Ok(None);
        };
        let mut found = [Rgb::BLACK; 3];
        for (slot, i) in found.iter_mut().zip(property.indices) {
            let Some(&color) = colors.get(i as usize) else {
                let group = property.group.unwrap_or_default();
                return Err(fault(format!("resource {group} has no member {i}"), None));
            };
            *slot = color;
        }
        Ok(Some(found))
    }

    fn material(&mut self, color: Rgb) -> MaterialId {
        let draft = &mut *self.draft;
        *self
            .materials
            .entry(bits(color))
            .or_insert_with(|| draft.scene.add_material(Material::matte("color", color)))
    }
}

fn bits(color: Rgb) -> [u64; 3] {
    <[f64; 3]>::from(color).map(f64::to_bits)
}

/// Triangles whose corners differ in colour: points are split where the colours of a place differ.
#[derive(Default)]
struct Mixed {
    index: HashMap<(u32, [u64; 3]), u32>,
    sources: Vec<u32>,
    colors: Vec<Rgb>,
    triangles: Vec<[u32; 3]>,
}

impl Mixed {
    fn add(&mut self, corners: [u32; 3], colors: [Rgb; 3]) {
        let Self { index, sources, colors: all, .. } = self;
        let mut triangle = [0; 3];
        for ((slot, corner), color) in triangle.iter_mut().zip(corners).zip(colors) {
            let next = sources.len() as u32;
            *slot = *index.entry((corner, bits(color))).or_insert_with(|| {
                sources.push(corner);
                all.push(color);
                next
            });
        }
        self.triangles.push(triangle);
    }

    fn geometry(self, whole: &Geometry) -> Geometry {
        let positions = self.sources.iter().map(|&i| whole.positions[i as usize]).collect();
        Geometry { positions, colors: self.colors, triangles: self.triangles, ..Geometry::default() }
    }
}
