//! Polygons (`p`): flat ones as they are, others cut into triangles.

use brt_geometry::{PolygonPlane, Vec3, polygon_plane};
use brt_scene::{Mesh, Shape};

/// What a list of points turns out to be.
pub(super) enum Polygon {
    /// A flat polygon.
    Flat(Shape),
    /// Points that are not in one plane, as triangles.
    Bent(Mesh),
    /// Nothing that can be seen, and why.
    Nothing(&'static str),
}

/// The polygon of these points; points that repeat their neighbour are left out.
pub(super) fn polygon_shape(mut points: Vec<Vec3>) -> Polygon {
    points.dedup();
    while points.len() > 1 && points.first() == points.last() {
        points.pop();
    }
    if points.len() < 3 {
        return Polygon::Nothing("a polygon of fewer than three different points");
    }
    let Some(plane) = polygon_plane(&points) else {
        return Polygon::Nothing("a polygon without an area");
    };
    if plane.greatest_distance(&points).is_none() {
        return Polygon::Flat(Shape::Polygon { outline: points, holes: Vec::new() });
    }
    let triangles = cut(&points, &plane);
    if triangles.is_empty() {
        return Polygon::Nothing("a bent polygon that cannot be cut into triangles");
    }
    Polygon::Bent(Mesh { positions: points, triangles, ..Mesh::default() })
}

/// Cuts the polygon's shadow on its mean plane, which for concave outlines is more than a fan.
fn cut(points: &[Vec3], plane: &PolygonPlane) -> Vec<[u32; 3]> {
    /// Cutting may take the square of this.
    const MOST_POINTS: usize = 10_000;
    if points.len() > MOST_POINTS {
        return Vec::new();
    }
    let (u, v) = plane.normal.tangents();
    // In units of the polygon, so that products of huge coordinates do not overflow.
    let local: Vec<Vec3> = points.iter().map(|&p| (p - plane.center) * (1.0 / plane.size)).collect();
    let flat = local.iter().map(|p| [p.dot(u), p.dot(v)]);
    let mut indices: Vec<u32> = Vec::new();
    earcut::Earcut::new().earcut(flat, &[], &mut indices);
    let front = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|i| local[i as usize]);
        (b - a).cross(c - a).dot(plane.normal)
    };
    let ordered = |t: &[u32]| {
        let triangle = [t[0], t[1], t[2]];
        if front(&triangle) < 0.0 { [t[0], t[2], t[1]] } else { triangle }
    };
    indices.chunks_exact(3).map(ordered).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use brt_geometry::vec3;

    #[test]
    fn a_bent_quad_becomes_two_triangles_that_face_its_front() {
        let points = vec![vec3(0.0, 0.0, 0.0), vec3(1.0, 0.0, 0.0), vec3(1.0, 1.0, 0.5), vec3(0.0, 1.0, 0.0)];
        let Polygon::Bent(mesh) = polygon_shape(points) else { panic!("it is bent") };
        assert_eq!(mesh.triangles.len(), 2);
        for t in &mesh.triangles {
            let [a, b, c] = t.map(|i| mesh.positions[i as usize]);
            assert!((b - a).cross(c - a).z > 0.0);
        }
    }

    #[test]
    fn repeated_points_are_left_out() {
        let [a, b, c] = [vec3(0.0, 0.0, 0.0), vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0)];
        let Polygon::Flat(Shape::Polygon { outline, .. }) = polygon_shape(vec![a, b, b, c, a]) else {
            panic!("it is flat")
        };
        assert_eq!(outline, [a, b, c]);
        assert!(matches!(polygon_shape(vec![a, b, a]), Polygon::Nothing(_)));
        assert!(matches!(polygon_shape(vec![]), Polygon::Nothing(_)));
    }
}
