//! What a block of rays meets on one primitive: an [`Interaction`](super::Interaction) over a block.

use brt_geometry::{Mask, Ray, Real, Taylor, Vec3};
use brt_image::{Rgb, rgb};

use super::illumination::{Directions, mirrored, reflected_light};
use crate::products::{Carrier, PreparedLight, PreparedMaterial, PreparedScene};

/// The points of a primitive that a block of rays meets.
pub(crate) struct Patch<'a> {
    pub(crate) primitive: u32,
    /// What rays leave that start here.
    pub(crate) carrier: Carrier,
    pub(crate) point: Vec3<Taylor>,
    /// On the side that the rays come from.
    pub(crate) normal: Vec3<Taylor>,
    pub(crate) material: &'a PreparedMaterial,
    viewer: Vec3<Taylor>,
}

/// The ways from a patch to a light.
pub(crate) struct LightWays {
    /// From the points to the light, for one infinitely far away of unit length.
    pub(crate) towards: Vec3<Taylor>,
    /// Nothing beyond this distance (in units of `towards`) hides the light.
    pub(crate) t_max: f64,
}

impl<'a> Patch<'a> {
    /// Where rays meet a primitive at distance `t`; `None` for triangles with something between
    /// their corners, and where rays may come from both
    /// sides.
    pub(crate) fn at(scene: &'a PreparedScene, ray: &Ray<Taylor>, primitive: u32, t: Taylor) -> Option<Self> {
        let info = &scene.infos[primitive as usize];
        if !(info.is_plain() && t.c.is_finite() && t.e.is_finite()) {
            return None;
        }
        let point = ray.at(t);
        let outward = scene.primitives[primitive as usize].normal_at(point);
        let from_behind = is_above(outward.dot(ray.direction))?;
        let viewer = -(ray.direction * ray.dd.inverse_sqrt());
        let material = &scene.materials[info.material as usize];
        let normal = if from_behind { -outward } else { outward };
        Some(Self { primitive, carrier: scene.carrier(primitive), point, normal, viewer, material })
    }

    /// Where rays meet at distance `t` what shades by a normal that is known from elsewhere; on the viewer's side, and of
    /// unit length.
    pub(crate) fn with_normal(
        scene: &'a PreparedScene,
        ray: &Ray<Taylor>,
        primitive: u32,
        t: Taylor,
        normal: Vec3<Taylor>,
    ) -> Option<Self> {
        let is_known = |x: Taylor| x.c.is_finite() && x.e.is_finite();
        if ![t, normal.x, normal.y, normal.z].into_iter().all(is_known) {
            return None;
        }
        let viewer = -(ray.direction * ray.dd.inverse_sqrt());
        let material = &scene.materials[scene.infos[primitive as usize].material as usize];
        let carrier = scene.carrier(primitive);
        Some(Self { primitive, carrier, point: ray.at(t), normal, viewer, material })
    }

    /// The mirror rays.
    pub(crate) fn mirror_ray(&self, ray: &Ray<Taylor>) -> Ray<Taylor> {
        Ray::new(self.point, mirrored(ray.direction, self.normal))
    }

    pub(crate) fn ways_to(&self, light: &PreparedLight) -> LightWays {
        let (towards, t_max) = light.way_from(self.point);
        LightWays { towards, t_max }
    }

    /// Does the surface face the light: certainly, certainly not, or neither?
    pub(crate) fn faces(&self, ways: &LightWays) -> Option<bool> {
        is_above(self.normal.dot(ways.towards))
    }

    /// The colour without any light from elsewhere.
    pub(crate) fn ambient(&self, body: Rgb) -> Rgb<Taylor> {
        let ambient = constant(body) * Taylor::constant(self.material.ambient);
        let emission = self.material.emission;
        if emission == Rgb::BLACK { ambient } else { ambient + constant(emission) }
    }

    /// Light that arrives along these ways, where the surface faces it and nothing hides it.
    pub(crate) fn reflected(&self, body: Rgb, light: &PreparedLight, ways: &LightWays) -> Rgb<Taylor> {
        let directions =
            Directions { normal: self.normal, light: ways.towards.normalize(), viewer: self.viewer };
        reflected_light(self.material, constant(body), light.source(directions.light), &directions)
    }
}

/// Is a value certainly positive, certainly not, or neither?
pub(crate) fn is_above(x: Taylor) -> Option<bool> {
    let above = x.gt(Taylor::constant(0.0));
    if above.all() {
        return Some(true);
    }
    (!above.any()).then_some(false)
}

/// A colour that is the same all over a block.
pub(crate) fn constant(c: Rgb) -> Rgb<Taylor> {
    rgb(Taylor::constant(c.r), Taylor::constant(c.g), Taylor::constant(c.b))
}
