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
        let mut index = HashMap::new();
        for (i, triangle) in object.triangles.iter().enumerate() {
            if let Some(v) = triangle.corners.iter().find(|&&v| v as usize >= count) {
                return Err(fault(
                    format!("triangle {i} of object {id} names point {v}, but there are {count}"),
                    None,
                ));
            }
            let material = self.material(triangle.property)?;
            let group = *index.entry(material).or_insert_with(|| {
                groups.push((material, Vec::new()));
                groups.len() - 1
            });
            groups[group].1.push(triangle.corners);
        }
        let positions: Vec<Vec3> = object.positions.iter().map(|&p| transform.point(p)).collect();
        let whole = Geometry { positions, ..Geometry::default() };
        for (material, mut triangles) in groups {
            if transform.mirrors() {
                triangles.iter_mut().for_each(|t| t.swap(1, 2));
            }
            let part = whole.part(triangles);
            self.draft.add_geometry(
                part,
                Some(&Crease::new(CREASE_DEG)),
                material,
                object.name.as_deref(),
            )?;
        }
        Ok(())
    }

    fn material(&mut self, property: Property) -> Result<MaterialId, Stop> {
        let Some(colors) = property.group.and_then(|group| self.model.colors.get(&group)) else {
            return Ok(self.draft.plain());
        };
        let mut sum = Rgb::BLACK;
        for i in property.indices {
            let Some(&color) = colors.get(i as usize) else {
                let group = property.group.unwrap_or_default();
                return Err(fault(format!("resource {group} has no member {i}"), None));
            };
            sum = sum + color;
        }
        let color = sum * (1.0 / 3.0);
        let key = <[f64; 3]>::from(color).map(f64::to_bits);
        let draft = &mut *self.draft;
        Ok(*self
            .materials
            .entry(key)
            .or_insert_with(|| draft.scene.add_material(Material::matte("color", color))))
    }
}
