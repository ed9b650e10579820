//! Polygon patches (`pp`), joined to smooth meshes.

use std::collections::HashMap;

use brt_geometry::{SMALLEST_ANGLE, Vec3, polygon_plane};
use brt_scene::Mesh;

/// A corner of a patch.
#[derive(Clone, Copy)]
pub(super) struct Corner {
    pub(super) position: Vec3,
    pub(super) normal: Vec3,
}

/// Patches that follow each other in the file: corners with equal position and normal are one point of the mesh, so
/// that patches with a common edge become one smooth surface.
pub(super) struct Patches {
    /// Offset of the first `pp`.
    pub(super) start: usize,
    pub(super) mesh: Mesh,
    points: HashMap<[u64; 6], u32>,
}

impl Patches {
    pub(super) fn new(start: usize) -> Self {
        Self { start, mesh: Mesh::default(), points: HashMap::new() }
    }

    /// Adds a patch as a fan of triangles; the error says why it was left out.
    pub(super) fn add(&mut self, corners: &[Corner]) -> Result<(), &'static str> {
        if corners.len() < 3 {
            return Err("a patch of fewer than three points");
        }
        let outline: Vec<Vec3> = corners.iter().map(|c| c.position).collect();
        let plane = polygon_plane(&outline).ok_or("a patch without an area")?;
        let indices: Vec<u32> = corners.iter().map(|c| self.point(*c, plane.normal)).collect();
        for i in 1..corners.len() - 1 {
            let [a, b, c] = [outline[0], outline[i], outline[i + 1]];
            // At a pole two corners coincide; what remains of the patch is a triangle.
            if (b - a).cross(c - a) != Vec3::ZERO {
                self.mesh.triangles.push([indices[0], indices[i], indices[i + 1]]);
            }
        }
        Ok(())
    }

    fn point(&mut self, corner: Corner, facing: Vec3) -> u32 {
        // A corner without a normal takes that of its patch.
        let normal = if corner.normal == Vec3::ZERO { facing } else { corner.normal };
        let [px, py, pz] = key(corner.position);
        let [nx, ny, nz] = key(normal);
        let mesh = &mut self.mesh;
        *self.points.entry([px, py, pz, nx, ny, nz]).or_insert_with(|| {
            mesh.positions.push(corner.position);
            mesh.normals.push(normal);
            (mesh.positions.len() - 1) as u32
        })
    }
}

/// Equal for equal vectors, where coordinates that are tiny beside the others count as 0: programs print such
/// rounding errors where they mean 0.
fn key(v: Vec3) -> [u64; 3] {
    let greatest = v.x.abs().max(v.y.abs()).max(v.z.abs());
    [v.x, v.y, v.z].map(|c| if c.abs() <= greatest * SMALLEST_ANGLE { 0 } else { c.to_bits() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use brt_geometry::vec3;

    fn corner(x: f64, y: f64) -> Corner {
        Corner { position: vec3(x, y, 0.0), normal: vec3(0.0, 0.0, 1.0) }
    }

    #[test]
    fn patches_with_equal_corners_share_points() {
        let mut patches = Patches::new(0);
        patches.add(&[corner(0.0, 0.0), corner(1.0, 0.0), corner(0.0, 1.0)]).unwrap();
        patches.add(&[corner(1.0, 0.0), corner(1.0, 1.0), corner(-0.0, 1.0)]).unwrap();
        assert_eq!(patches.mesh.positions.len(), 4);
        assert_eq!(patches.mesh.triangles, [[0, 1, 2], [1, 3, 2]]);
    }

    #[test]
    fn a_crease_keeps_its_points_apart() {
        let mut patches = Patches::new(0);
        patches.add(&[corner(0.0, 0.0), corner(1.0, 0.0), corner(0.0, 1.0)]).unwrap();
        let bent = Corner { normal: vec3(1.0, 0.0, 0.0), ..corner(1.0, 0.0) };
        patches.add(&[bent, corner(1.0, 1.0), corner(0.0, 1.0)]).unwrap();
        assert_eq!(patches.mesh.positions.len(), 5);
    }

    #[test]
    fn a_patch_without_area_is_left_out() {
        let mut patches = Patches::new(0);
        assert!(patches.add(&[corner(0.0, 0.0), corner(1.0, 0.0), corner(2.0, 0.0)]).is_err());
        assert!(patches.add(&[corner(0.0, 0.0)]).is_err());
        assert!(patches.mesh.positions.is_empty());
    }
}
