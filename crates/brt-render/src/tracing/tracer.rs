//! Tracing with all its products: colour, ray history and counts.

use brt_geometry::{Ray, SimdLevel, Vec3};
use brt_image::Rgb;

use super::MOST_RAYS_PER_SAMPLE;
use super::bundle::{Lookup, MOST_RAYS, Rooms};
use super::contact::refraction_ratio;
use super::guide::{Guide, Lighting, Sight, Unguided};
use super::illumination::{Directions, mirrored, reflected_light, refracted};
use super::interaction::Interaction;
use super::search::{Leg, Met, Search};
use crate::products::Step;
use crate::products::{Carrier, Counters, NOTHING, PreparedLight, PreparedScene, RayHistory};
use crate::settings::{Backdrop, HistoryKind};

/// What tracing a sample gives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TracedSample {
    pub(crate) color: Rgb,
    /// 1 less the share of the background that is left out.
    pub(crate) alpha: f32,
    pub(crate) history: RayHistory,
}

/// Traces samples and counts rays. Where the first hit is known it is not searched. Paper: P4, P10.
pub(crate) struct Tracer<'a> {
    pub(super) scene: &'a PreparedScene,
    pub(super) search: Search<'a>,
    pub(super) history_kind: HistoryKind,
    pub(super) max_depth: u32,
    pub(super) simd: SimdLevel,
    pub(super) lookup: Lookup,
    pub(super) rooms: Rooms,
    pub(super) history: RayHistory,
    /// How many mirror and refracted rays may still follow for this sample.
    pub(super) rays_left: u32,
    /// What camera rays see behind everything.
    pub(super) backdrop: Backdrop,
    /// The share of the background that is left out of the sample.
    pub(super) open_share: f64,
    /// Alphas of the rays of a bundle, if the backdrop is transparent.
    pub(super) alphas: [f32; MOST_RAYS],
    pub(crate) counters: Counters,
}

impl<'a> Tracer<'a> {
    pub(crate) fn new(
        scene: &'a PreparedScene,
        history_kind: HistoryKind,
        max_depth: u32,
        backdrop: Backdrop,
        simd: SimdLevel,
    ) -> Self {
        let search = Search::new(scene);
        let (history, counters) = (RayHistory::default(), Counters::default());
        Self {
            scene,
            search,
            history_kind,
            max_depth,
            simd,
            lookup: Lookup::new(simd),
            rooms: Rooms::default(),
            history,
            rays_left: 0,
            backdrop,
            open_share: 0.0,
            alphas: [1.0; MOST_RAYS],
            counters,
        }
    }

    /// Everything counted since the last call.
    pub(crate) fn take_counters(&mut self) -> Counters {
        self.search.move_counts_to(&mut self.counters);
        self.counters.nodes_visited += self.lookup.take_nodes_visited();
        std::mem::take(&mut self.counters)
    }

    /// Traces a camera ray, given what is known of its first hit and of what follows from there.
    #[inline]
    pub(crate) fn trace(&mut self, ray: &Ray, first: Sight, guide: impl Guide) -> TracedSample {
        self.rays_left = MOST_RAYS_PER_SAMPLE;
        self.history = RayHistory::default();
        self.counters.rays.camera += 1;
        let met = self.seen(ray, Carrier::NOWHERE, first);
        let (color, alpha) = self.seen_by_camera(ray, met, self.max_depth, guide);
        TracedSample { color, alpha, history: self.history }
    }

    /// The colour of a camera ray from what it meets on, and its alpha.
    pub(super) fn seen_by_camera(
        &mut self,
        ray: &Ray,
        met: Option<Met>,
        bounces_left: u32,
        guide: impl Guide,
    ) -> (Rgb, f32) {
        self.open_share = 0.0;
        let leg = Leg { ray: *ray, from: Carrier::NOWHERE };
        let color = self.color_of(&leg, met, bounces_left, self.backdrop, guide);
        (color, (1.0 - self.open_share) as f32)
    }

    /// What a share of the backdrop adds to a colour.
    pub(super) fn behind(&mut self, backdrop: Backdrop, share: f64) -> Rgb {
        match backdrop {
            Backdrop::Scene => self.scene.background * share,
            Backdrop::Transparent => {
                self.open_share = share;
                Rgb::BLACK
            }
        }
    }

    /// Alphas of the rays of the last bundle, in their order.
    pub(crate) fn alphas(&self) -> &[f32] {
        &self.alphas
    }

    /// The colour of camera rays that meet nothing.
    pub(crate) fn color_of_nothing(&self) -> Rgb {
        match self.backdrop {
            Backdrop::Scene => self.scene.background,
            Backdrop::Transparent => Rgb::BLACK,
        }
    }

    #[inline(always)]
    fn seen(&mut self, ray: &Ray, from: Carrier, sight: Sight) -> Option<Met> {
        match sight {
            Sight::Unknown => self.search.closest(ray, from),
            Sight::Among(list) => self.search.closest_of(ray, from, list),
            Sight::Met(NOTHING) => None,
            Sight::Met(primitive) => Some(self.search.known(ray, from, primitive)),
        }
    }

