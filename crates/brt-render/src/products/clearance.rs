//! How well places on flat primitives are known.

use brt_geometry::{COORDINATE_ROUNDING, Vec3};

/// How far a point where a ray from the eye meets something flat may be off by rounding: much more than it ever is.
pub(crate) fn slack(eye: Vec3, corners: &[Vec3]) -> f64 {
    let size = |p: &Vec3| p.x.abs() + p.y.abs() + p.z.abs();
    COORDINATE_ROUNDING * (size(&eye) + corners.iter().map(size).sum::<f64>())
}
