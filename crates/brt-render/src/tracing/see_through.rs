//! Surfaces that are partly there: what lies straight behind them, and how much light they let through.
//!
//! A ray goes straight on behind such a surface without counting as a bounce. So does light on its way: each surface that
//! it crosses takes its share, near ones first, so that the product does not depend on how they are found. A ball is
//! crossed twice. Of surfaces that lie upon each other one is crossed after the other.

use brt_geometry::{Ray, Vec3};
use brt_image::Rgb;

use super::guide::Unguided;
use super::interaction::{Interaction, opacity_at};
use super::search::{Leg, Met};
use super::tracer::Tracer;
use crate::products::{Carrier, NOTHING, PreparedLight, Step};
use crate::settings::{Backdrop, HistoryKind};

/// No way to a light is followed through more surfaces; behind them it is dark.
pub(super) const MOST_CROSSED: u32 = 1 << 12;

impl Tracer<'_> {
    /// The colour of a surface and of what is seen through it.
    pub(super) fn with_what_is_behind(
        &mut self,
        (front, opacity): (Rgb, f64),
        leg: &Leg,
        met: Met,
        bounces_left: u32,
        backdrop: Backdrop,
    ) -> Rgb {
        let (mut color, mut share) = (front * opacity, 1.0 - opacity);
        let (mut leg, mut met) = (*leg, met);
        while share > 0.0 && self.may_follow() {
            let next = self.search.next_in_place(&leg, met, |_| true).or_else(|| {
                self.counters.rays.refracted += 1;
                leg = leg.beyond(self.scene, met);
                self.search.closest(&leg.ray, leg.from)
            });
            let Some(next) = next else {
                self.history.push(Step::Background);
                return color + self.behind(backdrop, share);
            };
            met = next;
            let here = Interaction::at(self.scene, &leg.ray, met.primitive, met.t);
            let layer = self.surface_color(&leg.ray, &here, bounces_left, Unguided);
            color = color + layer * (share * here.opacity);
            share *= 1.0 - here.opacity;
        }
        color
    }

    /// The share of a light that reaches a point of a primitive which faces it; of one that is hidden, by what.
    pub(super) fn share_of_light(
        &mut self,
        light: &PreparedLight,
        point: Vec3,
        from: Carrier,
    ) -> Result<f64, u32> {
        let scene = self.scene;
        let mut share = 1.0;
        let (mut leg, mut crossed) = (Leg { ray: Ray::new(point, light.way_from(point).0), from }, None);
        for _ in 0..MOST_CROSSED {
            let casts_shadow = |id: u32| scene.infos[id as usize].casts_shadow;
            let in_place = crossed.and_then(|met| self.search.next_in_place(&leg, met, casts_shadow));
            let next = in_place.or_else(|| {
                if let Some(met) = crossed {
                    let Leg { ray, from } = leg.beyond(scene, met);
                    leg = Leg { ray: Ray::new(ray.origin, light.way_from(ray.origin).0), from };
                }
                self.counters.rays.shadow += 1;
                self.search.shadower(&leg.ray, leg.from, light.way_from(leg.ray.origin).1)
            });
            let Some(met) = next else { return Ok(share) };
            let surface = scene.infos[met.primitive as usize].surface;
            share *= 1.0 - opacity_at(scene, &leg.ray, met.primitive);
            if share == 0.0 {
                return Err(surface);
            }
            self.history.push(Step::Crossed(surface));
            crossed = Some(met);
        }
        Err(NOTHING)
    }

    /// Is it asked what hides a light?
    pub(super) fn asks_which(&self) -> bool {
        self.history_kind == HistoryKind::Shadower
    }
}
