//! Tracing up to 64 samples together, level by level along their mirror rays.
//!
//! Rays that meet one primitive go on together. What they may meet next, and what may stand between them and a light, is
//! looked up once for all of them, by their shaft ([`lookup`]); that is tried by each ray, eight in lanes
//! ([`hits`]), and so are hits shaded ([`shade`]). What lanes do not know (glass, smooth normals, very deep mirrors)
//! each sample finishes by itself. Every sample gets the bits that [`Tracer::trace`] gives.

mod hits;
mod lookup;
mod shade;

use brt_geometry::{LANES, LaneRays, Lanes, Ray, Real, Vec3, vec3};
use brt_image::{Rgb, rgb};

pub(super) use self::lookup::Lookup;
use self::shade::Seen;
use super::MOST_RAYS_PER_SAMPLE;
use super::guide::{Guide, Sight};
use super::search::{FROM_NOWHERE, Met};
use super::tracer::Tracer;
use crate::products::{NO_NORMALS, NOTHING, PreparedScene};

/// Most rays of a bundle.
pub(crate) const MOST_RAYS: usize = PACKETS * LANES;

const PACKETS: usize = 8;

/// Mirror rays beyond this depth are followed one by one.
const MOST_LEVELS: u32 = 8;

/// Rays that go on together: the first `count` of these. Lanes without a ray repeat the first one.
#[derive(Clone, Copy)]
pub(crate) struct Bundle {
    rays: [LaneRays; PACKETS],
    count: usize,
}

/// A colour for each ray of a bundle.
pub(crate) type Colors = [Rgb<Lanes>; PACKETS];

/// A colour that is the same for eight rays.
#[inline(always)]
pub(crate) fn lift(c: Rgb) -> Rgb<Lanes> {
    rgb(Lanes::constant(c.r), Lanes::constant(c.g), Lanes::constant(c.b))
}

impl Bundle {
    /// `count` rays, eight at a time from `rays`; those of lanes beyond the last must be numbers, too.
    pub(crate) fn new(count: usize, mut rays: impl FnMut(usize) -> LaneRays) -> Self {
        debug_assert!((1..=MOST_RAYS).contains(&count), "{count} rays");
        let mut bundle = Self::of(rays(0), count);
        (1..bundle.packets()).for_each(|i| bundle.rays[i] = rays(i));
        bundle
    }

    /// As many rays, all of them the first eight.
    fn of(first: LaneRays, count: usize) -> Self {
        Self { rays: [first; PACKETS], count }
    }

    fn packets(&self) -> usize {
        self.count.div_ceil(LANES)
    }

    #[inline(always)]
    fn packet(&self, packet: usize) -> Ray<Lanes> {
        let LaneRays { origin, direction } = self.rays[packet];
        Ray::new(origin, direction)
    }

    fn ray(&self, i: usize) -> Ray {
        let LaneRays { origin: o, direction: d } = &self.rays[i / LANES];
        Ray::new(lane_of(o, i % LANES), lane_of(d, i % LANES))
    }

    /// The rays of these bits.
    fn some(&self, bits: u64) -> Self {
        let first = bits.trailing_zeros() as usize;
        let ray = self.ray(first);
        let all = |v: Vec3| vec3(Lanes::constant(v.x), Lanes::constant(v.y), Lanes::constant(v.z));
        let repeated = LaneRays { origin: all(ray.origin), direction: all(ray.direction) };
        let mut part = Self::of(repeated, bits.count_ones() as usize);
        for (to, from) in ones(bits).enumerate() {
            let source = &self.rays[from / LANES];
            let target = &mut part.rays[to / LANES];
            copy_lane(&source.origin, from % LANES, &mut target.origin, to % LANES);
            copy_lane(&source.direction, from % LANES, &mut target.direction, to % LANES);
        }
        part
    }
}

fn lane_of(v: &Vec3<Lanes>, i: usize) -> Vec3 {
    vec3(v.x.0[i], v.y.0[i], v.z.0[i])
}

fn copy_lane(from: &Vec3<Lanes>, i: usize, to: &mut Vec3<Lanes>, j: usize) {
    (to.x.0[j], to.y.0[j], to.z.0[j]) = (from.x.0[i], from.y.0[i], from.z.0[i]);
}

/// Positions of the bits that are set.
fn ones(bits: u64) -> impl Iterator<Item = usize> {
    std::iter::successors(Some(bits), |&rest| Some(rest & rest.wrapping_sub(1)))
        .take_while(|&rest| rest != 0)
        .map(|rest| rest.trailing_zeros() as usize)
}

