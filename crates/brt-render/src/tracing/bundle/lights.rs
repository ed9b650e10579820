//! The light that arrives where a bundle meets something.

use brt_geometry::{LANES, LaneMask, Lanes, Mask, Ray, Real, SimdLevel, Vec3};

use super::lookup::{ANYWHERE, Next};
use super::shade::{Seen, select};
use super::ways::Ways;
use super::{Colors, PACKETS, lane_of};
use crate::products::{LIGHT_END, PreparedLight, PreparedMaterial, PreparedScene};
use crate::tracing::guide::Lighting;
use crate::tracing::illumination::{Directions, reflected_light};
use crate::tracing::tracer::Tracer;

/// The share of a light that arrives at each point: less than 1 behind what is not wholly there.
type Shares = [Lanes; PACKETS];

impl Seen {
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
                let hit = self.met.first_hit(packet, &ray, scene, id);
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
        shares: Option<&Shares>,
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
            let source = light.source(directions.light);
            let arriving = reflected_light(material, self.body[packet], source, &directions);
            let arriving = match shares {
                Some(shares) => arriving * shares[packet],
                None => arriving,
            };
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
        let simd = self.simd;
        let mut lit = simd.run(
            #[inline(always)]
            || seen.faces(light),
        );
        if lit.iter().any(|lit| lit.any()) {
            let shares = self.hide(seen, light, lighting, &mut lit);
            let material = seen.material(self.scene);
            simd.run(
                #[inline(always)]
                || seen.shine(material, light, &lit, shares.as_deref(), colors),
            );
        }
    }

    /// Drops points that the light does not reach; shares of it if something in its ways lets some of it through.
    fn hide(
        &mut self,
        seen: &Seen,
        light: &PreparedLight,
        lighting: Lighting,
        lit: &mut [LaneMask; PACKETS],
    ) -> Option<Box<Shares>> {
        if lighting == Lighting::Seen {
            return None;
        }
        let faces = lit.iter().map(|lit| lit.count()).sum::<u64>();
        let (simd, scene) = (self.simd, self.scene);
        if let Lighting::Among(list) = lighting {
            self.counters.rays.shadow += faces;
            self.search.count_tests(faces * list.len() as u64);
            hide_in_lanes(simd, scene, seen, light, list, lit);
            return None;
        }
        let (open, mut tests, mut meets_dimmer) = (*lit, 0, false);
        let is_complete = self.lookup.shadow(scene, &seen.ways_to(light, &open), |list, _| {
            meets_dimmer |= scene.has_dimmers && list.iter().any(|&id| scene.dims(id));
            if meets_dimmer {
                return Next::Break(());
            }
            tests += list.len();
            let is_over = !hide_in_lanes(simd, scene, seen, light, list, lit);
            // What hides all may stand behind a dimmer that is still to come.
            if is_over && !scene.has_dimmers { Next::Break(()) } else { ANYWHERE }
        });
        self.search.count_tests(faces * tests as u64);
        if meets_dimmer || (!is_complete && scene.has_dimmers) {
            // From the beginning: behind a dimmer light goes on as a new ray, which rounding may lead elsewhere.
            *lit = open;
            return Some(self.search_shares(seen, light, lit));
        }
        self.counters.rays.shadow += faces;
        if !is_complete {
            self.search_shadows(seen, light, lit);
        }
        None
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

    fn search_shares(
        &mut self,
        seen: &Seen,
        light: &PreparedLight,
        lit: &mut [LaneMask; PACKETS],
    ) -> Box<Shares> {
        let mut shares = Box::new([Lanes([0.0; LANES]); PACKETS]);
        for (packet, lit) in lit.iter_mut().enumerate().take(seen.packets()) {
            *lit = LaneMask::from_fn(|lane| {
                if !lit.has(lane) {
                    return false;
                }
                let (point, from) = (lane_of(&seen.point[packet], lane), seen.met.of(packet * LANES + lane));
                let share = self.share_of_light(light, point, from);
                shares[packet].0[lane] = share.unwrap_or(0.0);
                share.is_ok()
            });
        }
        shares
    }
}

fn hide_in_lanes(
    simd: SimdLevel,
    scene: &PreparedScene,
    seen: &Seen,
    light: &PreparedLight,
    list: &[u32],
    lit: &mut [LaneMask; PACKETS],
) -> bool {
    simd.run(
        #[inline(always)]
        || seen.hide(scene, light, list, lit),
    )
}

/// Nothing beyond this distance (in units of the way to the light) hides it.
fn farthest(light: &PreparedLight) -> f64 {
    match light {
        PreparedLight::Point { .. } => LIGHT_END,
        PreparedLight::Directional { .. } => f64::INFINITY,
    }
}
