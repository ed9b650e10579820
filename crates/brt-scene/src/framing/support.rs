//! How far a scene reaches in a direction: all that framing needs to know about shapes.

use brt_geometry::{Affine, Vec3, vec3};

use crate::{Object, Scene, Shape};

/// The scene, measured from a point near it: what models are large is small beside their distance from the origin where
/// they stand in coordinates of a map, and would be lost in the rounding of products.
pub(super) struct Reach<'s> {
    scene: &'s Scene,
    /// What distances are measured from.
    pub(super) origin: Vec3,
    /// The same for each object, in its own space.
    anchors: Vec<Vec3>,
    bounds: Option<[Vec3; 2]>,
}

impl<'s> Reach<'s> {
    pub(super) fn of(scene: &'s Scene) -> Self {
        let bounds = scene.bounds();
        let anchors = scene.objects.iter().map(|object| object.shape.bounds().map_or(Vec3::ZERO, anchor));
        Self { scene, origin: bounds.map_or(Vec3::ZERO, anchor), anchors: anchors.collect(), bounds }
    }

    /// Greatest `(p − origin)·n` of all points of bounded objects; `None` where there are none.
    pub(super) fn along(&self, n: Vec3) -> Option<f64> {
        let objects = self.scene.objects.iter().zip(&self.anchors);
        objects.filter_map(|(object, anchor)| self.of_object(object, *anchor, n)).reduce(f64::max)
    }

    /// A distance that counts beside the scene's size, and is not lost in the rounding of its coordinates.
    pub(super) fn smallest_distance(&self) -> f64 {
        /// Share of the scene's size; where it has none, of its greatest coordinate.
        const SHARE: f64 = 1.0 / 1024.0;
        /// Share of the greatest coordinate: thousands of its last digits.
        const LEAST_SHARE: f64 = 1.0 / (1_u64 << 40) as f64;
        let Some([lo, hi]) = self.bounds else { return 1.0 };
        let greatest = largest(lo).max(largest(hi));
        match largest(hi - lo) {
            size if size > 0.0 => (size * SHARE).max(greatest * LEAST_SHARE),
            _ if greatest > 0.0 => greatest * SHARE,
            _ => 1.0,
        }
    }

    fn of_object(&self, object: &Object, anchor: Vec3, n: Vec3) -> Option<f64> {
        let from = |p: Vec3| p - self.origin;
        match &object.shape {
            Shape::Sphere { center, radius } => Some(from(*center).dot(n) + radius * n.length()),
            Shape::Plane { .. } => None,
            Shape::Polygon { outline, .. } => of_points(outline, self.origin, n),
            Shape::Disc { center, normal, radius } => Some(of_disc(from(*center), *normal, *radius, n)),
            Shape::Cylinder { base, top, radius, .. } => {
                let axis = *top - *base;
                let disc = |center| of_disc(from(center), axis, *radius, n);
                Some(disc(*base).max(disc(*top)))
            }
            Shape::Cone { base, base_radius, top, top_radius, .. } => {
                let axis = *top - *base;
                let disc = |center, radius| of_disc(from(center), axis, radius, n);
                Some(disc(*base, *base_radius).max(disc(*top, *top_radius)))
            }
            // (A·p + o)·n is (p − a)·(Aᵀ·n) + (A·a + o)·n.
            Shape::Mesh(mesh) => {
                let Affine { axes: [a, b, c], .. } = object.transform;
                let turned = vec3(a.dot(n), b.dot(n), c.dot(n));
                Some(
                    of_points(&mesh.positions, anchor, turned)? + from(object.transform.point(anchor)).dot(n),
                )
            }
        }
    }
}

fn of_points(points: &[Vec3], origin: Vec3, n: Vec3) -> Option<f64> {
    points.iter().map(|p| (*p - origin).dot(n)).reduce(f64::max)
}

/// Of a disc only the part of the direction counts that lies in its plane.
fn of_disc(center: Vec3, normal: Vec3, radius: f64, n: Vec3) -> f64 {
    let normal = normal.try_normalize().unwrap_or_default();
    center.dot(n) + radius * (n - normal * normal.dot(n)).length()
}

/// A point near a box on a grid of 16 times its size or more: differences to it are exact, and it is the origin itself for
/// what stands there.
fn anchor([lo, hi]: [Vec3; 2]) -> Vec3 {
    const FOUR_BITS: i32 = 4;
    let size = largest(hi - lo);
    if !(size > 0.0 && size.is_finite()) {
        return Vec3::ZERO;
    }
    let grid = libm::ldexp(1.0, libm::frexp(size).1 + FOUR_BITS);
    let [x, y, z] = <[f64; 3]>::from((lo + hi) * 0.5).map(|c| libm::round(c / grid) * grid);
    vec3(x, y, z)
}

fn largest(v: Vec3) -> f64 {
    v.x.abs().max(v.y.abs()).max(v.z.abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_stands_at_the_origin_is_measured_from_there() {
        assert_eq!(anchor([Vec3::ZERO, vec3(1.0, 2.0, 3.0)]), Vec3::ZERO);
        assert_eq!(anchor([vec3(-40.0, 7.0, 0.0), vec3(-33.0, 14.0, 7.0)]), Vec3::ZERO);
        assert_eq!(anchor([vec3(1e9, 0.0, 0.0), vec3(1e9 + 7.0, 7.0, 7.0)]), vec3(1e9, 0.0, 0.0));
        assert_eq!(anchor([vec3(5.0, 5.0, 5.0); 2]), Vec3::ZERO);
    }
}
