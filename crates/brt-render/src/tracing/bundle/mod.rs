//! Tracing up to 64 samples together, level by level along their mirror rays.
//!
//! Rays that meet one primitive go on together, and so do those that meet small flat ones of one material: the triangles
//! of a mesh. What they may meet next, and what may stand between them and a light, is looked up once for all of them, by
//! their shaft ([`lookup`]); that is tried by each ray, eight in lanes ([`hits`]), and so are hits shaded ([`shade`]).
//! What lanes do not know (glass, what is not wholly there, very deep mirrors) each sample finishes by itself. Every
//! sample gets the bits that [`Tracer::trace`] gives.

mod group;
mod hits;
mod lights;
mod lookup;
mod shade;
mod starts;
mod ways;

use brt_geometry::{LANES, LaneRays, Lanes, Ray, Real, Vec3, vec3};
use brt_image::{Rgb, rgb};

use self::group::{Group, group_of};
use self::hits::Hits;
pub(super) use self::lookup::Lookup;
use self::shade::Seen;
use self::starts::Starts;
use super::MOST_RAYS_PER_SAMPLE;
use super::guide::{Guide, Sight, Unguided};
use super::tracer::Tracer;
use crate::products::Carrier;
use crate::settings::Backdrop;
use crate::tracing::search::Leg;

/// Most rays of a bundle.
pub(crate) const MOST_RAYS: usize = PACKETS * LANES;

const PACKETS: usize = 8;

/// Mirror rays beyond this depth are followed one by one.
const MOST_LEVELS: u32 = 8;

/// Rays that go on together: the first `count` of these. Lanes of the last packet without a ray repeat the last one.
#[derive(Clone)]
pub(crate) struct Bundle {
    rays: [LaneRays; PACKETS],
    count: usize,
    starts: Starts,
}

/// A colour for each ray of a bundle.
pub(crate) type Colors = [Rgb<Lanes>; PACKETS];

/// Colours for [`Tracer::trace_bundle`] to fill in.
pub(crate) const NO_COLORS: Colors = [rgb(ZERO, ZERO, ZERO); PACKETS];

const ZERO: Lanes = Lanes([0.0; LANES]);
const NOWHERE: Vec3<Lanes> = vec3(ZERO, ZERO, ZERO);

/// A colour that is the same for eight rays.
#[inline(always)]
pub(crate) fn lift(c: Rgb) -> Rgb<Lanes> {
    rgb(Lanes::constant(c.r), Lanes::constant(c.g), Lanes::constant(c.b))
}

impl Default for Bundle {
    fn default() -> Self {
        let rays = [LaneRays { origin: NOWHERE, direction: NOWHERE }; PACKETS];
        Self { rays, count: 0, starts: Starts::default() }
    }
}

