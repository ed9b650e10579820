//! The shaft of rays that are given one by one, eight in lanes.

use crate::margins::CLEARLY_ACROSS;
use crate::shaft::Shaft;
use crate::{Aabb, BOX_MARGIN, COORDINATE_ROUNDING, LANES, LaneMask, Lanes, Mask, Real, Vec3, vec3};

/// Eight rays: where they start and where they go.
#[derive(Clone, Copy, Debug)]
pub struct LaneRays {
    /// Origins.
    pub origin: Vec3<Lanes>,
    /// Directions of any length.
    pub direction: Vec3<Lanes>,
}

/// No more eights of rays than this.
const MOST: usize = 8;

/// Products of coordinates up to this are finite.
const GREATEST: f64 = 1e100;

impl LaneRays {
    /// Are all coordinates numbers whose products are finite? (The least of numbers says nothing of what is not a number: a
    /// shaft around it would leave rays out.)
    #[inline(always)]
    fn are_ordinary(&self) -> bool {
        (is_ordinary(self.origin) & is_ordinary(self.direction)).all()
    }
}

#[inline(always)]
fn is_ordinary(v: Vec3<Lanes>) -> LaneMask {
    let greatest = Lanes::constant(GREATEST);
    v.x.abs().lt(greatest) & v.y.abs().lt(greatest) & v.z.abs().lt(greatest)
}

impl Shaft {
    /// The shaft of up to 64 rays, up to distance `end` (in units of their directions), which may be infinite.
    ///
    /// `None` where the rays have no direction in common, are none or more than 64, or have coordinates that are not numbers or
    /// as good as infinite.
    #[inline(always)]
    pub fn around_rays(rays: &[LaneRays], end: f64) -> Option<Self> {
        if !(1..=MOST).contains(&rays.len()) || !rays.iter().all(LaneRays::are_ordinary) {
            return None;
        }
        let axis = axis_of(rays)?;
        let sides = sides_of(axis, rays);
        let along = Range::of(
            rays,
            #[inline(always)]
            |ray| ray.direction.dot(axis.lift()),
        );
        if along.least <= 0.0 {
            return None;
        }
        let slopes = [slopes(rays, axis, sides[0]), slopes(rays, axis, sides[1])];
        let size = 1.0 + slopes[0].size() + slopes[1].size();
        let margin = COORDINATE_ROUNDING * size * size;
        let mut shaft = Self::empty();
        for (side, slope) in sides.into_iter().zip(slopes) {
            shaft.bound(side - axis * (slope.greatest + margin), rays, 0.0)?;
            shaft.bound(axis * (slope.least - margin) - side, rays, 0.0)?;
        }
        shaft.bound(-axis, rays, 0.0)?;
        if end.is_finite() {
            shaft.bound(axis, rays, end * along.greatest)?;
        }
        Some(shaft)
    }

    /// The shaft of these rays, wider by more than a hit with anything within `bounds` may lie beside its ray: by
    /// [`BOX_MARGIN`] of the greatest distance from where a ray starts to what it meets.
    #[inline(always)]
    pub fn around_rays_in(bounds: &Aabb, rays: &[LaneRays], end: f64) -> Option<Self> {
        let (center, size) = (bounds.center(), bounds.longest_side());
        let far = Range::of(
            rays,
            #[inline(always)]
            |ray| {
                let (o, d) = (ray.origin - center.lift(), ray.direction);
                let start = o.x.abs() + o.y.abs() + o.z.abs();
                let way = d.x.abs() + d.y.abs() + d.z.abs();
                if end.is_finite() { start + way * Lanes::constant(end) } else { start }
            },
        );
        Self::around_rays(rays, end)?.widened(BOX_MARGIN * (size + far.greatest))
    }