    /// The colour of a ray from what it meets on, given what is known of it; the backdrop is what it sees behind everything.
    pub(super) fn color_of(
        &mut self,
        leg: &Leg,
        met: Option<Met>,
        bounces_left: u32,
        backdrop: Backdrop,
        guide: impl Guide,
    ) -> Rgb {
        let Some(met) = met else {
            self.history.push(Step::Background);
            return self.behind(backdrop, 1.0);
        };
        let here = Interaction::at(self.scene, &leg.ray, met.primitive, met.t);
        let color = self.surface_color(&leg.ray, &here, bounces_left, guide);
        if here.opacity == 1.0 {
            return color;
        }
        self.with_what_is_behind((color, here.opacity), leg, met, bounces_left, backdrop)
    }

    /// The colour of a surface where a ray meets it.
    #[inline(always)]
    pub(super) fn surface_color(
        &mut self,
        ray: &Ray,
        here: &Interaction,
        bounces_left: u32,
        guide: impl Guide,
    ) -> Rgb {
        let (surface, from_behind) = (here.info.surface, here.from_behind);
        self.history.push(Step::Surface { surface, from_behind });
        if let Some(cell) = here.cell {
            self.history.push(Step::Cell(cell));
        }
        let mut color = here.body * here.material.ambient + here.material.emission;
        for (index, light) in self.scene.lights.iter().enumerate() {
            color = color + self.light_from(light, here, guide.lighting(index));
        }
        if here.material.is_dull() {
            return color;
        }
        if bounces_left == 0 {
            self.history.push(Step::DepthEnd);
            return color;
        }
        self.with_further_rays(color, ray, here, bounces_left - 1, guide)
    }

    /// Adds what mirror and refracted rays bring.
    fn with_further_rays(
        &mut self,
        local: Rgb,
        ray: &Ray,
        here: &Interaction,
        left: u32,
        guide: impl Guide,
    ) -> Rgb {
        let mut color = local;
        let mut mirror_share = here.material.reflection;
        let mut through = None;
        if here.material.transmission > 0.0 {
            let search = &mut self.search;
            let ratio =
                refraction_ratio(self.scene, ray, here, |ray, passes| search.closest_that(ray, passes));
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
            let met = self.seen(&ray, here.carrier, guide.mirrored());
            let leg = Leg { ray, from: here.carrier };
            color = color + self.color_of(&leg, met, left, Backdrop::Scene, guide.next()) * mirror_share;
        }
        if let Some(ray) = through.filter(|_| self.may_follow()) {
            self.counters.rays.refracted += 1;
            let leg = Leg { ray, from: here.carrier };
            let met = self.search.closest(&leg.ray, leg.from);
            color = color
                + self.color_of(&leg, met, left, Backdrop::Scene, Unguided) * here.material.transmission;
        }
        color
    }

    pub(super) fn may_follow(&mut self) -> bool {
        if self.rays_left == 0 {
            self.history.push(Step::DepthEnd);
            return false;
        }
        self.rays_left -= 1;
        true
    }

    #[inline]
    fn light_from(&mut self, light: &PreparedLight, here: &Interaction, lighting: Lighting) -> Rgb {
        let (towards, t_max) = light.way_from(here.point);
        // A light behind the surface counts as hidden by the surface itself.
        let is_behind = here.normal.dot(towards) <= 0.0 || here.geometric_normal.dot(towards) <= 0.0;
        let mut share = 1.0;
        let hidden_by = if is_behind {
            Some(here.info.surface)
        } else if self.scene.has_dimmers && (lighting == Lighting::Unknown || self.asks_which()) {
            self.share_of_light(light, here.point, here.carrier).map(|part| share = part).err()
        } else {
            self.hiding_surface(&here.point, &towards, here.carrier, t_max, lighting)
        };
        if let Some(surface) = hidden_by {
            let shown = if self.asks_which() { surface } else { NOTHING };
            self.history.push(Step::Hidden(shown));
            return Rgb::BLACK;
        }
        self.history.push(Step::Lit);
        let directions = Directions { normal: here.normal, light: towards.normalize(), viewer: here.viewer };
        let color = reflected_light(here.material, here.body, light.source(directions.light), &directions);
        if share == 1.0 { color } else { color * share }
    }

    /// The surface between a point and a light; [`NOTHING`] stands for any if histories do not ask which.
    #[inline]
    fn hiding_surface(
        &mut self,
        point: &Vec3,
        towards: &Vec3,
        from: Carrier,
        t_max: f64,
        lighting: Lighting,
    ) -> Option<u32> {
        let asks_which = self.asks_which();
        match lighting {
            Lighting::Seen => return None,
            Lighting::Hidden if !asks_which => return Some(NOTHING),
            _ => {}
        }
        self.counters.rays.shadow += 1;
        let ray = Ray::new(*point, *towards);
        if asks_which {
            let met = match lighting {
                Lighting::Among(list) => self.search.shadower_of(&ray, from, t_max, list),
                _ => self.search.shadower(&ray, from, t_max),
            };
            return met.map(|met| self.scene.infos[met.primitive as usize].surface);
        }
        let is_hidden = match lighting {
            Lighting::Among(list) => self.search.is_hidden_by(&ray, from, t_max, list),
            _ => self.search.is_hidden(&ray, from, t_max),
        };
        is_hidden.then_some(NOTHING)
    }
}
