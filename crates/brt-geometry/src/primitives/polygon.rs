//! Convex polygons and triangles: a plane, and on which side of its edges rays pass.
//!
//! Corners are projected along the ray, to two coordinates; the determinant of two of them tells on which side of the
//! edge between them the ray passes (Woop, Benthin, Wald 2013). What has a corner computes the same place for it, and the
//! sign of a determinant is right or 0, since both its products round towards where they are. So no ray slips between
//! polygons that share an edge, nor through a corner that several share.

use crate::margins::AREA_ROUNDINGS;
use crate::{Aabb, Hit, Mask, Plane, Ray, Real, Start, Vec3, polygon_plane};

/// A flat convex polygon.
#[derive(Clone, Debug, PartialEq)]
pub struct Polygon {
    /// The plane that it lies in.
    pub plane: Plane,
    /// Corners, counter-clockwise seen from the front.
    pub corners: Box<[Vec3]>,
}

impl Polygon {
    /// The nearest hit ahead.
    #[inline(always)]
    pub fn first_hit<R: Real>(&self, ray: &Ray<R>, start: Start) -> Hit<R> {
        flat_hit(&self.plane, &self.corners, ray, start)
    }

    /// Smallest box around it.
    pub fn bounds(&self) -> Aabb {
        Aabb::of_points(&self.corners)
    }
}

/// A triangle, alone or of a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle {
    /// The plane that it lies in.
    pub plane: Plane,
    /// Corners, counter-clockwise seen from the front.
    pub corners: [Vec3; 3],
}

impl Triangle {
    /// The triangle with these corners; `None` where it has no area.
    pub fn new(corners: [Vec3; 3]) -> Option<Self> {
        Some(Self { plane: polygon_plane(&corners)?.plane(), corners })
    }

    /// The nearest hit ahead.
    #[inline(always)]
    pub fn first_hit<R: Real>(&self, ray: &Ray<R>, start: Start) -> Hit<R> {
        flat_hit(&self.plane, &self.corners, ray, start)
    }

    /// Weights of the three corners at the point where the ray meets the plane; they sum up to 1.
    #[inline(always)]
    pub fn weights<R: Real>(&self, ray: &Ray<R>) -> [R; 3] {
        let [a, b, c] = self.corners.map(|p| p.lift::<R>() - ray.origin);
        let d = ray.direction;
        let (wa, wb, wc) = (d.dot(b.cross(c)), d.dot(c.cross(a)), d.dot(a.cross(b)));
        let share = R::constant(1.0) / (wa + wb + wc);
        [wa * share, wb * share, wc * share]
    }

    /// Smallest box around it.
    pub fn bounds(&self) -> Aabb {
        Aabb::of_points(&self.corners)
    }
}

#[inline(always)]
fn flat_hit<R: Real>(plane: &Plane, corners: &[Vec3], ray: &Ray<R>, start: Start) -> Hit<R> {
    let hit = plane.first_hit(ray, start);
    if !hit.found.any() {
        return hit;
    }
    let zero = R::constant(0.0);
    let (mut least, mut greatest) = (R::constant(f64::INFINITY), R::constant(f64::NEG_INFINITY));
    let mut area = zero;
    let mut inside = R::Mask::TRUE;
    for side in sides(corners, ray) {
        (least, greatest, area) = (least.min(side), greatest.max(side), area + side);
        inside = least.ge(zero) | greatest.le(zero);
        if !inside.any() {
            return Hit::none();
        }
    }
    let found = hit.found & inside;
    // All corners are seen at most twice as far from the ray as the last, unless that is nearer than the polygon is large: then
    // its plane (`Plane::for_area_share`) sees to it that the area is more than rounding. So products of what is seen of two
    // corners are at most 4 times the square of how far the last is seen, and there are two for each corner.
    let [x, y] = ray.view_along()(corners[corners.len() - 1]);
    let products = (x * x + y * y) * R::constant(8.0 * corners.len() as f64);
    let is_clear = area.max(-area).gt(products * R::constant(AREA_ROUNDINGS));
    if !(found & !is_clear).any() {
        return Hit { found, t: hit.t };
    }
    Hit { found: found & (is_clear | is_seen(corners, ray)), t: hit.t }
}

/// Is the area of a polygon, as seen along a ray that passes inside, more than rounding?
///
/// Of a polygon smaller than what coordinates round by where the ray starts, corners are seen at one place. On which side of an
/// edge the ray passes is then 0 for all edges, wherever it passes: such a polygon would be met all over its plane. One that is
/// as thin would be met on all of the line that it lies on, where the sides of its long edges are rounding of either sign.
#[inline(always)]
fn is_seen<R: Real>(corners: &[Vec3], ray: &Ray<R>) -> R::Mask {
    let seen = ray.view_along();
    let (mut area, mut size) = (R::constant(0.0), R::constant(0.0));
    let mut a = seen(corners[corners.len() - 1]);
    for corner in corners {
        let b = seen(*corner);
        let (forward, backward) = (a[0] * b[1], a[1] * b[0]);
        area = area + (forward - backward);
        size = size + forward.max(-forward) + backward.max(-backward);
        a = b;
    }
    area.max(-area).gt(R::constant(AREA_ROUNDINGS) * size)
}

/// On which side of each edge a ray passes: a flat primitive is met where no two of these differ in sign.
#[inline(always)]
fn sides<R: Real>(corners: &[Vec3], ray: &Ray<R>) -> impl Iterator<Item = R> {
    let seen = ray.view_along();
    let mut a = seen(corners[corners.len() - 1]);
    corners.iter().map(
        #[inline(always)]
        move |corner| {
            let b = seen(*corner);
            let side = a[0] * b[1] - a[1] * b[0];
            a = b;
            side
        },
    )
}
