//! Faces of more than three points.

use std::cmp::Ordering;

use brt_geometry::{Vec3, polygon_plane};

/// Triangles of a face, as indices of its own points: a fan where every point of it can be seen from the first, else
/// cut as polygons are. Empty for faces without an area.
///
/// A face is cut the same way wherever its list of points begins and whichever way round it runs. Corners of files are
/// rounded, so triangles of one face do not lie in one plane; a face given twice would else be two faces that cut each other.
pub(crate) fn fan_or_cut(points: &[Vec3]) -> Vec<[u32; 3]> {
    let count = points.len();
    if count <= 3 {
        return fan(count);
    }
    let coordinates = |i: usize| [points[i].x, points[i].y, points[i].z];
    let is_before =
        |i: usize, j: usize| coordinates(i).partial_cmp(&coordinates(j)).is_some_and(Ordering::is_lt);
    let first = (1..count).fold(0, |first, i| if is_before(i, first) { i } else { first });
    let is_reversed = is_before((first + count - 1) % count, (first + 1) % count);
    let step = if is_reversed { count - 1 } else { 1 };
    let order: Vec<u32> = (0..count).map(|i| ((first + i * step) % count) as u32).collect();
    let ordered: Vec<Vec3> = order.iter().map(|&i| points[i as usize]).collect();
    let triangles = triangles_of(&ordered).into_iter().map(|t| t.map(|i| order[i as usize]));
    if is_reversed { triangles.map(|[a, b, c]| [a, c, b]).collect() } else { triangles.collect() }
}

fn fan(count: usize) -> Vec<[u32; 3]> {
    (1..count.saturating_sub(1) as u32).map(|i| [0, i, i + 1]).collect()
}

fn triangles_of(points: &[Vec3]) -> Vec<[u32; 3]> {
    /// Cutting may take the square of this.
    const MOST_POINTS: usize = 10_000;
    let Some(plane) = polygon_plane(points) else { return Vec::new() };
    let turns_left = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|i| points[i as usize]);
        (b - a).cross(c - a).dot(plane.normal) >= 0.0
    };
    let all = fan(points.len());
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
    fn a_face_is_cut_alike_wherever_it_begins_and_whichever_way_it_runs() {
        let quad = [vec3(0.3, 1.0, 0.1), vec3(-1.0, 0.2, 0.0), vec3(0.0, -1.1, 0.1), vec3(1.0, 0.1, 0.0)];
        let arrow = [vec3(0.0, 1.0, 0.0), vec3(-1.0, -1.0, 0.0), vec3(0.0, 0.0, 0.0), vec3(1.0, -1.0, 0.0)];
        for points in [quad, arrow] {
            let cut = |points: &[Vec3]| {
                let corners = |t: [u32; 3]| {
                    let mut corners = t.map(|i| points[i as usize].into());
                    corners.sort_by(|a: &[f64; 3], b| a.partial_cmp(b).unwrap());
                    corners
                };
                let mut all: Vec<[[f64; 3]; 3]> = fan_or_cut(points).into_iter().map(corners).collect();
                all.sort_by(|a, b| a.partial_cmp(b).unwrap());
                all
            };
            let expected = cut(&points);
            assert_eq!(expected.len(), 2);
            for start in 0..8 {
                let mut turned = points;
                turned.rotate_left(start % 4);
                if start >= 4 {
                    turned.reverse();
                }
                assert_eq!(cut(&turned), expected, "{start}");
            }
        }
    }

    #[test]
    fn nothing_comes_of_nothing() {
        assert!(fan_or_cut(&[]).is_empty());
        assert!(fan_or_cut(&[vec3(0.0, 0.0, 0.0); 2]).is_empty());
        assert!(fan_or_cut(&[vec3(0.0, 0.0, 0.0); 5]).is_empty());
    }
}