/// Rays on their way.
struct Way<'b, G> {
    rays: &'b Bundle,
    /// Mirrors behind them.
    depth: u32,
    /// What is known of what they meet next.
    guide: G,
}

impl Tracer<'_> {
    /// Traces camera rays, given what is known of their first hits and of what follows from there.
    pub(crate) fn trace_bundle(&mut self, rays: &Bundle, first: Sight, guide: impl Guide) -> Colors {
        self.counters.rays.camera += rays.count as u64;
        let mut colors = [lift(Rgb::BLACK); PACKETS];
        self.follow(&Way { rays, depth: 0, guide }, FROM_NOWHERE, first, &mut colors);
        colors
    }

    /// The colours of rays that leave a primitive.
    fn follow<G: Guide>(&mut self, way: &Way<G>, from: u32, sight: Sight, colors: &mut Colors) {
        let rays = way.rays;
        let hits = self.hits(rays, from, sight);
        let all = u64::MAX >> (64 - rays.count);
        let mut rest = all;
        while rest != 0 {
            let primitive = hits.primitive(rest.trailing_zeros() as usize);
            let here = rest & hits.that_meet(primitive);
            rest &= !here;
            if primitive == NOTHING {
                let background = self.scene.background;
                ones(here).for_each(|i| set_color(colors, i, background));
            } else if here == all {
                self.surface(way, &hits.t, primitive, colors);
            } else {
                let (part, t) = (rays.some(here), hits.some(here));
                let mut own = [lift(Rgb::BLACK); PACKETS];
                self.surface(&Way { rays: &part, ..*way }, &t, primitive, &mut own);
                ones(here).enumerate().for_each(|(from, to)| set_color(colors, to, color_at(&own, from)));
            }
        }
    }

    /// The colours of rays that all meet one primitive, at these distances.
    fn surface<G: Guide>(&mut self, way: &Way<G>, t: &[Lanes; PACKETS], primitive: u32, colors: &mut Colors) {
        let Way { rays, depth, guide } = *way;
        if depth + 1 == MOST_LEVELS || !is_known_to_lanes(self.scene, primitive) {
            return self.one_by_one(way, t, primitive, colors);
        }
        let mut seen = Seen::at(self.scene, rays, t, primitive);
        for (index, light) in self.scene.lights.iter().enumerate() {
            self.add_light(&mut seen, light, guide.lighting(index));
        }
        let reflection = seen.material.reflection;
        if reflection > 0.0 && depth < self.max_depth {
            self.counters.rays.mirror += rays.count as u64;
            let mut reflected = [lift(Rgb::BLACK); PACKETS];
            let next = Way { rays: &seen.mirrored(rays), depth: depth + 1, guide: guide.next() };
            self.follow(&next, primitive, guide.mirrored(), &mut reflected);
            seen.add(&reflected, reflection);
        }
        *colors = seen.color;
    }

    /// Goes on with each ray by itself.
    fn one_by_one<G: Guide>(
        &mut self,
        way: &Way<G>,
        t: &[Lanes; PACKETS],
        primitive: u32,
        colors: &mut Colors,
    ) {
        for i in 0..way.rays.count {
            let met = Met { primitive, t: t[i / LANES].0[i % LANES] };
            self.rays_left = MOST_RAYS_PER_SAMPLE - way.depth;
            let bounces_left = self.max_depth - way.depth;
            let color = self.color_of(&way.rays.ray(i), Some(met), bounces_left, way.guide);
            set_color(colors, i, color);
        }
    }
}

/// Can lanes shade it?
fn is_known_to_lanes(scene: &PreparedScene, primitive: u32) -> bool {
    let info = &scene.infos[primitive as usize];
    info.normals == NO_NORMALS && scene.materials[info.material as usize].transmission == 0.0
}

/// The colour of one ray.
pub(crate) fn color_at(colors: &Colors, i: usize) -> Rgb {
    let Rgb { r, g, b } = &colors[i / LANES];
    rgb(r.0[i % LANES], g.0[i % LANES], b.0[i % LANES])
}

fn set_color(colors: &mut Colors, i: usize, color: Rgb) {
    let Rgb { r, g, b } = &mut colors[i / LANES];
    (r.0[i % LANES], g.0[i % LANES], b.0[i % LANES]) = (color.r, color.g, color.b);
}
