//! What there is at the point where a ray meets a primitive.

use brt_geometry::{Primitive, Ray, Real, Vec3};
use brt_image::Rgb;
use brt_scene::Axis;

use crate::products::{NO_COLORS, NO_NORMALS, PreparedMaterial, PreparedScene, PrimitiveInfo};

/// A point on a surface, seen along a ray.
pub(crate) struct Interaction<'a> {
    pub(crate) primitive: u32,
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
    /// The square of a chequered pattern, where there is one.
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
        let (mut smooth, mut tint) = (outward, None);
        if let (Primitive::Triangle(triangle), false) = (shape, info.is_plain()) {
            let [wa, wb, wc] = triangle.weights(ray);
            if info.normals != NO_NORMALS {
                let [a, b, c] = scene.normals[info.normals as usize];
                // Opposite normals cancel: where nothing is left the face's own is taken.
                let mean = a * wa + b * wb + c * wc;
                smooth = if mean.length_squared() > 0.0 { mean.normalize() } else { outward };
            }
            if info.colors != NO_COLORS {
                let [a, b, c] = scene.colors[info.colors as usize];
                tint = Some(a * wa + b * wb + c * wc);
            }
        }
        // Normals of files may point to the other side than the order of the corners says.
        let agrees = smooth.dot(outward) >= 0.0;
        let (body, cell) = body_at(material, point);
        let body = tint.map_or(body, |tint| body * tint);
        Self {
            primitive,
            point,
            geometric_normal: turn(outward),
            normal: turn(if agrees { smooth } else { -smooth }),
            viewer: -(ray.direction * ray.dd.inverse_sqrt()),
            from_behind,
            info,
            material,
            body,
            cell,
        }
    }
}

/// Colour of the body at a point, and the square of the pattern that it lies in.
fn body_at(material: &PreparedMaterial, point: Vec3) -> (Rgb, Option<u64>) {
    let Some(checker) = &material.checker else { return (material.color, None) };
    let (a, b) = match checker.axis {
        Axis::X => (point.y, point.z),
        Axis::Y => (point.x, point.z),
        Axis::Z => (point.x, point.y),
    };
    // Casts of floats saturate, so points far away lie in the last square.
    let column = (a / checker.size).floor() as i64;
    let row = (b / checker.size).floor() as i64;
    let color = if (column ^ row) & 1 == 0 { material.color } else { checker.color };
    (color, Some((column as u64).rotate_left(32) ^ row as u64))
}
