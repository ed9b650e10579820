//! Surfaces that are partly there: what lies straight behind them, and how much light they let through.
//!
//! A ray goes straight on behind such a surface without counting as a bounce. So does light on its way: each surface that
//! it crosses takes its share, near ones first, so that the product does not depend on how they are found. A ball is
//! crossed twice.

use brt_geometry::{Ray, Vec3};
use brt_image::Rgb;

use super::guide::Unguided;
use super::interaction::{Interaction, opacity_at};
use super::tracer::Tracer;
use crate::products::{Carrier, NOTHING, PreparedLight, Step};
use crate::settings::{Backdrop, HistoryKind};

/// No way to a light is followed through more surfaces; behind them it is dark.
pub(super) const MOST_CROSSED: u32 = 1 << 12;

impl Tracer<'_> {
    /// The colour of a surface and of what is seen through it.
    pub(super) fn with_what_is_behind(
        &mut self,
        front: Rgb,
        ray: &Ray,
        here: &Interaction,
        bounces_left: u32,
        backdrop: Backdrop,
    ) -> Rgb {
        let mut color = front * here.opacity;
        let mut share = 1.0 - here.opacity;
        let (mut point, mut from) = (here.point, here.carrier);
        while share > 0.0 && self.may_follow() {
            self.counters.rays.refracted += 1;
            let ray = Ray::new(point, ray.direction);
            let Some(met) = self.search.closest(&ray, from) else {
                self.history.push(Step::Background);
                return color + self.behind(backdrop, share);
            };
            let here = Interaction::at(self.scene, &ray, met.primitive, met.t);
            let layer = self.surface_color(&ray, &here, bounces_left, Unguided);
            color = color + layer * (share * here.opacity);
            share *= 1.0 - here.opacity;
            (point, from) = (here.point, here.carrier);
        }
        color
    }

    /// The share of a light that reaches a point of a primitive which faces it; of one that is hidden, by what.
    pub(super) fn share_of_light(
        &mut self,
        light: &PreparedLight,
        mut point: Vec3,
        mut from: Carrier,
    ) -> Result<f64, u32> {
        let mut share = 1.0;
        for _ in 0..MOST_CROSSED {
            let (towards, t_max) = light.way_from(point);
            let ray = Ray::new(point, towards);
            self.counters.rays.shadow += 1;
            let Some(met) = self.search.shadower(&ray, from, t_max) else { return Ok(share) };
            let surface = self.scene.infos[met.primitive as usize].surface;
            share *= 1.0 - opacity_at(self.scene, &ray, met.primitive);
            if share == 0.0 {
                return Err(surface);
            }
            self.history.push(Step::Crossed(surface));
            (point, from) = (ray.at(met.t), self.scene.carrier(met.primitive));
        }
        Err(NOTHING)
    }

    /// Is it asked what hides a light?
    pub(super) fn asks_which(&self) -> bool {
        self.history_kind == HistoryKind::Shadower
    }
}