    /// The same without what lies below all points of a surface that the rays leave or arrive at, all of them on the side
    /// of this normal.
    #[inline(always)]
    pub fn above(mut self, normal: Vec3, points: &[Vec3<Lanes>]) -> Option<Self> {
        let (mut lowest, mut reach) = (f64::INFINITY, 0.0_f64);
        for point in points {
            let (x, y, z) = (
                point.x * Lanes::constant(normal.x),
                point.y * Lanes::constant(normal.y),
                point.z * Lanes::constant(normal.z),
            );
            lowest = (x + y + z).0.into_iter().fold(lowest, f64::min);
            reach = (x.abs() + y.abs() + z.abs()).0.into_iter().fold(reach, f64::max);
        }
        let offset = self.margin() * normal.length() - lowest;
        self.push_face(-normal, offset, reach)?;
        Some(self)
    }

    /// Adds the half-space with this normal that all origins are in, or are by no more than `beyond` out of.
    #[inline(always)]
    fn bound(&mut self, normal: Vec3, rays: &[LaneRays], beyond: f64) -> Option<()> {
        let offset = Range::of(
            rays,
            #[inline(always)]
            |ray| ray.origin.dot(normal.lift()),
        );
        let reach = Range::of(
            rays,
            #[inline(always)]
            |ray| {
                let (n, o) = (normal, ray.origin);
                (o.x * Lanes::constant(n.x)).abs()
                    + (o.y * Lanes::constant(n.y)).abs()
                    + (o.z * Lanes::constant(n.z)).abs()
            },
        );
        self.push_face(normal, offset.greatest + beyond, reach.greatest + beyond)
    }
}

/// The least and the greatest of numbers.
#[derive(Clone, Copy)]
struct Range {
    least: f64,
    greatest: f64,
}

impl Range {
    /// Of one number for each ray. Intermediate results stand in memory, by which the compiler sees what goes side by
    /// side.
    #[inline(always)]
    fn of(rays: &[LaneRays], number: impl Fn(&LaneRays) -> Lanes) -> Self {
        let (mut least, mut greatest) =
            ([Lanes::constant(f64::INFINITY); MOST + 1], [Lanes::constant(f64::NEG_INFINITY); MOST + 1]);
        for (i, ray) in rays.iter().enumerate().take(MOST) {
            let x = number(ray);
            least[i + 1] = x.min(least[i]);
            greatest[i + 1] = x.max(greatest[i]);
        }
        let last = rays.len().min(MOST);
        Self {
            least: least[last].0.into_iter().fold(f64::INFINITY, f64::min),
            greatest: greatest[last].0.into_iter().fold(f64::NEG_INFINITY, f64::max),
        }
    }

    fn size(self) -> f64 {
        self.least.abs().max(self.greatest.abs())
    }
}

/// How steeply rays run to a side of the axis.
#[inline(always)]
fn slopes(rays: &[LaneRays], axis: Vec3, side: Vec3) -> Range {
    Range::of(
        rays,
        #[inline(always)]
        |ray| ray.direction.dot(side.lift()) / ray.direction.dot(axis.lift()),
    )
}

/// Between the first ray and the last.
#[inline(always)]
fn axis_of(rays: &[LaneRays]) -> Option<Vec3> {
    let last = direction(rays, rays.len() * LANES - 1).try_normalize()?;
    (direction(rays, 0).try_normalize()? + last).try_normalize()
}

fn direction(rays: &[LaneRays], i: usize) -> Vec3 {
    let d = &rays[i / LANES].direction;
    vec3(d.x.0[i % LANES], d.y.0[i % LANES], d.z.0[i % LANES])
}

/// Two directions across the axis; the first along which rays follow each other.
fn sides_of(axis: Vec3, rays: &[LaneRays]) -> [Vec3; 2] {
    let along_row = direction(rays, LANES - 1) - direction(rays, 0);
    let across = axis.cross(along_row);
    let is_clear = across.length_squared() > CLEARLY_ACROSS * direction(rays, 0).length_squared();
    let first = across.try_normalize().filter(|_| is_clear).unwrap_or_else(|| axis.tangents().0);
    [first, axis.cross(first)]
}
