//! Proves that a patch lies in one square of a chequered pattern, and so has one body colour.
//!
//! From: the range of its points. Division and rounding down are monotone, so the ends of the range decide.

use brt_geometry::{Taylor, Vec3};
use brt_image::Rgb;

use crate::products::PreparedMaterial;

/// The one body colour of a patch, if it certainly has one.
pub(in crate::methods::certified) fn cell_color(
    material: &PreparedMaterial,
    points: &Vec3<Taylor>,
) -> Option<Rgb> {
    let Some(checker) = &material.checker else { return Some(material.color) };
    let (a, b) = checker.place(points);
    let cell = |x: Taylor| {
        let [lo, hi] = x.range().map(|x| (x / checker.size).floor() as i64);
        (lo == hi).then_some(lo)
    };
    let is_even = (cell(a)? ^ cell(b)?) & 1 == 0;
    Some(if is_even { material.color } else { checker.color })
}
