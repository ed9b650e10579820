//! Tracing eight samples at once, level by level along their mirror rays.
//!
//! Hits among known candidates and shading are computed in lanes, lanes on different primitives one primitive after
//! the other. What must be searched for is searched ray by ray; what lanes do not know (glass, smooth normals, very
//! deep mirrors) each sample finishes by itself. Every lane gets the bits that [`Tracer::trace`] gives.

use brt_geometry::{LaneMask, Lanes, Mask, Ray, Real, Vec3};
use brt_image::{Rgb, rgb};
use brt_scene::Axis;

use super::MOST_RAYS_PER_SAMPLE;
use super::guide::{Guide, Lighting};
use super::illumination::{Directions, mirrored, reflected_light};
use super::packet_rays::Rays;
use super::search::{FROM_NOWHERE, Met, start};
use super::tracer::Tracer;
use crate::products::{NO_NORMALS, NOTHING, PreparedMaterial, PreparedScene};

/// Mirror rays beyond this depth are followed one by one.
const MOST_LEVELS: usize = 8;

/// One primitive seen by some of the lanes.
struct Seen<'a> {
    primitive: u32,
    lanes: LaneMask,
    point: Vec3<Lanes>,
    normal: Vec3<Lanes>,
    viewer: Vec3<Lanes>,
    body: Rgb<Lanes>,
    material: &'a PreparedMaterial,
}

/// Working memory of packets: what each level adds to the colour of the level above.
pub(super) struct Levels([Level; MOST_LEVELS]);

impl Default for Levels {
    fn default() -> Self {
        let zero = Lanes::constant(0.0);
        Self([Level { local: lift(Rgb::BLACK), share: zero, goes_on: LaneMask::FALSE }; MOST_LEVELS])
    }
}

#[derive(Clone, Copy)]
struct Level {
    local: Rgb<Lanes>,
    share: Lanes,
    goes_on: LaneMask,
}

impl Tracer<'_> {
    /// Traces the camera rays of these lanes, all of which meet `first`; the other lanes' colours mean nothing.
    #[inline(always)]
    pub(crate) fn trace_packet(
        &mut self,
        ray: &Ray<Lanes>,
        lanes: LaneMask,
        first: u32,
        guide: impl Guide,
    ) -> Rgb<Lanes> {
        self.counters.rays.camera += lanes.count();
        if first == NOTHING {
            return lift(self.scene.background);
        }
        self.search.count_tests(lanes.count());
        let t = self.scene.primitives[first as usize].first_hit(ray, start(first, FROM_NOWHERE)).t;
        let mut rays = Rays { ray: *ray, primitive: Lanes::constant(f64::from(first)), t, lanes };
        let mut guide = guide;
        let mut depth = 0;
        loop {
            let (level, next) = self.level(&rays, depth, guide);
            self.levels.0[depth as usize] = level;
            if !level.goes_on.any() {
                break;
            }
            self.counters.rays.mirror += level.goes_on.count();
            rays = self.met(next, &rays.primitive, level.goes_on, guide.mirrored());
            guide = guide.next();
            depth += 1;
        }
        let (above, last) = self.levels.0.split_at(depth as usize);
        let mut color = last[0].local;
        for level in above.iter().rev() {
            color = select(level.goes_on, level.local + color * level.share, level.local);
        }
        color
    }

    /// Shades what rays meet; also gives the mirror rays.
    #[inline(always)]
    fn level(&mut self, rays: &Rays, depth: u32, guide: impl Guide) -> (Level, Ray<Lanes>) {
        let background = rays.primitive.equals(Lanes::constant(f64::from(NOTHING)));
        let mut level = Level {
            local: lift(self.scene.background),
            share: Lanes::constant(0.0),
            goes_on: LaneMask::FALSE,
        };
        let mut next = rays.ray.direction;
        let mut origin = rays.ray.origin;
        let mut rest = rays.lanes & !background;
        while let Some(lane) = rest.lanes().next() {
            let primitive = rays.primitive.0[lane] as u32;
            let here = rest & rays.primitive.equals(Lanes::constant(f64::from(primitive)));
            rest = rest & !here;
            let is_last = depth as usize + 1 == MOST_LEVELS;
            let Some(seen) = Seen::of(self.scene, rays, primitive, here).filter(|_| !is_last) else {
                level.local = select(here, self.one_by_one(rays, here, depth, guide), level.local);
                continue;
            };
            level.local = select(here, self.local(&seen, guide), level.local);
            if seen.material.reflection > 0.0 && depth < self.max_depth {
                level.share = Lanes::select(here, Lanes::constant(seen.material.reflection), level.share);
                level.goes_on = level.goes_on | here;
                origin = Vec3::select(here, seen.point, origin);
                next = Vec3::select(here, mirrored(rays.ray.direction, seen.normal), next);
            }
        }
        (level, Ray::new(origin, next))
    }

    /// Goes on with each lane by itself.
    #[inline(always)]
    fn one_by_one(&mut self, rays: &Rays, lanes: LaneMask, depth: u32, guide: impl Guide) -> Rgb<Lanes> {
        let mut color = lift(Rgb::BLACK);
        for lane in lanes.lanes() {
            let met = Met { primitive: rays.primitive.0[lane] as u32, t: rays.t.0[lane] };
            self.rays_left = MOST_RAYS_PER_SAMPLE - depth;
            let Rgb { r, g, b } =
                self.color_of(&rays.ray.lane(lane), Some(met), self.max_depth - depth, guide);
            (color.r.0[lane], color.g.0[lane], color.b.0[lane]) = (r, g, b);
        }
        color
    }

    /// The colour of a surface without what mirrors add.
    #[inline(always)]
    fn local(&mut self, seen: &Seen, guide: impl Guide) -> Rgb<Lanes> {
        let scene = self.scene;
        let mut color = seen.body * Lanes::constant(seen.material.ambient);
        for (index, light) in scene.lights.iter().enumerate() {
            let lighting = guide.lighting(index);
            if lighting == Lighting::Hidden {
                continue;
            }
            let (towards, t_max) = light.way_from(seen.point);
            let faces = seen.lanes & !seen.normal.dot(towards).le(Lanes::constant(0.0));
            let lit = self.unhidden(seen, faces, &towards, t_max, lighting);
            if !lit.any() {
                continue;
            }
            let directions =
                Directions { normal: seen.normal, light: towards.normalize(), viewer: seen.viewer };
            let arriving =
                reflected_light(seen.material, seen.body, light.source(directions.light), &directions);
            color = select(lit, color + arriving, color);
        }
        color
    }

    /// Those lanes from whose points nothing hides a light.
    #[inline(always)]
    fn unhidden(
        &mut self,
        seen: &Seen,
        faces: LaneMask,
        towards: &Vec3<Lanes>,
        t_max: f64,
        lighting: Lighting,
    ) -> LaneMask {
        if lighting == Lighting::Seen || !faces.any() {
            return faces;
        }
        self.counters.rays.shadow += faces.count();
        let ray = Ray::new(seen.point, *towards);
        let Lighting::Among(list) = lighting else {
            let search = &mut self.search;
            return LaneMask::from_fn(|lane| {
                faces.has(lane) && !search.is_hidden(&ray.lane(lane), seen.primitive, t_max)
            });
        };
        let mut lit = faces;
        for &id in list {
            self.search.count_tests(lit.count());
            let primitive = &self.scene.primitives[id as usize];
            let hit = primitive.first_hit(&ray, start(id, seen.primitive));
            lit = lit & !(hit.found & hit.t.lt(Lanes::constant(t_max)));
            if !lit.any() {
                break;
            }
        }
        lit
    }
}

