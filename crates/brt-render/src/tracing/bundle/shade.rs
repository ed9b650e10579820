//! Shading of what a bundle meets on one primitive.

use brt_geometry::{LANES, LaneMask, LaneRays, Lanes, Mask, Primitive, Ray, Real, SimdLevel, Vec3};
use brt_image::Rgb;
use brt_scene::Axis;

use super::hits::Hits;
use super::lookup::{ANYWHERE, Next};
use super::starts::Starts;
use super::ways::Ways;
use super::{Bundle, Colors, NO_COLORS, NOWHERE, PACKETS, lift, set_color, set_lane};
use crate::products::{PreparedLight, PreparedMaterial, PreparedScene};
use crate::tracing::guide::Lighting;
use crate::tracing::illumination::{Directions, mirrored, reflected_light};
use crate::tracing::interaction::Interaction;
use crate::tracing::tracer::Tracer;

/// One primitive, or flat ones of one material, seen by all rays of a bundle; and working memory for what is mirrored.
pub(super) struct Seen {
    met: Starts,
    material: u32,
    count: usize,
    point: [Vec3<Lanes>; PACKETS],
    /// On the viewer's side.
    normal: [Vec3<Lanes>; PACKETS],
    /// The faces' own, on the viewer's side: only where faces differ.
    geometric_normal: [Vec3<Lanes>; PACKETS],
    viewer: [Vec3<Lanes>; PACKETS],
    body: Colors,
    pub(super) mirrored: Bundle,
    pub(super) reflected: Colors,
}

impl Default for Seen {
    fn default() -> Self {
        Self {
            met: Starts::default(),
            material: 0,
            count: 0,
            point: [NOWHERE; PACKETS],
            normal: [NOWHERE; PACKETS],
            geometric_normal: [NOWHERE; PACKETS],
            viewer: [NOWHERE; PACKETS],
            body: NO_COLORS,
            mirrored: Bundle::default(),
            reflected: NO_COLORS,
        }
    }
}

impl Seen {
    /// Looks at what rays meet; gives the colours without any light.
    pub(super) fn look_at(
        &mut self,
        scene: &PreparedScene,
        rays: &Bundle,
        hits: &Hits,
        primitive: u32,
        colors: &mut Colors,
    ) {
        self.met.set_sole(primitive);
        self.material = scene.infos[primitive as usize].material;
        self.count = rays.count;
        SimdLevel::default().run(
            #[inline(always)]
            || {
                let shape = &scene.primitives[primitive as usize];
                for (packet, color) in colors.iter_mut().enumerate().take(rays.packets()) {
                    *color = self.look(scene, shape, packet, &rays.packet(packet), hits.t[packet]);
                }
            },
        );
    }

    /// The same, where each ray meets a flat primitive of its own.
    pub(super) fn look_at_each(
        &mut self,
        scene: &PreparedScene,
        rays: &Bundle,
        hits: &Hits,
        colors: &mut Colors,
    ) {
        self.met.set_each(hits.primitives(rays.packets()));
        self.material = scene.infos[hits.primitive(0) as usize].material;
        self.count = rays.count;
        let material = self.material(scene);
        let (ambient, emission) = (material.ambient, material.emission);
        for i in 0..rays.packets() * LANES {
            let met = hits.met(i);
            let here = Interaction::at(scene, &rays.ray(i), met.primitive, met.t);
            let (packet, lane) = (i / LANES, i % LANES);
            set_lane(&mut self.point[packet], lane, here.point);
            set_lane(&mut self.normal[packet], lane, here.normal);
            set_lane(&mut self.geometric_normal[packet], lane, here.geometric_normal);
            set_lane(&mut self.viewer[packet], lane, here.viewer);
            set_color(&mut self.body, i, here.body);
            set_color(colors, i, here.body * ambient + emission);
        }
    }

