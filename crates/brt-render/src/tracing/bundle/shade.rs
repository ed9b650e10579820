//! Shading of what a bundle meets on one primitive.

use brt_geometry::{LANES, LaneMask, LaneRays, Lanes, Mask, Ray, Real, SimdLevel, Vec3, vec3};
use brt_image::Rgb;
use brt_scene::Axis;

use super::{Bundle, Colors, PACKETS, lift};
use crate::products::{PreparedLight, PreparedMaterial, PreparedScene};
use crate::tracing::guide::Lighting;
use crate::tracing::illumination::{Directions, mirrored, reflected_light};
use crate::tracing::search::start;
use crate::tracing::tracer::Tracer;

/// One primitive seen by all rays of a bundle.
pub(super) struct Seen<'a> {
    primitive: u32,
    pub(super) material: &'a PreparedMaterial,
    count: usize,
    point: [Vec3<Lanes>; PACKETS],
    /// On the viewer's side.
    normal: [Vec3<Lanes>; PACKETS],
    viewer: [Vec3<Lanes>; PACKETS],
    body: Colors,
    /// What is known so far of the colours that are seen.
    pub(super) color: Colors,
}

impl<'a> Seen<'a> {
    /// What rays see at these distances, without any light.
    pub(super) fn at(scene: &'a PreparedScene, rays: &Bundle, t: &[Lanes; PACKETS], primitive: u32) -> Self {
        let material = &scene.materials[scene.infos[primitive as usize].material as usize];
        let zero = Lanes::constant(0.0);
        let nowhere = [vec3(zero, zero, zero); PACKETS];
        let dark = [lift(Rgb::BLACK); PACKETS];
        let mut seen = Self {
            primitive,
            material,
            count: rays.count,
            point: nowhere,
            normal: nowhere,
            viewer: nowhere,
            body: dark,
            color: dark,
        };
        SimdLevel::default().run(
            #[inline(always)]
            || {
                for (packet, &t) in t.iter().enumerate().take(rays.packets()) {
                    seen.look(scene, packet, &rays.packet(packet), t);
                }
            },
        );
        seen
    }

    #[inline(always)]
    fn look(&mut self, scene: &PreparedScene, packet: usize, ray: &Ray<Lanes>, t: Lanes) {
        let point = ray.at(t);
        let outward = scene.primitives[self.primitive as usize].normal_at(point);
        let from_behind = outward.dot(ray.direction).gt(Lanes::constant(0.0));
        let body = body_at(self.material, &point);
        self.point[packet] = point;
        self.normal[packet] = Vec3::select(from_behind, -outward, outward);
        self.viewer[packet] = -(ray.direction * ray.dd.inverse_sqrt());
        self.body[packet] = body;
        self.color[packet] = body * Lanes::constant(self.material.ambient);
    }

    /// The mirror rays.
    pub(super) fn mirrored(&self, rays: &Bundle) -> Bundle {
        Bundle::new(self.count, |packet| {
            let direction = SimdLevel::default().run(
                #[inline(always)]
                || mirrored(rays.rays[packet].direction, self.normal[packet]),
            );
            LaneRays { origin: self.point[packet], direction }
        })
    }

    /// Adds a share of what is seen in a mirror.
    pub(super) fn add(&mut self, reflected: &Colors, share: f64) {
        SimdLevel::default().run(
            #[inline(always)]
            || {
                let share = Lanes::constant(share);
                for (color, reflected) in
                    self.color.iter_mut().zip(reflected).take(self.count.div_ceil(LANES))
                {
                    *color = *color + *reflected * share;
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

    /// Where the surface faces a light.
    #[inline(always)]
    fn faces(&self, light: &PreparedLight) -> [LaneMask; PACKETS] {
        let mut faces = [LaneMask::FALSE; PACKETS];
        for (packet, faces) in faces.iter_mut().enumerate().take(self.packets()) {
            let rises = self.normal[packet].dot(self.towards(packet, light));
            *faces = self.lanes(packet) & !rises.le(Lanes::constant(0.0));
        }
        faces
    }

    /// Drops points between which and the light one of these primitives stands.
    #[inline(always)]
    fn hide(
        &self,
        scene: &PreparedScene,
        light: &PreparedLight,
        list: &[u32],
        lit: &mut [LaneMask; PACKETS],
    ) {
        let t_max = Lanes::constant(farthest(light));
        for (packet, lit) in lit.iter_mut().enumerate().take(self.packets()) {
            if !lit.any() {
                continue;
            }
            let ray = Ray::new(self.point[packet], self.towards(packet, light));
            for &id in list {
                let hit = scene.primitives[id as usize].first_hit(&ray, start(id, self.primitive));
                *lit = *lit & !(hit.found & hit.t.lt(t_max));
                if !lit.any() {
                    break;
                }
            }
        }
    }

    /// Adds the light that arrives at these points.
    #[inline(always)]
    fn shine(&mut self, light: &PreparedLight, lit: &[LaneMask; PACKETS]) {
        let (PreparedLight::Point { color: source, .. } | PreparedLight::Directional { color: source, .. }) =
            light;
        for (packet, lit) in lit.iter().enumerate().take(self.packets()) {
            if !lit.any() {
                continue;
            }
            let directions = Directions {
                normal: self.normal[packet],
                light: self.towards(packet, light).normalize(),
                viewer: self.viewer[packet],
            };
            let arriving = reflected_light(self.material, self.body[packet], lift(*source), &directions);
            let color = self.color[packet];
            self.color[packet] = select(*lit, color + arriving, color);
        }
    }
}

impl Tracer<'_> {
    /// Adds a light where nothing hides it.
    pub(super) fn add_light(&mut self, seen: &mut Seen, light: &PreparedLight, lighting: Lighting) {
        if lighting == Lighting::Hidden {
            return;
        }
        let mut lit = SimdLevel::default().run(
            #[inline(always)]
            || seen.faces(light),
        );
        if lit.iter().any(|lit| lit.any()) {
            self.hide(seen, light, lighting, &mut lit);
            SimdLevel::default().run(
                #[inline(always)]
                || seen.shine(light, &lit),
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
        match self.lookup.shadow(self.scene, &seen.point, seen.count, light) {
            Some(list) => {
                self.hide_by(seen, light, &list, faces, lit);
                self.lookup.give_back(list);
            }
            None => self.search_shadows(seen, light, lit),
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
        SimdLevel::default().run(
            #[inline(always)]
            || seen.hide(self.scene, light, list, lit),
        );
    }

    fn search_shadows(&mut self, seen: &Seen, light: &PreparedLight, lit: &mut [LaneMask; PACKETS]) {
        let t_max = farthest(light);
        for (packet, lit) in lit.iter_mut().enumerate().take(seen.packets()) {
            let ray = Ray::new(seen.point[packet], seen.towards(packet, light));
            let search = &mut self.search;
            *lit = LaneMask::from_fn(|lane| {
                lit.has(lane) && !search.is_hidden(&ray.lane(lane), seen.primitive, t_max)
            });
        }
    }
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
