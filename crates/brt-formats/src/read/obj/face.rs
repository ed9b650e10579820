//! Faces of one mesh under construction.

use std::collections::HashMap;

use brt_geometry::Vec3;
use brt_image::Rgb;

use crate::import::{CREASE_DEG, Crease, Draft, Geometry, Stop, fan_or_cut};

/// A corner of a face: indices in the file's lists.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(super) struct Corner {
    pub(super) point: u32,
    pub(super) texcoord: Option<u32>,
    pub(super) normal: Option<u32>,
}

/// Faces since the last change of object, group or material.
#[derive(Default)]
pub(super) struct Chunk {
    geometry: Geometry,
    index: HashMap<Corner, u32>,
    groups: Vec<u32>,
    lacks_normals: bool,
    has_texcoords: bool,
}

/// The file's lists.
#[derive(Default)]
pub(super) struct Lists {
    pub(super) positions: Vec<Vec3>,
    pub(super) colors: Vec<Rgb>,
    pub(super) normals: Vec<Vec3>,
    /// As our meshes have them: from the picture's upper left corner.
    pub(super) texcoords: Vec<[f64; 2]>,
}

impl Chunk {
    pub(super) fn is_empty(&self) -> bool {
        self.geometry.triangles.is_empty()
    }

    /// Adds a face whose indices are in range.
    pub(super) fn add(&mut self, corners: &[Corner], group: u32, lists: &Lists) {
        let points: Vec<Vec3> = corners.iter().map(|corner| lists.positions[corner.point as usize]).collect();
        let indices: Vec<u32> = corners.iter().map(|&corner| self.point(corner, lists)).collect();
        for t in fan_or_cut(&points) {
            let triangle = t.map(|k| indices[k as usize]);
            let [a, b, c] = triangle.map(|i| self.geometry.positions[i as usize]);
            // One smoothing group per triangle: so those without an area are left out here.
            if (b - a).cross(c - a).try_normalize().is_some() {
                self.geometry.triangles.push(triangle);
                self.groups.push(group);
            }
        }
    }

    fn point(&mut self, corner: Corner, lists: &Lists) -> u32 {
        let next = self.geometry.positions.len() as u32;
        let geometry = &mut self.geometry;
        self.lacks_normals |= corner.normal.is_none();
        self.has_texcoords |= corner.texcoord.is_some();
        *self.index.entry(corner).or_insert_with(|| {
            let p = corner.point as usize;
            geometry.positions.push(lists.positions[p]);
            geometry.normals.push(corner.normal.map_or(Vec3::ZERO, |n| lists.normals[n as usize]));
            geometry.texcoords.push(corner.texcoord.map_or([0.0; 2], |t| lists.texcoords[t as usize]));
            if !lists.colors.is_empty() {
                // The faces before may be from above the file's first colour.
                geometry.colors.resize(next as usize, Rgb::WHITE);
                geometry.colors.push(lists.colors.get(p).copied().unwrap_or(Rgb::WHITE));
            }
            next
        })
    }

    /// Moves the faces to the scene.
    pub(super) fn add_to(
        &mut self,
        draft: &mut Draft,
        material: brt_scene::MaterialId,
        name: Option<&str>,
        has_groups: bool,
    ) -> Result<(), Stop> {
        let Self { mut geometry, groups, lacks_normals, has_texcoords, .. } = std::mem::take(self);
        if geometry.triangles.is_empty() {
            return Ok(());
        }
        if lacks_normals {
            geometry.normals.clear();
        }
        if !has_texcoords {
            geometry.texcoords.clear();
        }
        if geometry.drop_wild_texcoords() {
            let place = name.map_or("a part without a name".to_owned(), |name| format!("`{name}`"));
            draft.notices.note("texture coordinates that are no numbers ignored", place);
        }
        let crease = if has_groups { Crease::of_groups(&groups) } else { Crease::new(CREASE_DEG) };
        Ok(draft.add_geometry(geometry, Some(&crease), material, name)?)
    }
}
