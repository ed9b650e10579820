//! The oracle: Whitted's recursion (1980) as plainly as it can be written. Never optimised.

use brt_geometry::{Ray, Vec3};
use brt_image::Rgb;

use super::MOST_RAYS_PER_SAMPLE;
use super::contact::refraction_ratio;
use super::illumination::{Directions, mirrored, reflected_light, refracted};
use super::interaction::{Interaction, opacity_at};
use super::search::Met;
use super::see_through::MOST_CROSSED;
use crate::products::{Carrier, PreparedLight, PreparedScene};

/// Colour along a camera ray before this colour, and the share of it that is seen.
pub(crate) fn reference_sample(
    scene: &PreparedScene,
    ray: &Ray,
    max_depth: u32,
    background: Rgb,
) -> (Rgb, f64) {
    let mut rays_left = MOST_RAYS_PER_SAMPLE;
    color_along(scene, ray, Carrier::NOWHERE, background, max_depth, &mut rays_left)
}

fn color_along(
    scene: &PreparedScene,
    ray: &Ray,
    from: Carrier,
    background: Rgb,
    bounces_left: u32,
    rays_left: &mut u32,
) -> (Rgb, f64) {
    let (mut ray, mut from) = (*ray, from);
    let (mut color, mut share) = (Rgb::BLACK, 1.0);
    let mut next = nearest(scene, &ray, from, f64::INFINITY, |_| true);
    loop {
        let Some(met) = next else {
            return (color + background * share, share);
        };
        let here = Interaction::at(scene, &ray, met.primitive, met.t);
        let opacity = here.opacity;
        color = color + surface_color(scene, &ray, &here, bounces_left, rays_left) * (share * opacity);
        share *= 1.0 - opacity;
        if share == 0.0 || *rays_left == 0 {
            return (color, 0.0);
        }
        *rays_left -= 1;
        next = next_in_place(scene, &ray, from, met, |_| true);
        if next.is_none() {
            (ray, from) = (Ray::new(here.point, ray.direction), here.carrier);
            next = nearest(scene, &ray, from, f64::INFINITY, |_| true);
        }
    }
}

fn surface_color(
    scene: &PreparedScene,
    ray: &Ray,
    here: &Interaction,
    bounces_left: u32,
    rays_left: &mut u32,
) -> Rgb {
    let mut color = here.body * here.material.ambient + here.material.emission;
    for light in &scene.lights {
        color = color + light_from(scene, light, here);
    }
    if bounces_left == 0 {
        return color;
    }
    let mut mirror_share = here.material.reflection;
    let mut through = None;
    if here.material.transmission > 0.0 {
        let ratio = refraction_ratio(scene, ray, here, |ray, passes| {
            nearest(scene, ray, Carrier::NOWHERE, f64::INFINITY, passes)
        });
        match refracted(here.viewer, here.normal, ratio) {
            Some(direction) => through = Some(Ray::new(here.point, direction)),
            None => mirror_share += here.material.transmission,
        }
    }
    if mirror_share > 0.0 && *rays_left > 0 {
        *rays_left -= 1;
        let ray = Ray::new(here.point, mirrored(ray.direction, here.normal));
        let (seen, _) = color_along(scene, &ray, here.carrier, scene.background, bounces_left - 1, rays_left);
        color = color + seen * mirror_share;
    }
    if let Some(ray) = through
        && *rays_left > 0
    {
        *rays_left -= 1;
        let (seen, _) = color_along(scene, &ray, here.carrier, scene.background, bounces_left - 1, rays_left);
        color = color + seen * here.material.transmission;
    }
    color
}

fn light_from(scene: &PreparedScene, light: &PreparedLight, here: &Interaction) -> Rgb {
    let (towards, _) = light.way_from(here.point);
    if here.normal.dot(towards) <= 0.0 || here.geometric_normal.dot(towards) <= 0.0 {
        return Rgb::BLACK;
    }
    let share = share_of_light(scene, light, here);
    if share == 0.0 {
        return Rgb::BLACK;
    }
    let directions = Directions { normal: here.normal, light: towards.normalize(), viewer: here.viewer };
    reflected_light(here.material, here.body, light.source(directions.light), &directions) * share
}

/// The share of a light that the surfaces in its way let through, near ones first.
fn share_of_light(scene: &PreparedScene, light: &PreparedLight, here: &Interaction) -> f64 {
    let casts_shadow = |id: u32| scene.infos[id as usize].casts_shadow;
    let mut share = 1.0;
    let to_light = |point: Vec3| Ray::new(point, light.way_from(point).0);
    let (mut ray, mut from) = (to_light(here.point), here.carrier);
    let mut next = nearest(scene, &ray, from, light.way_from(ray.origin).1, casts_shadow);
    for _ in 0..MOST_CROSSED {
        let Some(met) = next else { return share };
        share *= 1.0 - opacity_at(scene, &ray, met.primitive);
        if share == 0.0 {
            return 0.0;
        }
        next = next_in_place(scene, &ray, from, met, casts_shadow);
        if next.is_none() {
            (ray, from) = (to_light(ray.at(met.t)), scene.carrier(met.primitive));
            next = nearest(scene, &ray, from, light.way_from(ray.origin).1, casts_shadow);
        }
    }
    0.0
}

/// Of primitives that lie upon each other the next that a ray meets where it has met one: after it has left their carrier it
/// meets none of them any more.
fn next_in_place(
    scene: &PreparedScene,
    ray: &Ray,
    from: Carrier,
    met: Met,
    counts: impl Fn(u32) -> bool,
) -> Option<Met> {
    let carrier = scene.carrier(met.primitive);
    let comes_next = |id: u32| id > met.primitive && scene.carrier(id) == carrier && counts(id);
    nearest(scene, ray, from, f64::INFINITY, comes_next).filter(|next| next.t == met.t)
}

fn nearest(
    scene: &PreparedScene,
    ray: &Ray,
    from: Carrier,
    t_max: f64,
    counts: impl Fn(u32) -> bool,
) -> Option<Met> {
    let mut best = Met::nothing_before(t_max);
    for id in (0..scene.primitives.len() as u32).filter(|&id| counts(id)) {
        best.test(scene, ray, from, id);
    }
    best.found()
}
