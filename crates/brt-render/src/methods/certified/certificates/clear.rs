//! Proves that rays which leave a flat primitive never meet what lies beside it, though bounds on a whole block, which
//! reach beyond the primitive's edges, could not tell.
//!
//! From: all samples of the block are clear of the primitive's edges (but for doubtful ones, which are traced anyway). A ray
//! that leaves it upwards is below any height only near its start. So it misses what lies below the primitive's plane and
//! comes near it only beyond an edge; and a plane that the whole primitive lies above, touching it with an edge at most,
//! if the ray moves away from it. How near is near is decided with room for rounding: where a ray starts is known to
//! within a slack, and what it meets to within some hundreds of them.

use brt_geometry::{COORDINATE_ROUNDING, Plane, Primitive, Ray, Taylor, Vec3};

use crate::margins::{EDGE_CLEARANCE, LEAST_RISE, LEAST_VIEW_SINE, OFF_PLANE, STEEPEST};
use crate::products::{PreparedScene, slack};
use crate::tracing::Patch;

/// A flat primitive that all samples of a block show, clear of its edges.
pub(in crate::methods::certified) struct Clear<'a> {
    plane: &'a Plane,
    corners: &'a [Vec3],
    /// 1 if the block sees it from the front, else −1.
    side: f64,
    slack: f64,
}

impl<'a> Clear<'a> {
    /// What a block shows; `None` if corners are off the plane, or it is seen along the plane.
    pub(in crate::methods::certified) fn of(
        scene: &'a PreparedScene,
        patch: &Patch,
        view: &Ray<Taylor>,
        eye: Vec3,
    ) -> Option<Self> {
        let (plane, corners) = scene.primitives[patch.primitive as usize].flat()?;
        let side = patch.normal.along(plane.normal).c.signum();
        let slack = slack(eye, corners);
        let longest = view.dd.range()[1].max(0.0).sqrt();
        let [fall, _] = view.direction.along(plane.normal * -side).range();
        if fall.is_nan() || fall <= LEAST_VIEW_SINE * longest {
            return None;
        }
        (!corners.is_empty() && is_flat(plane, corners, slack)).then_some(Self {
            plane,
            corners,
            side,
            slack,
        })
    }

    /// Rays that leave it; `None` where they may run along it or to its other side.
    pub(in crate::methods::certified) fn leaving(&self, towards: &'a Vec3<Taylor>) -> Option<Leaving<'_>> {
        let least = LEAST_RISE * towards.length_squared().range()[1].max(0.0).sqrt();
        let [rise, _] = towards.along(self.plane.normal * self.side).range();
        (rise > least).then_some(Leaving { from: self, towards, least })
    }
}

/// Rays that leave a flat primitive on the side that it is seen from.
pub(in crate::methods::certified) struct Leaving<'a> {
    from: &'a Clear<'a>,
    towards: &'a Vec3<Taylor>,
    /// How fast they must rise not to count as along a surface.
    least: f64,
}

impl Leaving<'_> {
    /// Is it certain that none of them meets this?
    pub(in crate::methods::certified) fn never_meets(&self, other: &Primitive) -> bool {
        other.plane().is_some_and(|plane| self.leaves_above(plane))
            || other.flat().is_some_and(|(plane, corners)| self.passes_by(plane, corners))
    }

    /// Do they start above a plane and move away from it?
    fn leaves_above(&self, plane: &Plane) -> bool {
        let Clear { plane: own, corners, slack, .. } = *self.from;
        let [lo, hi] = self.towards.along(plane.normal).range();
        let turn = if lo > 0.0 { 1.0 } else { -1.0 };
        let off = slack + COORDINATE_ROUNDING * plane.distance.abs();
        let is_above = |corner: &Vec3| turn * (plane.normal.dot(*corner) - plane.distance) >= -off;
        // Off an edge by its clearance the primitive has gained height over the plane.
        let gained = EDGE_CLEARANCE * slack * own.normal.cross(plane.normal).length();
        (lo > 0.0 || hi < 0.0) && gained > 10.0 * off && corners.iter().all(is_above)
    }

    /// Does a face lie below the primitive's plane, near it only beyond an edge?
    fn passes_by(&self, plane: &Plane, corners: &[Vec3]) -> bool {
        let Clear { plane: own, corners: own_corners, side, slack: own_slack } = *self.from;
        let slack = slack(Vec3::ZERO, corners) + own_slack;
        let [lo, hi] = self.towards.along(plane.normal).range();
        let is_known = OFF_PLANE * slack < EDGE_CLEARANCE * own_slack && is_flat(plane, corners, slack);
        if corners.is_empty() || lo.max(-hi) <= self.least || !is_known {
            return false;
        }
        let height = |corner: &Vec3| side * (own.normal.dot(*corner) - own.distance);
        let highest = corners.iter().map(height).fold(f64::NEG_INFINITY, f64::max);
        if highest < -OFF_PLANE * slack {
            return true;
        }
        let is_beyond = |i: usize| {
            let (from, to) = (own_corners[(i + own_corners.len() - 1) % own_corners.len()], own_corners[i]);
            let Some(across) = (to - from).cross(own.normal).try_normalize() else { return false };
            let is_beside =
                |corner: &Vec3| across.dot(*corner - from) >= -slack - STEEPEST * (-height(corner)).max(0.0);
            corners.iter().all(is_beside)
        };
        highest <= slack && (0..own_corners.len()).any(is_beyond)
    }
}

/// Do all corners lie in the plane, as nearly as it is known?
fn is_flat(plane: &Plane, corners: &[Vec3], slack: f64) -> bool {
    corners.iter().all(|corner| (plane.normal.dot(*corner) - plane.distance).abs() <= slack)
}
