//! Tracing with all its products: colour, ray history and counts.

use brt_geometry::{Ray, Vec3};
use brt_image::Rgb;

use super::MOST_RAYS_PER_SAMPLE;
use super::illumination::{Directions, mirrored, reflected_light, refracted};
use super::interaction::Interaction;
use super::search::{FROM_NOWHERE, Met, Search};
use crate::products::Step;
use crate::products::{Counters, NOTHING, PreparedLight, PreparedScene, RayHistory};
use crate::settings::HistoryKind;

/// What is known of a camera ray before it is traced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FirstHit {
    /// Nothing: it must be searched.
    Search,
    /// The perspective image shows this primitive, or [`NOTHING`]. Paper: P4 (3).
    Known(u32),
}

/// What tracing a sample gives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TracedSample {
    pub(crate) color: Rgb,
    pub(crate) history: RayHistory,
}

/// Traces samples and counts rays.
pub(crate) struct Tracer<'a> {
    scene: &'a PreparedScene,
    search: Search<'a>,
    history_kind: HistoryKind,
    max_depth: u32,
    history: RayHistory,
    /// Bits of lights that the next hit is known to see.
    lights_seen: u64,
    /// How many mirror and refracted rays may still follow for this sample.
    rays_left: u32,
    pub(crate) counters: Counters,
}

impl<'a> Tracer<'a> {
    pub(crate) fn new(scene: &'a PreparedScene, history_kind: HistoryKind, max_depth: u32) -> Self {
        let search = Search::new(scene);
        let (history, counters) = (RayHistory::default(), Counters::default());
        Self { scene, search, history_kind, max_depth, history, lights_seen: 0, rays_left: 0, counters }
    }

    /// Everything counted since the last call.
    pub(crate) fn take_counters(&mut self) -> Counters {
        self.search.move_counts_to(&mut self.counters);
        std::mem::take(&mut self.counters)
    }

    /// Traces a camera ray. Nothing hides the lights of `lights_seen` (by bits) from its first hit.
    #[inline]
    pub(crate) fn trace(&mut self, ray: &Ray, first: FirstHit, lights_seen: u64) -> TracedSample {
        self.lights_seen = lights_seen;
        self.rays_left = MOST_RAYS_PER_SAMPLE;
        self.history = RayHistory::default();
        self.counters.rays.camera += 1;
        let met = match first {
            FirstHit::Search => self.search.closest(ray, FROM_NOWHERE),
            FirstHit::Known(NOTHING) => None,
            FirstHit::Known(primitive) => Some(self.search.known(ray, primitive)),
        };
        let color = self.color_of(ray, met, self.max_depth);
        TracedSample { color, history: self.history }
    }

    fn color_along(&mut self, ray: &Ray, from: u32, bounces_left: u32) -> Rgb {
        let met = self.search.closest(ray, from);
        self.color_of(ray, met, bounces_left)
    }

    fn color_of(&mut self, ray: &Ray, met: Option<Met>, bounces_left: u32) -> Rgb {
        let Some(met) = met else {
            self.history.push(Step::Background);
            return self.scene.background;
        };
        let here = Interaction::at(self.scene, ray, met.primitive, met.t);
        let (surface, from_behind) = (here.info.surface, here.from_behind);
        self.history.push(Step::Surface { surface, from_behind });
        if let Some(cell) = here.cell {
            self.history.push(Step::Cell(cell));
        }
        let mut color = here.body * here.material.ambient;
        let mut known = std::mem::take(&mut self.lights_seen);
        for light in &self.scene.lights {
            color = color + self.light_from(light, &here, met.primitive, known & 1 == 1);
            known >>= 1;
        }
        if here.material.is_dull() {
            return color;
        }
        if bounces_left == 0 {
            self.history.push(Step::DepthEnd);
            return color;
        }
        self.with_further_rays(color, ray, &here, met.primitive, bounces_left - 1)
    }

    /// Adds what mirror and refracted rays bring.
    fn with_further_rays(&mut self, local: Rgb, ray: &Ray, here: &Interaction, from: u32, left: u32) -> Rgb {
        let mut color = local;
        let mut mirror_share = here.material.reflection;
        let mut through = None;
        if here.material.transmission > 0.0 {
            let index = here.material.index_of_refraction;
            let ratio = if here.from_behind { index } else { 1.0 / index };
            match refracted(here.viewer, here.normal, ratio) {
                Some(direction) => through = Some(Ray::new(here.point, direction)),
                None => {
                    self.history.push(Step::TotalReflection);
                    mirror_share += here.material.transmission;
                }
            }
        }
        if mirror_share > 0.0 && self.may_follow() {
            self.counters.rays.mirror += 1;
            let ray = Ray::new(here.point, mirrored(ray.direction, here.normal));
            color = color + self.color_along(&ray, from, left) * mirror_share;
        }
        if let Some(ray) = through.filter(|_| self.may_follow()) {
            self.counters.rays.refracted += 1;
            color = color + self.color_along(&ray, from, left) * here.material.transmission;
        }
        color
    }

    fn may_follow(&mut self) -> bool {
        if self.rays_left == 0 {
            self.history.push(Step::DepthEnd);
            return false;
        }
        self.rays_left -= 1;
        true
    }

    #[inline]
    fn light_from(&mut self, light: &PreparedLight, here: &Interaction, from: u32, is_seen: bool) -> Rgb {
        let (towards, t_max, source): (Vec3, f64, Rgb) = match light {
            PreparedLight::Point { position, color } => (*position - here.point, 1.0, *color),
            PreparedLight::Directional { towards, color } => (*towards, f64::INFINITY, *color),
        };
        // A light behind the surface counts as hidden by the surface itself.
        let is_behind = here.normal.dot(towards) <= 0.0 || here.geometric_normal.dot(towards) <= 0.0;
        let hidden_by = if is_behind {
            Some(here.info.surface)
        } else if is_seen {
            None
        } else {
            self.counters.rays.shadow += 1;
            self.hiding_surface(&Ray::new(here.point, towards), from, t_max)
        };
        if let Some(surface) = hidden_by {
            let shown = if self.history_kind == HistoryKind::Shadower { surface } else { NOTHING };
            self.history.push(Step::Hidden(shown));
            return Rgb::BLACK;
        }
        self.history.push(Step::Lit);
        let directions = Directions { normal: here.normal, light: towards.normalize(), viewer: here.viewer };
        reflected_light(here.material, here.body, source, &directions)
    }

    /// The surface between a point and a light; [`NOTHING`] stands for any if histories do not ask which.
    #[inline]
    fn hiding_surface(&mut self, ray: &Ray, from: u32, t_max: f64) -> Option<u32> {
        match self.history_kind {
            HistoryKind::Lit => self.search.is_hidden(ray, from, t_max).then_some(NOTHING),
            HistoryKind::Shadower => {
                let met = self.search.shadower(ray, from, t_max)?;
                Some(self.scene.infos[met.primitive as usize].surface)
            }
        }
    }
}
