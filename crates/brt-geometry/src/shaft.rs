//! Shafts: convex bundles of rays (Haines, Wallace 1991), bounded by at most seven half-spaces. Paper: P20.

use crate::{Aabb, BOX_MARGIN, COORDINATE_ROUNDING, Primitive, Real, Taylor, Vec3};

/// A convex region that holds all rays of a block.
#[derive(Clone, Copy, Debug)]
pub struct Shaft {
    /// Two pairs of sides, what lies behind the rays' starts; after that, where it is known, what lies beyond
    /// their ends, and what lies below the surface that they leave.
    faces: [HalfSpace; MOST_FACES],
    count: usize,
    /// How far the faces were moved outward.
    margin: f64,
}

/// Sides, what lies behind and beyond, and what lies below the surface that rays leave.
pub(crate) const MOST_FACES: usize = 7;

/// Which face lies behind the starts.
const BEHIND: usize = 4;

/// All points p with `normal · p <= offset`.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct HalfSpace {
    pub(crate) normal: Vec3,
    pub(crate) offset: f64,
}

impl Shaft {
    /// The shaft of the rays from `origin` along `direction` up to distance `end`, which may be infinite.
    ///
    /// `None` where the rays have no direction in common or nothing is known of them.
    pub fn around(origin: &Vec3<Taylor>, direction: &Vec3<Taylor>, end: f64) -> Option<Self> {
        let middle = |v: &Vec3<Taylor>| Vec3 { x: v.x.c, y: v.y.c, z: v.z.c };
        let axis = middle(direction).try_normalize()?;
        let along = direction.along(axis);
        if along.range()[0].is_nan() || along.range()[0] <= 0.0 {
            return None;
        }
        let inverse = Taylor::constant(1.0) / along;
        let mut shaft = Self::empty();
        for side in sides(axis, origin, direction) {
            // Slopes of the rays against the axis; the steepest bounds them all.
            let [least, greatest] = (direction.along(side) * inverse).range();
            shaft.add(side - axis * greatest, origin)?;
            shaft.add(axis * least - side, origin)?;
        }
        shaft.add(-axis, origin)?;
        if end.is_finite() {
            let ends = origin.along(axis) + along * Taylor::constant(end);
            shaft.push(HalfSpace { normal: axis, offset: ends.range()[1] }, reach(axis, origin))?;
        }
        Some(shaft)
    }

    /// The shaft of these rays, wider by more than a hit with anything within `bounds` may lie beside its ray: by
    /// [`BOX_MARGIN`] of the greatest distance from where a ray starts to what it meets.
    pub fn around_in(
        bounds: &Aabb,
        origin: &Vec3<Taylor>,
        direction: &Vec3<Taylor>,
        end: f64,
    ) -> Option<Self> {
        let (center, size) = (bounds.center(), bounds.longest_side());
        let greatest = |x: Taylor, from: f64| {
            let [lo, hi] = x.range();
            (lo - from).abs().max((hi - from).abs())
        };
        let sum = |v: &Vec3<Taylor>, from: Vec3| {
            greatest(v.x, from.x) + greatest(v.y, from.y) + greatest(v.z, from.z)
        };
        let way = if end.is_finite() { end * sum(direction, Vec3::ZERO) } else { 0.0 };
        Self::around(origin, direction, end)?.widened(BOX_MARGIN * (size + sum(origin, center) + way))
    }

    /// The same without what lies below all points of a patch that the rays leave or arrive at, all of them on the side of
    /// this normal.
    pub fn above_points(mut self, normal: Vec3, points: &Vec3<Taylor>) -> Option<Self> {
        let offset = self.margin() * normal.length() - points.along(normal).range()[0];
        self.push(HalfSpace { normal: -normal, offset }, reach(normal, points))?;
        Some(self)
    }

    /// Adds the half-space with this normal that all origins are in.
    fn add(&mut self, normal: Vec3, origin: &Vec3<Taylor>) -> Option<()> {
        let offset = origin.along(normal).range()[1];
        self.push(HalfSpace { normal, offset }, reach(normal, origin))
    }

    /// No half-space: everything.
    pub(crate) fn empty() -> Self {
        Self { faces: [HalfSpace::default(); MOST_FACES], count: 0, margin: 0.0 }
    }

    /// Adds a half-space; its normal times the origins has terms as large as `reach`.
    pub(crate) fn push_face(&mut self, normal: Vec3, offset: f64, reach: f64) -> Option<()> {
        self.push(HalfSpace { normal, offset }, reach)
    }

