//! Convex polygons and triangles: a plane and edge functions.
//!
//! The edge function of two corners, `d · ((a − o) × (b − o))`, tells on which side of the edge a ray passes (Plücker
//! coordinates). Two polygons that share the edge compute exactly opposite values, so no ray slips between them.

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
        let plane = polygon_plane(&corners)?;
        Some(Self { plane: Plane::through(plane.center, plane.normal), corners })
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
    let hit = plane.first_hit_of_part(ray, start);
    if !hit.found.any() {
        return hit;
    }
    let zero = R::constant(0.0);
    let mut left = R::Mask::TRUE;
    let mut right = R::Mask::TRUE;
    for side in edge_functions(corners, ray) {
        left = left & side.ge(zero);
        right = right & side.le(zero);
        if !(left | right).any() {
            return Hit::none();
        }
    }
    Hit { found: hit.found & (left | right), t: hit.t }
}

/// On which side of each edge a ray passes: a flat primitive is met where no two of these differ in sign.
#[inline(always)]
pub fn edge_functions<R: Real>(corners: &[Vec3], ray: &Ray<R>) -> impl Iterator<Item = R> {
    let mut a = corners[corners.len() - 1].lift::<R>() - ray.origin;
    corners.iter().map(
        #[inline(always)]
        move |corner| {
            let b = corner.lift::<R>() - ray.origin;
            let side = ray.direction.dot(a.cross(b));
            a = b;
            side
        },
    )
}
