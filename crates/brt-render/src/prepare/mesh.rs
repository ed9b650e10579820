//! Meshes become triangles on smooth groups.

use brt_geometry::{Affine, FACET_ANGLE, Primitive, Triangle, Vec3};
use brt_scene::Mesh;
use rayon::prelude::*;

use super::flatten::{Corners, Flattened, Owner};

/// Adds a mesh's triangles. Those without area are left out: no ray can meet them.
pub(super) fn flatten_mesh(mesh: &Mesh, map: &Affine, owner: Owner, flat: &mut Flattened) {
    let mesh = &*mesh.placed(map);
    let corners = |t: &[u32; 3]| t.map(|i| mesh.positions[i as usize]);
    let solid: Vec<(&[u32; 3], Triangle)> =
        mesh.triangles.par_iter().filter_map(|t| Some((t, Triangle::new(corners(t))?))).collect();
    let mut groups = Groups::new(solid.len());
    let (is_smooth, has_colors) = (!mesh.normals.is_empty(), !mesh.colors.is_empty());
    let is_textured = owner.has_texture && !mesh.texcoords.is_empty();
    join_neighbours(&solid, is_smooth, &mut groups);

    flat.reserve(solid.len());
    let mut surface_of_group: Vec<Option<u32>> = vec![None; solid.len()];
    for (index, (indices, triangle)) in solid.iter().enumerate() {
        let group = groups.find(index);
        let surface = *surface_of_group[group].get_or_insert_with(|| flat.add_surface(owner));
        let normal = |i: u32| mesh.normals[i as usize].try_normalize().unwrap_or(triangle.plane.normal);
        let corners = Corners {
            normals: is_smooth.then(|| indices.map(normal)),
            colors: has_colors.then(|| indices.map(|i| mesh.colors[i as usize])),
            texcoords: is_textured.then(|| indices.map(|i| mesh.texcoords[i as usize])),
        };
        flat.add(Primitive::Triangle(*triangle), owner, surface, corners);
    }
}

/// Joins triangles over common edges: all in a mesh with normals, those in one plane in a mesh without.
fn join_neighbours(triangles: &[(&[u32; 3], Triangle)], is_smooth: bool, groups: &mut Groups) {
    let mut edges: Vec<([u32; 2], usize)> = triangles
        .par_iter()
        .enumerate()
        .flat_map_iter(|(index, ([a, b, c], _))| {
            [(*a, *b), (*b, *c), (*c, *a)].map(|(from, to)| ([from.min(to), from.max(to)], index))
        })
        .collect();
    edges.par_sort_unstable();
    for triangles_at in edges.chunk_by(|a, b| a.0 == b.0) {
        let first = triangles_at[0].1;
        for &(_, index) in &triangles_at[1..] {
            if is_smooth || is_same_direction(&triangles[index].1, &triangles[first].1) {
                groups.join(index, first);
            }
        }
    }
}

fn is_same_direction(a: &Triangle, b: &Triangle) -> bool {
    let difference: Vec3 = a.plane.normal - b.plane.normal;
    difference.length() < FACET_ANGLE
}

/// Disjoint sets of triangles (union by smaller index, so that results do not depend on the order of joins).
struct Groups {
    parent: Vec<usize>,
}

impl Groups {
    fn new(count: usize) -> Self {
        Self { parent: (0..count).collect() }
    }

    fn find(&mut self, mut index: usize) -> usize {
        while self.parent[index] != index {
            self.parent[index] = self.parent[self.parent[index]];
            index = self.parent[index];
        }
        index
    }

    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.find(a), self.find(b));
        let (low, high) = (a.min(b), a.max(b));
        self.parent[high] = low;
    }
}
