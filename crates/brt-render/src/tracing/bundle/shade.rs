//! How what a bundle meets looks: one primitive, or flat ones of one material.

use brt_geometry::{LANES, LaneMask, LaneRays, Lanes, Primitive, Ray, Real, Vec3};
use brt_image::Rgb;

use super::hits::Hits;
use super::starts::Starts;
use super::{Bundle, Colors, NO_COLORS, NOWHERE, PACKETS, lift, set_color, set_lane};
use crate::products::{PreparedMaterial, PreparedScene};
use crate::tracing::illumination::mirrored;
use crate::tracing::interaction::Interaction;

/// One primitive, or flat ones of one material, seen by all rays of a bundle; and working memory for what is mirrored.
pub(super) struct Seen {
    pub(super) met: Starts,
    material: u32,
    count: usize,
    pub(super) point: [Vec3<Lanes>; PACKETS],
    /// On the viewer's side.
    pub(super) normal: [Vec3<Lanes>; PACKETS],
    /// The faces' own, on the viewer's side: only where faces differ.
    pub(super) geometric_normal: [Vec3<Lanes>; PACKETS],
    pub(super) viewer: [Vec3<Lanes>; PACKETS],
    pub(super) body: Colors,
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
    #[inline(always)]
    pub(super) fn look_at(
        &mut self,
        scene: &PreparedScene,
        rays: &Bundle,
        hits: &Hits,
        primitive: u32,
        colors: &mut Colors,
    ) {
        self.met.set_sole(scene.carrier(primitive));
        self.material = scene.infos[primitive as usize].material;
        self.count = rays.count;
        let shape = &scene.primitives[primitive as usize];
        for (packet, color) in colors.iter_mut().enumerate().take(rays.packets()) {
            *color = self.look(scene, shape, packet, &rays.packet(packet), hits.t[packet]);
        }
    }

    /// The same, where each ray meets a flat primitive of its own.
    pub(super) fn look_at_each(
        &mut self,
        scene: &PreparedScene,
        rays: &Bundle,
        hits: &Hits,
        colors: &mut Colors,
    ) {
        self.material = scene.infos[hits.primitive(0) as usize].material;
        self.count = rays.count;
        let material = self.material(scene);
        let (ambient, emission) = (material.ambient, material.emission);
        for i in 0..rays.packets() * LANES {
            let met = hits.met(i);
            let here = Interaction::at(scene, &rays.ray(i), met.primitive, met.t);
            let (packet, lane) = (i / LANES, i % LANES);
            self.met.set_one(i, here.carrier);
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
    #[inline(always)]
    pub(super) fn mirror(&mut self, rays: &Bundle) {
        let Self { mirrored: bundle, normal, point, met, .. } = self;
        bundle.count = rays.count;
        bundle.starts.set(met, rays.packets());
        for packet in 0..rays.packets() {
            let direction = mirrored(rays.rays[packet].direction, normal[packet]);
            bundle.rays[packet] = LaneRays { origin: point[packet], direction };
        }
    }

    pub(super) fn packets(&self) -> usize {
        self.count.div_ceil(LANES)
    }

    #[inline(always)]
    pub(super) fn lanes(&self, packet: usize) -> LaneMask {
        LaneMask::first((self.count - packet * LANES).min(LANES))
    }
}

/// Colours of the body at points.
#[inline(always)]
fn body_at(material: &PreparedMaterial, point: &Vec3<Lanes>) -> Rgb<Lanes> {
    let Some(checker) = &material.checker else { return lift(material.color) };
    let (a, b) = checker.place(point);
    let cell = |x: f64| (x / checker.size).floor() as i64;
    let is_even = LaneMask::from_fn(|i| (cell(a.0[i]) ^ cell(b.0[i])) & 1 == 0);
    select(is_even, lift(material.color), lift(checker.color))
}

#[inline(always)]
pub(super) fn select(mask: LaneMask, yes: Rgb<Lanes>, no: Rgb<Lanes>) -> Rgb<Lanes> {
    let choose = |yes: Lanes, no: Lanes| Lanes::select(mask, yes, no);
    Rgb { r: choose(yes.r, no.r), g: choose(yes.g, no.g), b: choose(yes.b, no.b) }
}
