//! Faces of more than three points.

use brt_geometry::{Vec3, polygon_plane};

/// Triangles of a face, as indices of its own points: a fan where every point of it can be seen from the first, else
/// cut as polygons are. Empty for faces without an area.
pub(crate) fn fan_or_cut(points: &[Vec3]) -> Vec<[u32; 3]> {
    /// Cutting may take the square of this.
    const MOST_POINTS: usize = 10_000;
    let fan = || (1..points.len().saturating_sub(1) as u32).map(|i| [0, i, i + 1]).collect();
    if points.len() <= 3 {
        return fan();
    }
    let Some(plane) = polygon_plane(points) else { return Vec::new() };
    let turns_left = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|i| points[i as usize]);
        (b - a).cross(c - a).dot(plane.normal) >= 0.0
    };
    let all: Vec<[u32; 3]> = fan();
    if all.iter().all(turns_left) || points.len() > MOST_POINTS {
        return all;
    }
    let (u, v) = plane.normal.tangents();
    // In units of the polygon, so that products of huge coordinates do not overflow.
    let local = points.iter().map(|&p| (p - plane.center) * (1.0 / plane.size));
    let flat = local.map(|p| [p.dot(u), p.dot(v)]);
    let mut indices: Vec<u32> = Vec::new();
    earcut::Earcut::new().earcut(flat, &[], &mut indices);
    let ordered = |t: &[u32]| {
        let triangle = [t[0], t[1], t[2]];
        if turns_left(&triangle) { triangle } else { [t[0], t[2], t[1]] }
    };
    indices.chunks_exact(3).map(ordered).collect()
}

#[cfg(test)]
mod tests {
    use brt_geometry::vec3;

    use super::*;

    #[test]
    fn concave_faces_keep_their_outline() {
        // An arrow head: its area is 2 · (2·2/2 − 2·1/2) / 2 = 1 on either side.
        let points = [vec3(0.0, 1.0, 0.0), vec3(-1.0, -1.0, 0.0), vec3(0.0, 0.0, 0.0), vec3(1.0, -1.0, 0.0)];
        let area = |t: &[u32; 3]| {
            let [a, b, c] = t.map(|i| points[i as usize]);
            0.5 * (b - a).cross(c - a).z
        };
        for start in 0..4 {
            let mut turned = points;
            turned.rotate_left(start);
            let triangles = fan_or_cut(&turned);
            let back = triangles.iter().map(|t| t.map(|i| (i + start as u32) % 4));
            let areas: Vec<f64> = back.map(|t| area(&t)).collect();
            assert!(areas.iter().all(|&a| a > 0.0), "{start}: {areas:?}");
            assert!((areas.iter().sum::<f64>() - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn nothing_comes_of_nothing() {
        assert!(fan_or_cut(&[]).is_empty());
        assert!(fan_or_cut(&[vec3(0.0, 0.0, 0.0); 2]).is_empty());
        assert!(fan_or_cut(&[vec3(0.0, 0.0, 0.0); 5]).is_empty());
    }
}
