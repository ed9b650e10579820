//! Pencils: the rays of a block traced together (Shinya, Takahashi, Naito 1987).
//!
//! A pencil is an axial ray and a linear system that maps small deviations at the eye to deviations after each mirror.
//! Here both are one [`Taylor`] model per coordinate: its constant is the axial ray, its linear part the system, and its
//! remainder bounds the spread that the linear part misses. How it differs from the paper: deviations are those of the
//! block's two picture coordinates instead of all four, the error is bounded instead of estimated, and what else the
//! pencil may meet is bounded too, so that nothing is overlooked.

use brt_geometry::{Mask, Primitive, Ray, Real, Start, Taylor, Vec3};
use brt_image::Rgb;

use super::bounding_spheres::{BoundingSpheres, Bundle};
use super::patch::{Patch, constant};
use super::shadow_space::{Ball, is_beside, light_end, shadow_bundle};
use crate::products::{Carrier, PreparedLight, PreparedScene};

/// Pencils that may meet more primitives than this are split: smaller ones meet fewer.
const MOST_CANDIDATES: usize = 24;

/// Traces pencils.
pub(crate) struct PencilTracer<'a> {
    pub(crate) scene: &'a PreparedScene,
    pub(crate) spheres: &'a BoundingSpheres,
    pub(crate) max_depth: u32,
}

impl PencilTracer<'_> {
    /// Colour over a block whose samples all see `primitive` first; `None` if the pencil must be split.
    pub(crate) fn color(&self, ray: &Ray<Taylor>, primitive: u32) -> Option<Rgb<Taylor>> {
        let hit = self.scene.primitives[primitive as usize].first_hit(ray, Start::Elsewhere);
        hit.found.all().then_some(())?;
        self.color_of(ray, primitive, hit.t, self.max_depth)
    }

    /// The background as a colour over a block.
    fn background(&self) -> Rgb<Taylor> {
        constant(self.scene.background)
    }

    fn color_along(&self, ray: &Ray<Taylor>, from: Carrier, left: u32) -> Option<Rgb<Taylor>> {
        match self.nearest(ray, from)? {
            Some((primitive, t)) => self.color_of(ray, primitive, t, left),
            None => Some(self.background()),
        }
    }

    fn color_of(&self, ray: &Ray<Taylor>, primitive: u32, t: Taylor, left: u32) -> Option<Rgb<Taylor>> {
        let patch = Patch::at(self.scene, ray, primitive, t)?;
        let material = patch.material;
        // Glass splits a pencil in two and chequers cut it: rays are left to do that.
        if !material.ends_view() || material.checker.is_some() {
            return None;
        }
        let mut color = patch.ambient(material.color);
        for light in &self.scene.lights {
            let ways = patch.ways_to(light);
            if patch.faces(&ways)? && !self.is_hidden(light, &patch, ways.towards, ways.t_max)? {
                color = color + patch.reflected(material.color, light, &ways);
            }
        }
        if material.reflection == 0.0 || left == 0 {
            return Some(color);
        }
        let seen = self.color_along(&patch.mirror_ray(ray), patch.carrier, left - 1)?;
        Some(color + seen * Taylor::constant(material.reflection))
    }

    /// Is a light hidden from the whole patch (or seen from all of it)? `None` where neither is certain.
    fn is_hidden(
        &self,
        light: &PreparedLight,
        patch: &Patch,
        towards: Vec3<Taylor>,
        t_max: f64,
    ) -> Option<bool> {
        let ball = ball_around(patch.point)?;
        let end = light_end(light, ball.center, self.spheres);
        let ray = Ray::new(patch.point, towards);
        let mut is_certain = true;
        for (count, id) in self.spheres.touched_by(&shadow_bundle(&ball, end)).enumerate() {
            let primitive = &self.scene.primitives[id as usize];
            if !self.scene.infos[id as usize].casts_shadow || is_beside(primitive, &ball, light) {
                continue;
            }
            let hit = primitive.first_hit(&ray, self.scene.start(id, patch.carrier));
            // An infinite limit is met by every hit; comparing with it would say nothing.
            let before =
                if t_max.is_finite() { hit.found & hit.t.lt(Taylor::constant(t_max)) } else { hit.found };
            if before.all() && !self.scene.dims(id) {
                return Some(true);
            }
            is_certain &= !before.any();
            if count > MOST_CANDIDATES {
                return None;
            }
        }
        is_certain.then_some(false)
    }

    /// What the whole pencil meets first; `Some(None)` for the background, `None` where it is not certain.
    fn nearest(&self, ray: &Ray<Taylor>, from: Carrier) -> Option<Option<(u32, Taylor)>> {
        let bundle = bundle_around(ray)?;
        let mut hits = Vec::new();
        for id in self.spheres.touched_by(&bundle) {
            let primitive: &Primitive = &self.scene.primitives[id as usize];
            let hit = primitive.first_hit(ray, self.scene.start(id, from));
            if hit.found.any() {
                hits.push((id, hit));
            }
            if hits.len() > MOST_CANDIDATES {
                return None;
            }
        }
        let greatest = |t: Taylor| t.range()[1];
        let certain = hits.iter().filter(|(_, hit)| hit.found.all());
        let Some((front, hit)) = certain.min_by(|a, b| greatest(a.1.t).total_cmp(&greatest(b.1.t))) else {
            return hits.is_empty().then_some(None);
        };
        let is_behind =
            |(id, other): &(u32, brt_geometry::Hit<Taylor>)| id == front || hit.t.lt(other.t).all();
        hits.iter().all(is_behind).then_some(Some((*front, hit.t)))
    }
}

/// A ball around all values of a vector; `None` where it has no bound.
fn ball_around(v: Vec3<Taylor>) -> Option<Ball> {
    let deviation = |x: Taylor| {
        let [lo, hi] = x.range();
        (hi - x.c).max(x.c - lo)
    };
    let radius = Vec3 { x: deviation(v.x), y: deviation(v.y), z: deviation(v.z) }.length();
    radius.is_finite().then_some(Ball { center: Vec3 { x: v.x.c, y: v.y.c, z: v.z.c }, radius })
}

fn bundle_around(ray: &Ray<Taylor>) -> Option<Bundle> {
    let (origin, direction) = (ball_around(ray.origin)?, ball_around(ray.direction)?);
    Some(Bundle {
        origin: origin.center,
        axis: direction.center,
        spread: origin.radius,
        turn: direction.radius,
        end: f64::INFINITY,
    })
}