impl Bundle {
    /// Becomes `count` camera rays, eight at a time from `rays`; lanes beyond the last are to repeat it.
    #[inline(always)]
    pub(crate) fn set(&mut self, count: usize, mut rays: impl FnMut(usize) -> LaneRays) {
        debug_assert!((1..=MOST_RAYS).contains(&count), "{count} rays");
        self.count = count;
        self.starts.set_sole(Carrier::NOWHERE);
        (0..self.packets()).for_each(|i| self.rays[i] = rays(i));
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

    /// Becomes the rays of these bits.
    fn take(&mut self, rays: &Self, bits: u64) {
        self.count = bits.count_ones() as usize;
        self.starts.take(&rays.starts, places(bits));
        for (to, from) in places(bits) {
            let (source, target) = (&rays.rays[from / LANES], &mut self.rays[to / LANES]);
            copy_lane(&source.origin, from % LANES, &mut target.origin, to % LANES);
            copy_lane(&source.direction, from % LANES, &mut target.direction, to % LANES);
        }
    }
}

fn lane_of(v: &Vec3<Lanes>, i: usize) -> Vec3 {
    vec3(v.x.0[i], v.y.0[i], v.z.0[i])
}

fn set_lane(v: &mut Vec3<Lanes>, i: usize, to: Vec3) {
    (v.x.0[i], v.y.0[i], v.z.0[i]) = (to.x, to.y, to.z);
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

/// Where the bits that are set go when they move together, as pairs of to and from; the last is repeated to fill lanes.
fn places(bits: u64) -> impl Iterator<Item = (usize, usize)> {
    let count = bits.count_ones() as usize;
    let last = 63 - bits.leading_zeros() as usize;
    let fill = std::iter::repeat_n(last, count.next_multiple_of(LANES) - count);
    ones(bits).chain(fill).enumerate()
}

/// Working memory of a parting: rays that go on by themselves.
struct Parting {
    hits: Hits,
    rays: Bundle,
    own: Hits,
    colors: Colors,
}

impl Default for Parting {
    fn default() -> Self {
        let (hits, own) = (Hits::default(), Hits::default());
        Self { hits, rays: Bundle::default(), own, colors: NO_COLORS }
    }
}

/// Working memory of bundles, reused from level to level.
#[derive(Default)]
pub(super) struct Rooms {
    partings: Vec<Box<Parting>>,
    seen: Vec<Box<Seen>>,
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
    /// Traces camera rays, given what is known of their first hits and of what follows from there. Their alphas are noted
    /// if the backdrop is transparent.
    pub(crate) fn trace_bundle(
        &mut self,
        rays: &Bundle,
        first: Sight,
        guide: impl Guide,
        colors: &mut Colors,
    ) {
        self.counters.rays.camera += rays.count as u64;
        self.begin_alphas();
        self.follow(&Way { rays, depth: 0, guide }, first, colors);
    }

    /// Traces camera rays that are known to meet these primitives first, or nothing.
    pub(crate) fn trace_known_bundle(&mut self, rays: &Bundle, first: &[u32], colors: &mut Colors) {
        self.counters.rays.camera += rays.count as u64;
        self.begin_alphas();
        let mut parting = self.rooms.partings.pop().unwrap_or_default();
        self.find_known(&mut parting.hits, rays, first);
        self.part(&Way { rays, depth: 0, guide: Unguided }, &mut parting, colors);
        self.rooms.partings.push(parting);
    }

    /// The colours of rays.
    fn follow<G: Guide>(&mut self, way: &Way<G>, sight: Sight, colors: &mut Colors) {
        let mut parting = self.rooms.partings.pop().unwrap_or_default();
        self.find_hits(&mut parting.hits, way.rays, sight);
        self.part(way, &mut parting, colors);
        self.rooms.partings.push(parting);
    }

    /// The colours of rays whose hits are known: those that go on together do.
    fn part<G: Guide>(&mut self, way: &Way<G>, parting: &mut Parting, colors: &mut Colors) {
        let Parting { hits, rays, own, colors: part_colors } = parting;
        let all = u64::MAX >> (64 - way.rays.count);
        let mut rest = all;
        while rest != 0 {
            let (here, met) = group_of(self.simd, self.scene, hits, rest, way.rays.packets());
            rest &= !here;
            if met == Group::Nothing {
                let background = self.behind_all(way.depth, here);
                ones(here).for_each(|i| set_color(colors, i, background));
            } else if met == Group::Unknown || way.depth + 1 == MOST_LEVELS {
                self.one_by_one(way, hits, here, colors);
            } else if here == all {
                self.surface(way, hits, met, colors);
            } else {
                rays.take(way.rays, here);
                own.take(hits, here);
                self.surface(&Way { rays, ..*way }, own, met, part_colors);
                let part = ones(here).enumerate();
                part.for_each(|(from, to)| set_color(colors, to, color_at(part_colors, from)));
            }
        }
    }

    /// All samples are wholly there, until one is not.
    fn begin_alphas(&mut self) {
        if self.backdrop == Backdrop::Transparent {
            self.alphas = [1.0; MOST_RAYS];
        }
    }

    /// What rays see that meet nothing.
    fn behind_all(&mut self, depth: u32, rays: u64) -> Rgb {
        if depth > 0 {
            return self.scene.background;
        }
        if self.backdrop == Backdrop::Transparent {
            ones(rays).for_each(|i| self.alphas[i] = 0.0);
        }
        self.color_of_nothing()
    }

    /// The colours of rays that go on together.
    fn surface<G: Guide>(&mut self, way: &Way<G>, hits: &Hits, met: Group, colors: &mut Colors) {
        let Way { rays, depth, guide } = *way;
        let mut seen = self.rooms.seen.pop().unwrap_or_default();
        match met {
            Group::Primitive(primitive) => self.simd.run(
                #[inline(always)]
                || seen.look_at(self.scene, rays, hits, primitive, colors),
            ),
            _ => seen.look_at_each(self.scene, rays, hits, colors),
        }
        for (index, light) in self.scene.lights.iter().enumerate() {
            self.add_light(&seen, light, guide.lighting(index), colors);
        }
        let reflection = seen.material(self.scene).reflection;
        if reflection > 0.0 && depth < self.max_depth {
            self.counters.rays.mirror += rays.count as u64;
            self.simd.run(
                #[inline(always)]
                || seen.mirror(rays),
            );
            let Seen { mirrored, reflected, .. } = &mut *seen;
            let next = Way { rays: mirrored, depth: depth + 1, guide: guide.next() };
            self.follow(&next, guide.mirrored(), reflected);
            self.simd.run(
                #[inline(always)]
                || add(colors, reflected, reflection, rays.packets()),
            );
        }
        self.rooms.seen.push(seen);
    }

    /// Goes on with each of these rays by itself.
    fn one_by_one<G: Guide>(&mut self, way: &Way<G>, hits: &Hits, rays: u64, colors: &mut Colors) {
        for i in ones(rays) {
            self.rays_left = MOST_RAYS_PER_SAMPLE - way.depth;
            let (ray, met, bounces_left) = (way.rays.ray(i), Some(hits.met(i)), self.max_depth - way.depth);
            let color = if way.depth == 0 {
                let (color, alpha) = self.seen_by_camera(&ray, met, bounces_left, way.guide);
                self.alphas[i] = alpha;
                color
            } else {
                let leg = Leg { ray, from: way.rays.starts.of(i) };
                self.color_of(&leg, met, bounces_left, Backdrop::Scene, way.guide)
            };
            set_color(colors, i, color);
        }
    }
}

/// Adds a share of what is seen in a mirror.
#[inline(always)]
fn add(colors: &mut Colors, reflected: &Colors, share: f64, packets: usize) {
    let share = Lanes::constant(share);
    for (color, reflected) in colors.iter_mut().zip(reflected).take(packets) {
        *color = *color + *reflected * share;
    }
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
