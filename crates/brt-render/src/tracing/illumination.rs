//! The illumination model: what light makes of a material (Whitted 1980), generic over [`Real`].

use brt_geometry::{Real, Vec3};
use brt_image::Rgb;
use brt_scene::Highlight;

use crate::products::PreparedMaterial;

/// The three unit vectors that shading depends on.
pub(super) struct Directions<R> {
    /// Normal, on the viewer's side.
    pub(super) normal: Vec3<R>,
    /// To the light.
    pub(super) light: Vec3<R>,
    /// To the viewer.
    pub(super) viewer: Vec3<R>,
}

/// Light that a surface sends to the viewer from one visible source.
#[inline(always)]
pub(super) fn reflected_light<R: Real>(
    material: &PreparedMaterial,
    body: Rgb<R>,
    source: Rgb<R>,
    directions: &Directions<R>,
) -> Rgb<R> {
    let n_l = directions.normal.dot(directions.light).max(R::constant(0.0));
    let matte = body * (R::constant(material.diffuse) * n_l);
    if material.specular == 0.0 {
        return matte * source;
    }
    let shine = R::constant(material.specular) * highlight(material, directions, n_l);
    source * shine + matte * source
}

/// Strength of the highlight before the material's factor.
#[inline(always)]
fn highlight<R: Real>(material: &PreparedMaterial, directions: &Directions<R>, n_l: R) -> R {
    let Directions { normal, light, viewer } = directions;
    let cosine = match material.highlight {
        Highlight::Phong => R::constant(2.0) * n_l * normal.dot(*viewer) - light.dot(*viewer),
        Highlight::Blinn => normal.dot((*light + *viewer).normalize()),
    };
    material.exponent.power(cosine.max(R::constant(0.0)))
}

/// Direction of the mirror ray: `direction` mirrored at the plane of the unit normal, of the same length.
#[inline(always)]
pub(super) fn mirrored<R: Real>(direction: Vec3<R>, normal: Vec3<R>) -> Vec3<R> {
    direction - normal * (R::constant(2.0) * normal.dot(direction))
}

/// Direction of the refracted ray by Snell's law, of unit length; `None` for total reflection.
///
/// `viewer` and `normal` are unit vectors on the side that the light path comes from, `ratio` is the index of
/// refraction on that side over the one beyond.
#[inline(always)]
pub(super) fn refracted(viewer: Vec3, normal: Vec3, ratio: f64) -> Option<Vec3> {
    let cosine = normal.dot(viewer);
    let square = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
    (square >= 0.0).then(|| normal * (ratio * cosine - square.sqrt()) - viewer * ratio)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::prepare::prepare_material;
    use brt_geometry::vec3;
    use brt_image::rgb;
    use brt_scene::Material;

    #[test]
    fn light_from_above_on_a_matte_floor() {
        let material = prepare_material(&Material::matte("m", rgb(0.5, 0.25, 1.0)), Vec3::ZERO);
        let up = vec3(0.0, 1.0, 0.0);
        // l at 60° from the normal: n·l = 0.5; diffuse 0.8: 0.4 of the colour
        let light = vec3(0.75_f64.sqrt(), 0.5, 0.0);
        let directions = Directions { normal: up, light, viewer: up };
        let c = reflected_light(&material, material.color, Rgb::WHITE, &directions);
        assert!((c.r - 0.2).abs() < 1e-15 && (c.g - 0.1).abs() < 1e-15 && (c.b - 0.4).abs() < 1e-15);
    }

    #[test]
    fn phong_and_blinn_peak_where_they_must() {
        let shiny =
            Material { specular: 1.0, exponent: 2.0, diffuse: 0.0, ..Material::matte("m", Rgb::WHITE) };
        let mut material = prepare_material(&shiny, Vec3::ZERO);
        let up = vec3(0.0, 1.0, 0.0);
        let directions = Directions { normal: up, light: vec3(0.6, 0.8, 0.0), viewer: vec3(-0.6, 0.8, 0.0) };
        for highlight in [Highlight::Phong, Highlight::Blinn] {
            material.highlight = highlight;
            let c = reflected_light(&material, Rgb::WHITE, Rgb::WHITE, &directions);
            assert!((c.r - 1.0).abs() < 1e-14, "{highlight:?}");
        }
        // Viewer on the normal: r·v = n·l = 0.8, squared 0.64; n·h = cos(half of acos 0.8): (1 + 0.8)/2 = 0.9
        let directions = Directions { normal: up, light: vec3(0.6, 0.8, 0.0), viewer: up };
        material.highlight = Highlight::Phong;
        assert!((reflected_light(&material, Rgb::WHITE, Rgb::WHITE, &directions).r - 0.64).abs() < 1e-14);
        material.highlight = Highlight::Blinn;
        assert!((reflected_light(&material, Rgb::WHITE, Rgb::WHITE, &directions).r - 0.9).abs() < 1e-14);
    }

    #[test]
    fn refraction_follows_snell_and_ends_in_total_reflection() {
        let up = vec3(0.0, 1.0, 0.0);
        let viewer = vec3(-0.6, 0.8, 0.0);
        // sin 0.6 into 1.5: sin 0.4
        let d = refracted(viewer, up, 1.0 / 1.5).unwrap();
        assert!((d.x - 0.4).abs() < 1e-15 && d.y < 0.0 && (d.length() - 1.0).abs() < 1e-15);
        // sin 0.8 out of 1.5: 1.2 > 1
        assert!(refracted(vec3(-0.8, 0.6, 0.0), up, 1.5).is_none());
    }
}
