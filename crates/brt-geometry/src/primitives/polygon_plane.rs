//! The plane of a polygon given by its points.

use crate::{FACE_FLATNESS, POLYGON_FLATNESS, Plane, SMALLEST_ANGLE, SMALLEST_LENGTH, Vec3};

/// The plane that fits a polygon's outline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PolygonPlane {
    /// Unit normal: the side from which the outline runs counter-clockwise.
    pub normal: Vec3,
    /// Mean of the outline's points.
    pub center: Vec3,
    /// Greatest distance of a point of the outline from the centre.
    pub size: f64,
    /// Twice the area as a share of the square of the size: of slivers about how thin they are.
    pub area_share: f64,
}

/// The plane of an outline by Newell's method; `None` where it has no area, or is smaller than [`SMALLEST_LENGTH`].
pub fn polygon_plane(outline: &[Vec3]) -> Option<PolygonPlane> {
    plane_however_thin(outline).filter(|plane| plane.area_share >= SMALLEST_ANGLE)
}

/// [`PolygonPlane::area_share`] of outlines however thin; 0 where there is none.
pub fn area_share(outline: &[Vec3]) -> f64 {
    plane_however_thin(outline).map_or(0.0, |plane| plane.area_share)
}

/// Newell's formula (Sutherland, Sproull, Schumacker 1974) stands for concave outlines too and averages over points
/// that are slightly off the plane. Its products are accurate, so that corners of slivers lie in their plane, too.
fn plane_however_thin(outline: &[Vec3]) -> Option<PolygonPlane> {
    let share = 1.0 / outline.len() as f64;
    let center = outline.iter().fold(Vec3::ZERO, |sum, &p| sum + p * share);
    let size = outline.iter().map(|&p| (p - center).length()).fold(0.0, f64::max);
    // Half of what points are apart, at least: what passed the check of a scene has a plane.
    if !(0.25 * SMALLEST_LENGTH..f64::INFINITY).contains(&size) {
        return None;
    }
    // Relative to the centre and the size, so that far and tiny polygons lose nothing.
    let local = |i: usize| (outline[i % outline.len()] - center) * (1.0 / size);
    let area = (0..outline.len()).fold(Vec3::ZERO, |sum, i| sum + local(i).cross_accurately(local(i + 1)));
    Some(PolygonPlane { normal: area.try_normalize()?, center, size, area_share: area.length() })
}

impl PolygonPlane {
    /// The plane itself, for a primitive with this outline.
    pub fn plane(&self) -> Plane {
        Plane::through(self.center, self.normal).for_area_share(self.area_share)
    }

    /// The greatest distance of these points from the plane as a share of the polygon's size, if it is too great for
    /// a flat polygon.
    pub fn greatest_distance(&self, points: &[Vec3]) -> Option<f64> {
        let greatest = self.flatness(points);
        (greatest > POLYGON_FLATNESS).then_some(greatest)
    }

    /// Do these points lie in the plane but for rounding?
    pub fn is_face(&self, points: &[Vec3]) -> bool {
        self.flatness(points) <= FACE_FLATNESS
    }

    fn flatness(&self, points: &[Vec3]) -> f64 {
        let off = |p: &Vec3| ((*p - self.center).dot(self.normal) / self.size).abs();
        points.iter().map(off).fold(0.0, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vec3;

    #[test]
    fn plane_of_a_concave_outline_points_to_its_front() {
        // An L in the xy plane, counter-clockwise seen from +z.
        let l = [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)]
            .map(|(x, y)| vec3(x, y, 5.0));
        let plane = polygon_plane(&l).unwrap();
        assert!((plane.normal - vec3(0.0, 0.0, 1.0)).length() < 1e-15);
        assert_eq!(plane.greatest_distance(&l), None);
    }

    #[test]
    fn points_on_a_line_have_no_plane() {
        let line = [vec3(0.0, 0.0, 0.0), vec3(1.0, 1.0, 1.0), vec3(2.0, 2.0, 2.0)];
        assert!(polygon_plane(&line).is_none());
    }
}
