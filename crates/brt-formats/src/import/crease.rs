//! Normals for triangles that come without: smooth where faces meet at a small angle, a crease elsewhere.

use brt_geometry::Vec3;

use super::geometry::normal_of;
use super::weld::Weld;
use crate::common::{Budget, Halt};

/// Faces that meet at less than this are one smooth surface, in degrees. Between the 11° of a round of 32 sides and
/// the 45° of a chamfer.
pub(crate) const CREASE_DEG: f64 = 35.0;

/// Which faces are smooth together.
pub(crate) struct Crease<'g> {
    cosine: f64,
    groups: Option<&'g [u32]>,
}

/// Points split where creases pass, with normals.
pub(crate) struct Smooth {
    /// For each new point the old one.
    pub(super) sources: Vec<u32>,
    pub(super) normals: Vec<Vec3>,
    pub(super) triangles: Vec<[u32; 3]>,
}

impl<'g> Crease<'g> {
    /// Smooth below an angle between the normals.
    pub(crate) fn new(degrees: f64) -> Self {
        Self { cosine: libm::cos(degrees.to_radians()), groups: None }
    }

    /// Smooth within smoothing groups, one number per triangle; group 0 is flat everywhere.
    pub(crate) fn of_groups(groups: &'g [u32]) -> Self {
        Self { cosine: -2.0, groups: Some(groups) }
    }

    pub(crate) fn has_groups(&self) -> bool {
        self.groups.is_some()
    }

    fn joins(&self, normals: &[Vec3], a: u32, b: u32) -> bool {
        let (a, b) = (a as usize, b as usize);
        match self.groups {
            Some(groups) => groups[a] != 0 && groups[a] == groups[b],
            None => normals[a].dot(normals[b]) >= self.cosine,
        }
    }

    /// Splits the points of triangles that all have an area.
    pub(crate) fn split(
        &self,
        positions: &[Vec3],
        triangles: &[[u32; 3]],
        budget: &Budget,
    ) -> Result<Smooth, Halt> {
        let faces: Vec<Vec3> =
            triangles.iter().map(|&t| normal_of(positions, t).unwrap_or_default()).collect();
        let classes = Weld::classes(positions);
        let corners = Corners::of(&classes, triangles);
        let mut smooth = Smooth {
            sources: Vec::new(),
            normals: Vec::new(),
            triangles: vec![[u32::MAX; 3]; triangles.len()],
        };
        let mut fan = Fan::default();
        for around in corners.by_point() {
            budget.go_on()?;
            fan.gather(around, triangles, &classes);
            fan.join(|a, b| self.joins(&faces, a, b));
            fan.add_points(positions, triangles, &faces, &mut smooth);
        }
        Ok(smooth)
    }
}

/// The corners of all triangles, sorted by point. A corner is `3·triangle + 0, 1 or 2`.
struct Corners {
    starts: Vec<u32>,
    corners: Vec<u32>,
}

impl Corners {
    fn of(classes: &[u32], triangles: &[[u32; 3]]) -> Self {
        let mut starts = vec![0_u32; classes.len() + 1];
        let class = |i: u32| classes[i as usize] as usize;
        for &i in triangles.iter().flatten() {
            starts[class(i) + 1] += 1;
        }
        for i in 1..starts.len() {
            starts[i] += starts[i - 1];
        }
        let mut next = starts.clone();
        let mut corners = vec![0; 3 * triangles.len()];
        for (corner, &i) in triangles.iter().flatten().enumerate() {
            let slot = &mut next[class(i)];
            corners[*slot as usize] = corner as u32;
            *slot += 1;
        }
        Self { starts, corners }
    }

    fn by_point(&self) -> impl Iterator<Item = &[u32]> {
        self.starts.windows(2).map(|w| &self.corners[w[0] as usize..w[1] as usize])
    }
}

/// The corners around one point, in sets that are smooth together.
#[derive(Default)]
struct Fan {
    corners: Vec<u32>,
    /// Where each corner's set is looked up; a set's first corner names it.
    parents: Vec<u32>,
    /// The far end of an edge from the point, and a corner beside it.
    edges: Vec<(u32, u32)>,
}

impl Fan {
    fn gather(&mut self, around: &[u32], triangles: &[[u32; 3]], classes: &[u32]) {
        self.corners.clear();
        self.corners.extend_from_slice(around);
        self.parents.clear();
        self.parents.extend(0..around.len() as u32);
        self.edges.clear();
        for (local, &corner) in around.iter().enumerate() {
            let t = triangles[corner as usize / 3];
            let k = corner as usize % 3;
            for far in [t[(k + 1) % 3], t[(k + 2) % 3]] {
                self.edges.push((classes[far as usize], local as u32));
            }
        }
        self.edges.sort_unstable();
    }