    #[inline(always)]
    fn look(
        &mut self,
        scene: &PreparedScene,
        shape: &Primitive,
        packet: usize,
        ray: &Ray<Lanes>,
        t: Lanes,
    ) -> Rgb<Lanes> {
        let point = ray.at(t);
        let outward = shape.normal_at(point);
        let from_behind = outward.dot(ray.direction).gt(Lanes::constant(0.0));
        let material = self.material(scene);
        let body = body_at(material, &point);
        self.point[packet] = point;
        self.normal[packet] = Vec3::select(from_behind, -outward, outward);
        self.viewer[packet] = -(ray.direction * ray.dd.inverse_sqrt());
        self.body[packet] = body;
        body * Lanes::constant(material.ambient) + lift(material.emission)
    }

    pub(super) fn material<'a>(&self, scene: &'a PreparedScene) -> &'a PreparedMaterial {
        &scene.materials[self.material as usize]
    }

    /// Sends on the mirror rays.
    pub(super) fn mirror(&mut self, rays: &Bundle) {
        let Self { mirrored: bundle, normal, point, met, .. } = self;
        SimdLevel::default().run(
            #[inline(always)]
            || {
                bundle.count = rays.count;
                bundle.starts.set(met, rays.packets());
                for packet in 0..rays.packets() {
                    let direction = mirrored(rays.rays[packet].direction, normal[packet]);
                    bundle.rays[packet] = LaneRays { origin: point[packet], direction };
                }
            },
        );
    }

    fn packets(&self) -> usize {
        self.count.div_ceil(LANES)
    }

    #[inline(always)]
    fn lanes(&self, packet: usize) -> LaneMask {
        LaneMask::first((self.count - packet * LANES).min(LANES))
    }

    #[inline(always)]
    fn towards(&self, packet: usize, light: &PreparedLight) -> Vec3<Lanes> {
        match light {
            PreparedLight::Point { position, .. } => position.lift() - self.point[packet],
            PreparedLight::Directional { towards, .. } => towards.lift(),
        }
    }

    /// The ways that lead to a light from the points that matter.
    fn ways_to<'s>(&'s self, light: &'s PreparedLight, lit: &'s [LaneMask; PACKETS]) -> Ways<'s> {
        let packets = self.packets();
        let normals = if self.met.differ() { &self.geometric_normal[..packets] } else { &[] };
        Ways { points: &self.point[..packets], lit: &lit[..packets], normals, light }
    }

    /// Where the surface faces a light.
    #[inline(always)]
    fn faces(&self, light: &PreparedLight) -> [LaneMask; PACKETS] {
        let mut faces = [LaneMask::FALSE; PACKETS];
        for (packet, faces) in faces.iter_mut().enumerate().take(self.packets()) {
            let towards = self.towards(packet, light);
            let rises = self.normal[packet].dot(towards);
            *faces = self.lanes(packet) & !rises.le(Lanes::constant(0.0));
            if self.met.differ() {
                let rises = self.geometric_normal[packet].dot(towards);
                *faces = *faces & !rises.le(Lanes::constant(0.0));
            }
        }
        faces
    }

    /// Drops points between which and the light one of these primitives stands; returns whether any are left.
    #[inline(always)]
    fn hide(
        &self,
        scene: &PreparedScene,
        light: &PreparedLight,
        list: &[u32],
        lit: &mut [LaneMask; PACKETS],
    ) -> bool {
        let t_max = Lanes::constant(farthest(light));
        for (packet, lit) in lit.iter_mut().enumerate().take(self.packets()) {
            if !lit.any() {
                continue;
            }
            let ray = Ray::new(self.point[packet], self.towards(packet, light));
            for &id in list {
                let hit = self.met.first_hit(packet, &ray, &scene.primitives[id as usize], id);
                *lit = *lit & !(hit.found & hit.t.lt(t_max));
                if !lit.any() {
                    break;
                }
            }
        }
        lit.iter().any(|lit| lit.any())
    }

    /// Adds the light that arrives at these points.
    #[inline(always)]
    fn shine(
        &self,
        material: &PreparedMaterial,
        light: &PreparedLight,
        lit: &[LaneMask; PACKETS],
        colors: &mut Colors,
    ) {
        for (packet, lit) in lit.iter().enumerate().take(self.packets()) {
            if !lit.any() {
                continue;
            }
            let directions = Directions {
                normal: self.normal[packet],
                light: self.towards(packet, light).normalize(),
                viewer: self.viewer[packet],
            };
            let arriving =
                reflected_light(material, self.body[packet], light.source(directions.light), &directions);
            let color = colors[packet];
            colors[packet] = select(*lit, color + arriving, color);
        }
    }
}

