//! How clear of the edges of what it shows a sample is known to be.

use brt_geometry::{COORDINATE_ROUNDING, Vec3};

/// Samples of the perspective image that lie nearer to an edge than this, in slacks, are [doubtful](super::PerspectiveImage).
pub(crate) const CLEARANCE: f64 = 1e5;

/// How far a point where a ray from the eye meets something flat may be off by rounding: much more than it ever is.
pub(crate) fn slack(eye: Vec3, corners: &[Vec3]) -> f64 {
    let size = |p: &Vec3| p.x.abs() + p.y.abs() + p.z.abs();
    COORDINATE_ROUNDING * (size(&eye) + corners.iter().map(size).sum::<f64>())
}
