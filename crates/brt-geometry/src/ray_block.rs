//! The rays of a block, and what is known of where they meet a primitive.

use crate::{Hit, Mask, Plane, Primitive, Ray, Real, Start, Taylor, Trilean, Vec3};

/// All rays of a block as one model, with what edges of flat primitives are judged by.
///
/// On which side of the edge a–b a ray passes is `d · ((a − o) × (b − o))`, the same as
/// `d · (a × b) + (o × d) · (b − a)`: with the moment `o × d` computed once, an edge costs two products with constant
/// vectors. As this is not the expression that single rays compute, a margin for the rounding of both is added.
#[derive(Clone, Copy, Debug)]
pub struct RayBlock {
    /// The rays.
    pub ray: Ray<Taylor>,
    /// Middle of the origins: coordinates count from here, so that far away nothing cancels.
    center: Vec3,
    moment: Vec3<Taylor>,
    /// Bounds of the coordinates: of directions and moments their sum, of origins the greatest.
    direction_size: f64,
    moment_size: f64,
    origin_size: f64,
}

/// Roundings of an edge function by single rays, and of the vectors that stand for it here.
const EDGE_ROUNDINGS: f64 = 64.0 * f64::EPSILON;

impl RayBlock {
    /// The block of these rays.
    pub fn new(ray: Ray<Taylor>) -> Self {
        let Ray { origin, direction, .. } = ray;
        let center = Vec3 { x: origin.x.c, y: origin.y.c, z: origin.z.c };
        let from_center = origin - center.lift();
        let moment = from_center.cross(direction);
        let sum = |[x, y, z]: [f64; 3]| x + y + z;
        Self {
            ray,
            center,
            moment,
            direction_size: sum(sizes(&direction)),
            moment_size: sum(sizes(&moment)),
            origin_size: sizes(&from_center).into_iter().fold(0.0, f64::max),
        }
    }

    /// The nearest hit ahead; encloses what [`Primitive::first_hit`] says for each of the rays.
    #[inline]
    pub fn first_hit(&self, primitive: &Primitive, start: Start) -> Hit<Taylor> {
        match primitive.flat() {
            Some((plane, corners)) if !corners.is_empty() => self.flat_hit(plane, corners, start),
            _ => primitive.first_hit(&self.ray, start),
        }
    }

    fn flat_hit(&self, plane: &Plane, corners: &[Vec3], start: Start) -> Hit<Taylor> {
        let inside = self.passes_inside(corners);
        if !inside.any() {
            return Hit::none();
        }
        let hit = plane.first_hit_of_part(&self.ray, start);
        Hit { found: hit.found & inside, t: hit.t }
    }

    /// Do the rays' lines pass inside of a convex polygon?
    fn passes_inside(&self, corners: &[Vec3]) -> Trilean {
        let (mut left, mut right) = (Trilean::TRUE, Trilean::TRUE);
        let zero = Taylor::constant(0.0);
        let mut a = corners[corners.len() - 1] - self.center;
        for corner in corners {
            let b = *corner - self.center;
            let side = self.side_of(a, b);
            left = left & side.ge(zero);
            right = right & side.le(zero);
            if !(left | right).any() {
                return Trilean::FALSE;
            }
            a = b;
        }
        left | right
    }

    #[inline(always)]
    fn side_of(&self, a: Vec3, b: Vec3) -> Taylor {
        let side = self.ray.direction.along(a.cross(b)) + self.moment.along(b - a);
        let greatest = |v: Vec3| v.x.abs().max(v.y.abs()).max(v.z.abs());
        let (a, b) = (greatest(a), greatest(b));
        let terms = self.direction_size * (a + self.origin_size) * (b + self.origin_size)
            + self.moment_size * (a + b);
        Taylor { e: side.e + EDGE_ROUNDINGS * terms, ..side }
    }
}

/// Bounds of the coordinates of all vectors.
fn sizes(v: &Vec3<Taylor>) -> [f64; 3] {
    [v.x, v.y, v.z].map(|x| x.c.abs() + x.u.abs() + x.v.abs() + x.e)
}