impl Tracer<'_> {
    /// Adds a light where nothing hides it.
    pub(super) fn add_light(
        &mut self,
        seen: &Seen,
        light: &PreparedLight,
        lighting: Lighting,
        colors: &mut Colors,
    ) {
        if lighting == Lighting::Hidden {
            return;
        }
        let mut lit = SimdLevel::default().run(
            #[inline(always)]
            || seen.faces(light),
        );
        if lit.iter().any(|lit| lit.any()) {
            self.hide(seen, light, lighting, &mut lit);
            let material = seen.material(self.scene);
            SimdLevel::default().run(
                #[inline(always)]
                || seen.shine(material, light, &lit, colors),
            );
        }
    }

    fn hide(
        &mut self,
        seen: &Seen,
        light: &PreparedLight,
        lighting: Lighting,
        lit: &mut [LaneMask; PACKETS],
    ) {
        if lighting == Lighting::Seen {
            return;
        }
        let faces = lit.iter().map(|lit| lit.count()).sum::<u64>();
        self.counters.rays.shadow += faces;
        if let Lighting::Among(list) = lighting {
            return self.hide_by(seen, light, list, faces, lit);
        }
        let (scene, open, mut tests) = (self.scene, *lit, 0);
        let is_complete = self.lookup.shadow(scene, &seen.ways_to(light, &open), |list, _| {
            tests += list.len();
            if hide_in_lanes(scene, seen, light, list, lit) { ANYWHERE } else { Next::Break(()) }
        });
        self.search.count_tests(faces * tests as u64);
        if !is_complete {
            self.search_shadows(seen, light, lit);
        }
    }

    fn hide_by(
        &mut self,
        seen: &Seen,
        light: &PreparedLight,
        list: &[u32],
        faces: u64,
        lit: &mut [LaneMask; PACKETS],
    ) {
        self.search.count_tests(faces * list.len() as u64);
        hide_in_lanes(self.scene, seen, light, list, lit);
    }

    fn search_shadows(&mut self, seen: &Seen, light: &PreparedLight, lit: &mut [LaneMask; PACKETS]) {
        let t_max = farthest(light);
        for (packet, lit) in lit.iter_mut().enumerate().take(seen.packets()) {
            let ray = Ray::new(seen.point[packet], seen.towards(packet, light));
            let search = &mut self.search;
            *lit = LaneMask::from_fn(|lane| {
                let from = seen.met.of(packet * LANES + lane);
                lit.has(lane) && !search.is_hidden(&ray.lane(lane), from, t_max)
            });
        }
    }
}

fn hide_in_lanes(
    scene: &PreparedScene,
    seen: &Seen,
    light: &PreparedLight,
    list: &[u32],
    lit: &mut [LaneMask; PACKETS],
) -> bool {
    SimdLevel::default().run(
        #[inline(always)]
        || seen.hide(scene, light, list, lit),
    )
}

/// Nothing beyond this distance (in units of the way to the light) hides it.
fn farthest(light: &PreparedLight) -> f64 {
    match light {
        PreparedLight::Point { .. } => 1.0,
        PreparedLight::Directional { .. } => f64::INFINITY,
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
fn select(mask: LaneMask, yes: Rgb<Lanes>, no: Rgb<Lanes>) -> Rgb<Lanes> {
    let choose = |yes: Lanes, no: Lanes| Lanes::select(mask, yes, no);
    Rgb { r: choose(yes.r, no.r), g: choose(yes.g, no.g), b: choose(yes.b, no.b) }
}
