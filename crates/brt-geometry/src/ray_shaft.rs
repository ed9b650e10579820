//! The shaft of rays that are given one by one, eight in lanes.

use crate::shaft::Shaft;
use crate::{COORDINATE_ROUNDING, LANES, LaneMask, Lanes, Real, Vec3, vec3};

/// Eight rays: where they start and where they go.
#[derive(Clone, Copy, Debug)]
pub struct LaneRays {
    /// Origins.
    pub origin: Vec3<Lanes>,
    /// Directions of any length.
    pub direction: Vec3<Lanes>,
}

impl Shaft {
    /// The shaft of the first `count` rays, up to distance `end` (in units of their directions), which may be infinite.
    ///
    /// `None` where the rays have no direction in common.
    #[inline(always)]
    pub fn around_rays(rays: &[LaneRays], count: usize, end: f64) -> Option<Self> {
        let axis = axis_of(rays, count)?;
        let sides = sides_of(axis, rays, count);
        let spread = Spread::of(rays, count, axis, sides)?;
        let mut shaft = Self::empty();
        for (side, [least, greatest]) in sides.into_iter().zip(spread.slopes) {
            shaft.bound(side - axis * greatest, rays, count, 0.0)?;
            shaft.bound(axis * least - side, rays, count, 0.0)?;
        }
        shaft.bound(-axis, rays, count, 0.0)?;
        if end.is_finite() {
            shaft.bound(axis, rays, count, end * spread.longest)?;
        }
        Some(shaft)
    }

    /// Adds the half-space with this normal that all origins are in, or are by no more than `beyond` out of.
    #[inline(always)]
    fn bound(&mut self, normal: Vec3, rays: &[LaneRays], count: usize, beyond: f64) -> Option<()> {
        let (mut offset, mut reach) = (Lanes::constant(f64::NEG_INFINITY), Lanes::constant(0.0));
        for_each(
            rays,
            count,
            #[inline(always)]
            |ray, lanes| {
                let o = ray.origin;
                let (x, y, z) = (
                    o.x * Lanes::constant(normal.x),
                    o.y * Lanes::constant(normal.y),
                    o.z * Lanes::constant(normal.z),
                );
                offset = Lanes::select(lanes, (x + y + z).max(offset), offset);
                reach = Lanes::select(lanes, (x.abs() + y.abs() + z.abs()).max(reach), reach);
            },
        );
        self.push_face(normal, greatest(offset) + beyond, greatest(reach) + beyond)
    }
}

/// How rays spread around an axis.
struct Spread {
    /// Least and greatest slopes to both sides.
    slopes: [[f64; 2]; 2],
    /// How far the ray goes along the axis that goes farthest, in its own unit.
    longest: f64,
}

impl Spread {
    #[inline(always)]
    fn of(rays: &[LaneRays], count: usize, axis: Vec3, sides: [Vec3; 2]) -> Option<Self> {
        let infinity = Lanes::constant(f64::INFINITY);
        let (mut least, mut most) = ([infinity; 2], [-infinity; 2]);
        let (mut shortest, mut longest) = (infinity, -infinity);
        for_each(
            rays,
            count,
            #[inline(always)]
            |ray, lanes| {
                let along = ray.direction.dot(axis.lift());
                shortest = Lanes::select(lanes, along.min(shortest), shortest);
                longest = Lanes::select(lanes, along.max(longest), longest);
                let inverse = Lanes::constant(1.0) / along;
                for i in 0..2 {
                    let slope = ray.direction.dot(sides[i].lift()) * inverse;
                    least[i] = Lanes::select(lanes, slope.min(least[i]), least[i]);
                    most[i] = Lanes::select(lanes, slope.max(most[i]), most[i]);
                }
            },
        );
        let [least, most] = [least.map(|x| -greatest(-x)), most.map(greatest)];
        let is_ahead = -greatest(-shortest) > 0.0;
        let size = 1.0 + (0..2).map(|i| least[i].abs().max(most[i].abs())).sum::<f64>();
        let margin = COORDINATE_ROUNDING * size;
        let slopes = [0, 1].map(|i| [least[i] - margin, most[i] + margin]);
        (is_ahead && size.is_finite()).then(|| Self { slopes, longest: greatest(longest) })
    }
}

#[inline(always)]
fn axis_of(rays: &[LaneRays], count: usize) -> Option<Vec3> {
    let zero = Lanes::constant(0.0);
    let mut sum = vec3(zero, zero, zero);
    for_each(
        rays,
        count,
        #[inline(always)]
        |ray, lanes| sum = Vec3::select(lanes, sum + ray.direction, sum),
    );
    let total = |x: Lanes| x.0.iter().sum::<f64>();
    vec3(total(sum.x), total(sum.y), total(sum.z)).try_normalize()
}

/// Two directions across the axis; the first along which rays follow each other.
#[inline(always)]
fn sides_of(axis: Vec3, rays: &[LaneRays], count: usize) -> [Vec3; 2] {
    let direction = |i: usize| {
        let d = &rays[i / LANES].direction;
        vec3(d.x.0[i % LANES], d.y.0[i % LANES], d.z.0[i % LANES])
    };
    let along_row = direction((LANES - 1).min(count - 1)) - direction(0);
    let across = axis.cross(along_row);
    let is_clear = across.length_squared() > 1e-12 * direction(0).length_squared();
    let first = across.try_normalize().filter(|_| is_clear).unwrap_or_else(|| axis.tangents().0);
    [first, axis.cross(first)]
}

/// Calls for eight rays at a time with those lanes that count.
#[inline(always)]
fn for_each(rays: &[LaneRays], count: usize, mut act: impl FnMut(&LaneRays, LaneMask)) {
    for (i, ray) in rays[..count.div_ceil(LANES)].iter().enumerate() {
        act(ray, LaneMask::first((count - i * LANES).min(LANES)));
    }
}

#[inline(always)]
fn greatest(lanes: Lanes) -> f64 {
    lanes.0.into_iter().fold(f64::NEG_INFINITY, f64::max)
}
