//! From resources to the scene: components are put in place, triangles sorted by colour.

use std::collections::HashMap;

use brt_geometry::Vec3;
use brt_image::Rgb;
use brt_scene::{Material, MaterialId};

use super::xml::{Component, Model, Object, Property};
use crate::common::{Cost, counted_points};
use crate::import::{Affine, CREASE_DEG, Crease, Draft, Geometry, Graph, Instances, Stop, fault};

/// Builds what the file asks for, or everything where it asks for nothing.
pub(super) fn build(model: &Model, draft: &mut Draft) -> Result<(), Stop> {
    let mut everything = Vec::new();
    if model.items.is_empty() {
        let mut ids: Vec<u32> = model.objects.keys().copied().collect();
        ids.sort_unstable();
        everything.extend(ids.into_iter().map(|object| Component { object, transform: Affine::IDENTITY }));
    }
    let items = if model.items.is_empty() { &everything } else { &model.items };
    let instances = Instances::count(model, items.iter().map(|item| item.object), draft.budget)?;
    let mut builder = Builder { model, draft, materials: HashMap::new(), instances };
    items.iter().try_for_each(|item| builder.add(item, &Affine::IDENTITY))
}

impl Graph for Model {
    type Node = u32;

    fn shown(&self, id: u32) -> Result<Option<u64>, Stop> {
        let Some(object) = self.objects.get(&id) else {
            return Err(fault(format!("there is no object {id}"), None));
        };
        let (points, triangles) = (object.positions.len() as u64, object.triangles.len() as u64);
        let bytes = points * Cost::Point.bytes() + triangles * Cost::Triangle.bytes() + Cost::Use.bytes();
        Ok((triangles > 0).then_some(bytes))
    }

    fn below(&self, id: u32) -> Vec<u32> {
        let components = self.objects.get(&id).map_or(&[][..], |object| &object.components);
        components.iter().map(|component| component.object).collect()
    }

    fn fault(&self, id: u32, what: &str) -> Stop {
        fault(format!("object {id} {what}"), None)
    }
}

struct Builder<'m, 'd, 'b> {
    model: &'m Model,
    draft: &'d mut Draft<'b>,
    materials: HashMap<[u64; 3], MaterialId>,
    instances: Instances<u32>,
}

impl Builder<'_, '_, '_> {
    fn add(&mut self, component: &Component, outer: &Affine) -> Result<(), Stop> {
        let id = component.object;
        let object = match self.model.objects.get(&id) {
            Some(object) if self.instances.shows(id) => object,
            _ => return Ok(()),
        };
        let transform = outer.after(&component.transform);
        self.mesh(id, object, &transform)?;
        object.components.iter().try_for_each(|inner| self.add(inner, &transform))
    }

    fn mesh(&mut self, id: u32, object: &Object, transform: &Affine) -> Result<(), Stop> {
        let count = object.positions.len();
        let mut groups: Vec<(MaterialId, Vec<[u32; 3]>)> = Vec::new();
        let mut mixed = Mixed::default();
        let mut index = HashMap::new();
        for (i, triangle) in object.triangles.iter().enumerate() {
            if let Some(v) = triangle.iter().find(|&&v| v as usize >= count) {
                return Err(fault(
                    format!(
                        "triangle {i} of object {id} uses point {v}, but it has {}",
                        counted_points(count)
                    ),
                    None,
                ));
            }
            let material = match self.colors(object.property(i))? {
                None => self.draft.plain(),
                Some([a, b, c]) if a == b && b == c => self.material(a)?,
                Some(colors) => {
                    mixed.add(*triangle, colors);
                    continue;
                }
            };
            let group = *index.entry(material).or_insert_with(|| {
                groups.push((material, Vec::new()));
                groups.len() - 1
            });
            groups[group].1.push(*triangle);
        }
        let positions: Vec<Vec3> = object.positions.iter().map(|&p| transform.point(p)).collect();
        let whole = Geometry { positions, ..Geometry::default() };
        let name = object.name.as_deref();
        for (material, triangles) in groups {
            self.add_part(whole.part(triangles), material, transform, name)?;
        }
        if !mixed.triangles.is_empty() {
            let white = self.material(Rgb::WHITE)?;
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

    fn material(&mut self, color: Rgb) -> Result<MaterialId, Stop> {
        if let Some(&known) = self.materials.get(&bits(color)) {
            return Ok(known);
        }
        let id = self.draft.add_material(Material::matte("color", color))?;
        self.materials.insert(bits(color), id);
        Ok(id)
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