impl<'a> Seen<'a> {
    /// `None` for what lanes do not know.
    #[inline(always)]
    fn of(scene: &'a PreparedScene, rays: &Rays, primitive: u32, lanes: LaneMask) -> Option<Self> {
        let info = &scene.infos[primitive as usize];
        let material = &scene.materials[info.material as usize];
        if info.normals != NO_NORMALS || material.transmission > 0.0 {
            return None;
        }
        let Rays { ray, t, .. } = rays;
        let point = ray.at(*t);
        let outward = scene.primitives[primitive as usize].normal_at(point);
        let from_behind = outward.dot(ray.direction).gt(Lanes::constant(0.0));
        Some(Self {
            primitive,
            lanes,
            point,
            normal: Vec3::select(from_behind, -outward, outward),
            viewer: -(ray.direction * ray.dd.inverse_sqrt()),
            body: body_at(material, &point),
            material,
        })
    }
}

/// Colours of the body at points.
#[inline(always)]
fn body_at(material: &PreparedMaterial, point: &Vec3<Lanes>) -> Rgb<Lanes> {
    let Some(checker) = &material.checker else { return lift(material.color) };
    let (a, b) = match checker.axis {
        Axis::X => (point.y, point.z),
        Axis::Y => (point.x, point.z),
        Axis::Z => (point.x, point.y),
    };
    let cell = |x: f64| (x / checker.size).floor() as i64;
    let is_even = LaneMask::from_fn(|i| (cell(a.0[i]) ^ cell(b.0[i])) & 1 == 0);
    select(is_even, lift(material.color), lift(checker.color))
}

#[inline(always)]
fn lift(c: Rgb) -> Rgb<Lanes> {
    rgb(Lanes::constant(c.r), Lanes::constant(c.g), Lanes::constant(c.b))
}

#[inline(always)]
fn select(mask: LaneMask, yes: Rgb<Lanes>, no: Rgb<Lanes>) -> Rgb<Lanes> {
    let [r, g, b] = [(yes.r, no.r), (yes.g, no.g), (yes.b, no.b)].map(|(y, n)| Lanes::select(mask, y, n));
    rgb(r, g, b)
}