    /// Where there is no room for one more, the shaft stays as large as it is.
    fn push(&mut self, face: HalfSpace, reach: f64) -> Option<()> {
        if self.count == MOST_FACES {
            return Some(());
        }
        let offset = face.offset + COORDINATE_ROUNDING * (reach + face.offset.abs());
        if !(offset.is_finite() && face.normal.is_finite()) {
            return None;
        }
        self.faces[self.count] = HalfSpace { offset, ..face };
        self.count += 1;
        Some(())
    }

    /// With all faces moved outward by this distance.
    pub(crate) fn widened(mut self, distance: f64) -> Option<Self> {
        self.margin += distance;
        for face in &mut self.faces[..self.count] {
            face.offset += distance * face.normal.length();
        }
        self.faces().iter().all(|face| face.offset.is_finite()).then_some(self)
    }

    /// The direction that all rays have a share of: a unit vector.
    pub fn axis(&self) -> Vec3 {
        -self.faces[BEHIND].normal
    }

    /// How far a point may be beside where it is exactly.
    pub fn margin(&self) -> f64 {
        self.margin
    }

    pub(crate) fn faces(&self) -> &[HalfSpace] {
        &self.faces[..self.count]
    }

    /// Is the primitive certainly outside? Never said of infinite planes.
    pub fn misses(&self, primitive: &Primitive) -> bool {
        match primitive {
            Primitive::Plane(_) => false,
            Primitive::Sphere(sphere) => self.misses_ball(sphere.center, sphere.radius),
            Primitive::Triangle(triangle) => self.misses_hull(&triangle.corners),
            Primitive::Polygon(polygon) => self.misses_hull(&polygon.corners),
            Primitive::Disc(disc) => self.misses_box(&disc.bounds()),
            Primitive::Cylinder(cylinder) => self.misses_box(&cylinder.bounds()),
            Primitive::Cone(cone) => self.misses_box(&cone.bounds()),
        }
    }

    /// Is an edge certainly outside?
    pub fn misses_edge(&self, from: Vec3, to: Vec3) -> bool {
        self.misses_hull(&[from, to])
    }

    fn misses_hull(&self, points: &[Vec3]) -> bool {
        self.faces().iter().any(|face| points.iter().all(|&p| face.excludes(p, 0.0)))
    }

    fn misses_ball(&self, center: Vec3, radius: f64) -> bool {
        self.faces().iter().any(|face| face.excludes(center, radius * face.normal.length()))
    }

    fn misses_box(&self, bounds: &Aabb) -> bool {
        self.faces().iter().any(|face| {
            let pick = |axis: usize| if face.normal[axis] > 0.0 { bounds.lo[axis] } else { bounds.hi[axis] };
            face.excludes(Vec3 { x: pick(0), y: pick(1), z: pick(2) }, 0.0)
        })
    }
}

impl HalfSpace {
    /// Is a point outside by more than `distance` (in units of the normal's length)?
    #[inline(always)]
    fn excludes(&self, point: Vec3, distance: f64) -> bool {
        let (x, y, z) = (self.normal.x * point.x, self.normal.y * point.y, self.normal.z * point.z);
        let rounding = COORDINATE_ROUNDING * (x.abs() + y.abs() + z.abs() + distance);
        x + y + z - rounding > self.offset + distance
    }
}

/// Two directions across the axis, each normal to how the rays spread in one direction of the picture.
fn sides(axis: Vec3, origin: &Vec3<Taylor>, direction: &Vec3<Taylor>) -> [Vec3; 2] {
    let (first, second) = axis.tangents();
    let across = |u: fn(&Taylor) -> f64| {
        let change = |v: &Vec3<Taylor>| Vec3 { x: u(&v.x), y: u(&v.y), z: u(&v.z) };
        axis.cross(change(direction)).try_normalize().or_else(|| axis.cross(change(origin)).try_normalize())
    };
    let (by_u, by_v) = (across(|x| x.u), across(|x| x.v));
    match (by_u, by_v) {
        // Too narrow an angle between them would leave the shaft long and wide.
        (Some(a), Some(b)) if a.dot(b).abs() < 0.9 => [a, b],
        (Some(a), _) | (None, Some(a)) => [a, axis.cross(a)],
        (None, None) => [first, second],
    }
}

/// How large the terms of `normal · origin` are.
fn reach(normal: Vec3, origin: &Vec3<Taylor>) -> f64 {
    let size = |x: Taylor| x.c.abs() + x.u.abs() + x.v.abs() + x.e;
    normal.x.abs() * size(origin.x) + normal.y.abs() * size(origin.y) + normal.z.abs() * size(origin.z)
}