    fn join(&mut self, joins: impl Fn(u32, u32) -> bool) {
        for i in 1..self.edges.len() {
            let [(far_a, a), (far_b, b)] = [self.edges[i - 1], self.edges[i]];
            let triangle = |local: u32| self.corners[local as usize] / 3;
            if far_a == far_b && joins(triangle(a), triangle(b)) {
                let (a, b) = (self.root(a), self.root(b));
                // The first corner stays the root, so that the order of points follows the file.
                self.parents[a.max(b) as usize] = a.min(b);
            }
        }
    }

    fn root(&mut self, local: u32) -> u32 {
        let mut i = local;
        while self.parents[i as usize] != i {
            let above = self.parents[i as usize];
            self.parents[i as usize] = self.parents[above as usize];
            i = above;
        }
        i
    }

    /// A new point for each set, or several where the file has several points at this place.
    fn add_points(
        &mut self,
        positions: &[Vec3],
        triangles: &[[u32; 3]],
        faces: &[Vec3],
        smooth: &mut Smooth,
    ) {
        let count = self.corners.len();
        let mut sums = vec![Vec3::ZERO; count];
        for local in 0..count {
            let corner = self.corners[local];
            let root = self.root(local as u32) as usize;
            let face = faces[corner as usize / 3];
            sums[root] = sums[root] + face * angle(positions, triangles, corner);
        }
        // Sorted by set and old point, so that equal ones stand together even around points with a million faces.
        let mut order: Vec<(u32, u32, u32)> = (0..count as u32)
            .map(|local| {
                let corner = self.corners[local as usize];
                (self.root(local), triangles[corner as usize / 3][corner as usize % 3], corner)
            })
            .collect();
        order.sort_unstable();
        let mut last = None;
        for (root, old, corner) in order {
            if last != Some((root, old)) {
                last = Some((root, old));
                let own = faces[self.corners[root as usize] as usize / 3];
                smooth.sources.push(old);
                smooth.normals.push(sums[root as usize].try_normalize().unwrap_or(own));
            }
            smooth.triangles[corner as usize / 3][corner as usize % 3] = (smooth.sources.len() - 1) as u32;
        }
    }
}

/// The triangle's angle at a corner: as its weight it makes the normal independent of how faces are cut.
fn angle(positions: &[Vec3], triangles: &[[u32; 3]], corner: u32) -> f64 {
    let t = triangles[corner as usize / 3];
    let k = corner as usize % 3;
    let [p, q, r] = [t[k], t[(k + 1) % 3], t[(k + 2) % 3]].map(|i| positions[i as usize]);
    match ((q - p).try_normalize(), (r - p).try_normalize()) {
        (Some(a), Some(b)) => libm::acos(a.dot(b).clamp(-1.0, 1.0)),
        _ => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use brt_geometry::vec3;

    use super::*;
    use crate::common::Limits;

    /// Two triangles along the x axis, folded by so many degrees.
    fn fold(degrees: f64) -> (Vec<Vec3>, Vec<[u32; 3]>) {
        let a = f64::to_radians(degrees);
        let tip = vec3(0.5, libm::cos(a), libm::sin(a));
        let points = vec![vec3(0.0, 0.0, 0.0), vec3(1.0, 0.0, 0.0), vec3(0.5, -1.0, 0.0), tip];
        (points, vec![[0, 2, 1], [0, 1, 3]])
    }

    #[test]
    fn the_angle_decides() {
        for (degrees, points) in [(20.0, 4), (50.0, 6)] {
            let (positions, triangles) = fold(degrees);
            let smooth =
                Crease::new(35.0).split(&positions, &triangles, &Budget::new(&Limits::default())).unwrap();
            assert_eq!(smooth.sources.len(), points, "{degrees}");
            assert_eq!(smooth.normals.len(), points);
        }
    }

    #[test]
    fn groups_decide_where_a_file_has_them() {
        let (positions, triangles) = fold(50.0);
        for (groups, points) in [([1, 1], 4), ([1, 2], 6), ([0, 0], 6)] {
            let smooth = Crease::of_groups(&groups)
                .split(&positions, &triangles, &Budget::new(&Limits::default()))
                .unwrap();
            assert_eq!(smooth.sources.len(), points, "{groups:?}");
        }
    }

    #[test]
    fn points_at_one_place_are_smooth_together() {
        let (mut positions, mut triangles) = fold(20.0);
        positions.extend([positions[0], positions[1]]);
        triangles[1] = [4, 5, 3];
        let smooth =
            Crease::new(35.0).split(&positions, &triangles, &Budget::new(&Limits::default())).unwrap();
        assert_eq!(smooth.sources.len(), 6);
        let normal_of_old = |old| smooth.normals[smooth.sources.iter().position(|&s| s == old).unwrap()];
        assert_eq!(normal_of_old(0), normal_of_old(4));
    }
}
