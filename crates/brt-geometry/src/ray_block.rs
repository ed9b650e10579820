//! The rays of a block, and what is known of where they meet a primitive.

use crate::margins::{BLOCK_ROUNDINGS, MOMENT_ROUNDINGS};
use crate::{Hit, Mask, Plane, Primitive, Ray, Real, Sphere, Start, Taylor, Trilean, Vec3, vec3};

/// All rays of a block as one model, with their moment `o × d` (Plücker coordinates), by which edges and spheres are
/// judged.
///
/// On which side of the edge a–b a ray passes is the sign of `d · ((a − o) × (b − o))`, the same as
/// `d · (a × b) + (o × d) · (b − a)`: an edge costs two products with constant vectors. How far a ray passes from a
/// sphere's centre is the length of its moment around it over that of `d`: nothing large cancels. As these are not the
/// expressions that single rays compute, a margin for the rounding of both is added.
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

impl RayBlock {
    /// The block of these rays.
    pub fn new(ray: Ray<Taylor>) -> Self {
        let center = vec3(ray.origin.x.c, ray.origin.y.c, ray.origin.z.c);
        let from_center = ray.origin - center.lift();
        Self::around(ray, center, from_center.cross(ray.direction))
    }

    /// The block of rays to a point: their directions are the differences between it and their origins.
    pub fn to_point(ray: Ray<Taylor>, point: Vec3) -> Self {
        // But for the rounding of differences there is no moment around the point.
        let size = sizes(&ray.direction).into_iter().fold(0.0, f64::max);
        let rounding = Taylor { c: 0.0, u: 0.0, v: 0.0, e: MOMENT_ROUNDINGS * size * size };
        Self::around(ray, point, vec3(rounding, rounding, rounding))
    }

    fn around(ray: Ray<Taylor>, center: Vec3, moment: Vec3<Taylor>) -> Self {
        let Ray { origin, direction, .. } = ray;
        let from_center = origin - center.lift();
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
        match (primitive, primitive.flat()) {
            (_, Some((plane, corners))) if !corners.is_empty() => self.flat_hit(plane, corners, start),
            (Primitive::Sphere(sphere), _) if start == Start::Elsewhere => self.sphere_hit(sphere),
            _ => primitive.first_hit(&self.ray, start),
        }
    }

    /// The distance of the nearest hit where all rays are known to hit.
    #[inline]
    pub fn distance(&self, primitive: &Primitive, start: Start) -> Taylor {
        match primitive.plane() {
            Some(plane) => plane.first_hit(&self.ray, start).t,
            None => self.first_hit(primitive, start).t,
        }
    }

    fn sphere_hit(&self, sphere: &Sphere) -> Hit<Taylor> {
        let Ray { origin, direction: d, dd, inv_dd, .. } = self.ray;
        let offset = self.center - sphere.center;
        let across =
            |ay: f64, az: f64, dy: Taylor, dz: Taylor| dz * Taylor::constant(ay) - dy * Taylor::constant(az);
        let moment = self.moment
            + vec3(
                across(offset.y, offset.z, d.y, d.z),
                across(offset.z, offset.x, d.z, d.x),
                across(offset.x, offset.y, d.x, d.y),
            );
        let radius_squared = sphere.radius * sphere.radius;
        let mut discriminant = dd * Taylor::constant(radius_squared) - moment.length_squared();
        let reach = offset.length_squared() + 3.0 * self.origin_size * self.origin_size + radius_squared;
        discriminant.e += 4.0 * BLOCK_ROUNDINGS * self.direction_size * self.direction_size * reach;
        let zero = Taylor::constant(0.0);
        let meets = discriminant.ge(zero);
        if !meets.any() {
            return Hit::none();
        }
        let from_center = origin - sphere.center.lift();
        let b = from_center.dot(d);
        // Single rays compare the parts of the chord instead, which round by as much of these terms as a discriminant does.
        let mut c = from_center.length_squared() - Taylor::constant(radius_squared);
        c.e += BLOCK_ROUNDINGS * reach;
        let meets = meets & (c.le(zero) | b.lt(zero));
        if !meets.any() {
            return Hit::none();
        }
        let root = discriminant.max(zero).sqrt();
        let near = -b - root;
        let t = Taylor::select(near.gt(zero), near, root - b) * inv_dd;
        Hit::at(t, meets)
    }

    fn flat_hit(&self, plane: &Plane, corners: &[Vec3], start: Start) -> Hit<Taylor> {
        let inside = self.passes_inside(corners);
        if !inside.any() {
            return Hit::none();
        }
        let hit = plane.first_hit(&self.ray, start);
        Hit { found: hit.found & inside, t: hit.t }
    }

    /// Do the rays' lines pass inside of a convex polygon?
    fn passes_inside(&self, corners: &[Vec3]) -> Trilean {
        let (mut left, mut right) = (Trilean::TRUE, Trilean::TRUE);
        let zero = Taylor::constant(0.0);
        for side in self.sides(corners) {
            left = left & side.ge(zero);
            right = right & side.le(zero);
            if !(left | right).any() {
                return Trilean::FALSE;
            }
        }
        left | right
    }

    /// On which side of each edge the rays pass: up to a factor, the same one for all edges that a ray passes, these
    /// enclose what single rays compute.
    #[inline(always)]
    pub fn sides(&self, corners: &[Vec3]) -> impl Iterator<Item = Taylor> {
        let mut a = corners[corners.len() - 1] - self.center;
        corners.iter().map(
            #[inline(always)]
            move |corner| {
                let b = *corner - self.center;
                let side = self.side_of(a, b);
                a = b;
                side
            },
        )
    }

    #[inline(always)]
    fn side_of(&self, a: Vec3, b: Vec3) -> Taylor {
        let side = self.ray.direction.along(a.cross(b)) + self.moment.along(b - a);
        let greatest = |v: Vec3| v.x.abs().max(v.y.abs()).max(v.z.abs());
        let (a, b) = (greatest(a), greatest(b));
        let terms = self.direction_size * (a + self.origin_size) * (b + self.origin_size)
            + self.moment_size * (a + b);
        Taylor { e: side.e + BLOCK_ROUNDINGS * terms, ..side }
    }
}

/// Bounds of the coordinates of all vectors.
fn sizes(v: &Vec3<Taylor>) -> [f64; 3] {
    [v.x, v.y, v.z].map(|x| x.c.abs() + x.u.abs() + x.v.abs() + x.e)
}
