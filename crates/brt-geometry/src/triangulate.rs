//! Concave polygons and polygons with holes become triangles over the same corners.

use earcut::Earcut;

use crate::Vec3;

/// Corner indices of triangles that tile a flat polygon, each counter-clockwise seen along `-normal`.
///
/// Indices count through the outline and then the holes. Inner edges join the polygon's own corners, so neighbours
/// compute opposite edge functions and nothing slips between them. Empty where the loops enclose nothing.
pub fn triangulate(outline: &[Vec3], holes: &[Vec<Vec3>], normal: Vec3) -> Vec<[u32; 3]> {
    let flat = Flat::new(outline[0], normal);
    let points: Vec<[f64; 2]> = outline.iter().chain(holes.iter().flatten()).map(|&p| flat.of(p)).collect();
    let mut starts = Vec::with_capacity(holes.len());
    let mut next = outline.len();
    for hole in holes {
        starts.push(next as u32);
        next += hole.len();
    }
    let mut indices: Vec<u32> = Vec::new();
    Earcut::new().earcut(points.iter().copied(), &starts, &mut indices);
    let turned = |[a, b, c]: [u32; 3]| {
        let area = area2(points[a as usize], points[b as usize], points[c as usize]);
        if area < 0.0 { [a, c, b] } else { [a, b, c] }
    };
    indices.chunks_exact(3).map(|t| turned([t[0], t[1], t[2]])).collect()
}

/// Is a flat loop convex (it may have corners of 180°) and run once around?
pub fn is_convex(outline: &[Vec3], normal: Vec3) -> bool {
    let flat = Flat::new(outline[0], normal);
    let points: Vec<[f64; 2]> = outline.iter().map(|&p| flat.of(p)).collect();
    let n = points.len();
    let turns_left = (0..n).all(|i| area2(points[i], points[(i + 1) % n], points[(i + 2) % n]) >= 0.0);
    // A loop that winds twice (a star) turns left everywhere too, but goes back and forth more than once.
    let rightward: Vec<bool> = (0..n)
        .map(|i| points[(i + 1) % n][0] - points[i][0])
        .filter(|&dx| dx != 0.0)
        .map(|dx| dx > 0.0)
        .collect();
    let reversals =
        (0..rightward.len()).filter(|&i| rightward[i] != rightward[(i + 1) % rightward.len()]).count();
    turns_left && reversals <= 2
}

/// Coordinates in a plane.
struct Flat {
    origin: Vec3,
    u: Vec3,
    v: Vec3,
}

impl Flat {
    fn new(origin: Vec3, normal: Vec3) -> Self {
        let (u, v) = normal.tangents();
        Self { origin, u, v }
    }

    fn of(&self, point: Vec3) -> [f64; 2] {
        let p = point - self.origin;
        [p.dot(self.u), p.dot(self.v)]
    }
}

/// Twice the signed area of a triangle.
fn area2(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vec3;

    fn flat(points: &[(f64, f64)]) -> Vec<Vec3> {
        points.iter().map(|&(x, y)| vec3(x, y, 0.0)).collect()
    }

    fn area(outline: &[Vec3], holes: &[Vec<Vec3>], triangles: &[[u32; 3]]) -> f64 {
        let all: Vec<Vec3> = outline.iter().chain(holes.iter().flatten()).copied().collect();
        let corner = |i: u32| all[i as usize];
        triangles.iter().map(|&[a, b, c]| 0.5 * (corner(b) - corner(a)).cross(corner(c) - corner(a)).z).sum()
    }

    const UP: Vec3 = vec3(0.0, 0.0, 1.0);

    #[test]
    fn an_l_is_concave_and_keeps_its_area() {
        // 2×2 square less a 1×1 corner: area 3
        let l = flat(&[(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)]);
        assert!(!is_convex(&l, UP));
        assert!((area(&l, &[], &triangulate(&l, &[], UP)) - 3.0).abs() < 1e-12);
    }

    #[test]
    fn a_hole_is_left_out() {
        // 4×4 square less a 1×1 hole: area 15
        let square = flat(&[(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]);
        let hole = flat(&[(1.0, 1.0), (2.0, 1.0), (2.0, 2.0), (1.0, 2.0)]);
        assert!(is_convex(&square, UP));
        let holes = [hole];
        assert!((area(&square, &holes, &triangulate(&square, &holes, UP)) - 15.0).abs() < 1e-12);
    }

    #[test]
    fn a_pentagram_turns_left_but_is_not_convex() {
        let star: Vec<(f64, f64)> = (0..5)
            .map(|i| {
                let angle = f64::from(i) * 2.0 * std::f64::consts::TAU / 5.0;
                (libm::cos(angle), libm::sin(angle))
            })
            .collect();
        assert!(!is_convex(&flat(&star), UP));
    }
}
