//! What there is at the point where a ray meets a primitive.

use brt_geometry::{Primitive, Ray, Real, Vec3};
use brt_image::Rgb;

use crate::products::{
    Carrier, NO_COLORS, NO_NORMALS, NO_TEXCOORDS, PreparedMaterial, PreparedScene, PrimitiveInfo,
    TextureSample,
};

/// A point on a surface, seen along a ray.
pub(crate) struct Interaction<'a> {
    pub(crate) primitive: u32,
    /// What rays leave that start here.
    pub(crate) carrier: Carrier,
    pub(crate) point: Vec3,
    /// Unit normal of the primitive, on the side that the ray comes from.
    pub(crate) geometric_normal: Vec3,
    /// Unit normal for shading, on the same side of the surface as the geometric one.
    pub(crate) normal: Vec3,
    /// Unit vector back along the ray.
    pub(crate) viewer: Vec3,
    /// Does the ray come from behind the surface (from inside a solid)?
    pub(crate) from_behind: bool,
    pub(crate) info: &'a PrimitiveInfo,
    pub(crate) material: &'a PreparedMaterial,
    /// Colour of the body here.
    pub(crate) body: Rgb,
    /// The share of the surface that is there.
    pub(crate) opacity: f64,
    /// The square of a chequered pattern or the texel, where there is one.
    pub(crate) cell: Option<u64>,
}

impl<'a> Interaction<'a> {
    /// The point at distance `t` of a ray, where it meets a primitive.
    pub(crate) fn at(scene: &'a PreparedScene, ray: &Ray, primitive: u32, t: f64) -> Self {
        let info = &scene.infos[primitive as usize];
        let shape = &scene.primitives[primitive as usize];
        let material = &scene.materials[info.material as usize];
        let point = ray.at(t);
        let outward = shape.normal_at(point);
        let from_behind = outward.dot(ray.direction) > 0.0;
        let turn = |n: Vec3| if from_behind { -n } else { n };
        let between = Between::corners(scene, shape, info, material, ray);
        let smooth = between.normal.unwrap_or(outward);
        // Normals of files may point to the other side than the order of the corners says.
        let agrees = smooth.dot(outward) >= 0.0;
        let (mut body, mut cell) = body_at(material, point);
        if let Some(tint) = between.tint {
            body = body * tint;
        }
        let mut opacity = material.opacity;
        if let Some(texture) = between.texture {
            body = body * texture.color;
            opacity *= texture.opacity;
            cell = Some(cell.unwrap_or_default().rotate_left(1) ^ texture.texel);
        }
        Self {
            primitive,
            carrier: scene.carrier(primitive),
            point,
            geometric_normal: turn(outward),
            normal: turn(if agrees { smooth } else { -smooth }),
            viewer: -(ray.direction * ray.dd.inverse_sqrt()),
            from_behind,
            info,
            material,
            body,
            opacity,
            cell,
        }
    }
}

/// What is interpolated between the corners of a triangle.
#[derive(Default)]
struct Between {
    /// Unit normal for shading, on any side; where opposite ones cancel there is none.
    normal: Option<Vec3>,
    /// The colour of points.
    tint: Option<Rgb>,
    texture: Option<TextureSample>,
}

impl Between {
    fn corners(
        scene: &PreparedScene,
        shape: &Primitive,
        info: &PrimitiveInfo,
        material: &PreparedMaterial,
        ray: &Ray,
    ) -> Self {
        let (Primitive::Triangle(triangle), false) = (shape, info.is_plain()) else {
            return Self::default();
        };
        let weights @ [wa, wb, wc] = triangle.weights(ray);
        let normal = (info.normals != NO_NORMALS).then(|| {
            let [a, b, c] = scene.normals[info.normals as usize];
            a * wa + b * wb + c * wc
        });
        let tint = (info.colors != NO_COLORS).then(|| {
            let [a, b, c] = scene.colors[info.colors as usize];
            a * wa + b * wb + c * wc
        });
        Self {
            normal: normal.filter(|n| n.length_squared() > 0.0).map(Vec3::normalize),
            tint,
            texture: texture_at(scene, info, material, weights),
        }
    }
}

fn texture_at(
    scene: &PreparedScene,
    info: &PrimitiveInfo,
    material: &PreparedMaterial,
    [wa, wb, wc]: [f64; 3],
) -> Option<TextureSample> {
    let texture = material.texture.as_ref().filter(|_| info.texcoords != NO_TEXCOORDS)?;
    let [a, b, c] = scene.texcoords[info.texcoords as usize];
    Some(texture.sample(std::array::from_fn(|i| a[i] * wa + b[i] * wb + c[i] * wc)))
}

/// The share of a primitive that is there where a ray meets it.
pub(super) fn opacity_at(scene: &PreparedScene, ray: &Ray, primitive: u32) -> f64 {
    let info = &scene.infos[primitive as usize];
    let material = &scene.materials[info.material as usize];
    let texture = match &scene.primitives[primitive as usize] {
        Primitive::Triangle(triangle) if info.texcoords != NO_TEXCOORDS => {
            texture_at(scene, info, material, triangle.weights(ray))
        }
        _ => None,
    };
    material.opacity * texture.map_or(1.0, |texture| texture.opacity)
}

/// Colour of the body at a point, and the square of the pattern that it lies in.
fn body_at(material: &PreparedMaterial, point: Vec3) -> (Rgb, Option<u64>) {
    let Some(checker) = &material.checker else { return (material.color, None) };
    let (a, b) = checker.place(&point);
    // Casts of floats saturate, so points far away lie in the last square.
    let column = (a / checker.size).floor() as i64;
    let row = (b / checker.size).floor() as i64;
    let color = if (column ^ row) & 1 == 0 { material.color } else { checker.color };
    (color, Some((column as u64).rotate_left(32) ^ row as u64))
}
