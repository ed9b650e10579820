//! The constants that certificates and the perspective image rest on, each with its inequality. What rays and primitives need is on
//! the page of `brt-geometry` (`margins.rs` there), which also says what a safety is. A *slack* is how far a point where a ray
//! meets something flat may be off by rounding ([`slack`](crate::products::slack)).

#[cfg(test)]
mod used;

use brt_geometry::{BOX_MARGIN, margins};

/// Depths and projected outlines are widened by this share (of the distance, and of a sample) where they only serve to leave
/// out what cannot be seen: hits may lie that far beside what is met.
pub(crate) const PROJECTION_MARGIN: f64 = BOX_MARGIN;

/// Forms are not made of primitives that may be met farther away: there a hit might not count any more
/// ([`FARTHEST`](brt_geometry::FARTHEST)).
pub(crate) const FARTHEST_FORM: f64 = 1e200;

/// Next to a ball's surface, where the eye's power is this share of the square of its distance from the centre, the two terms of
/// the nearer root cancel, and depths are nothing but rounding: no forms are made there. Nothing else rests on it.
pub(crate) const LEAST_POWER: f64 = 1e-6;

/// Primitives whose carriers are known less well than this, as a share of the scene's size, are not compared with what lies farther
/// away: slivers would be compared with everything. Nothing else rests on it.
pub(crate) const WORST_KEY: f64 = 1e-8;

/// Cosine of the angle between faces that may share a plane: corners alone say nothing of faces that are as small as rounding.
pub(crate) const LEAST_COSINE: f64 = 1.0 - 1e-6;

/// Weights of corners that may be off by more mean nothing.
pub(crate) const MOST_WEIGHT_ERROR: f64 = 1e-6;

margins! {
    /// The discriminant of a ball that a sample's ray computes, and what its form gives, round by less than this share of
    /// b² + c·dd together: each has fewer than 48 products and sums of these terms.
    pub(crate) DISCRIMINANT_ROUNDINGS = 96.0 * f64::EPSILON, safety 40.0;

    /// Inverse depths next to a ball's outline may be off by this share: where the discriminant vanishes, its rounding becomes a
    /// root, √(96 ε) = 1.5·10⁻⁷ of b.
    pub(crate) DEPTH_ROUNDING = 1e-6, safety 10.0;

    /// A form's base and slopes are found by five sums, products and quotients, and a value of it by four more.
    pub(crate) FORM_ROUNDINGS = 16.0 * f64::EPSILON, safety 12.0;

    /// Inverse depths are found by a quotient, and the depths that they are compared with by another.
    pub(crate) QUOTIENT_ROUNDINGS = 8.0 * f64::EPSILON, safety 12.0;

    /// Samples of the perspective image that lie nearer to an edge than this, in slacks, are doubtful and traced.
    ///
    /// A ray that leaves a face starts within a slack of its plane. Rising at a sine of [`LEAST_RISE`] or more it is a slack above
    /// the plane after 2 / `LEAST_RISE` = 100 slacks, long before it gets across an edge.
    pub(crate) EDGE_CLEARANCE = 1e5, safety 2000.0;

    /// The sine of the angle to a face from which rays count as leaving it, or as crossing it: what they meet is then known to
    /// 1 / 0.02 = 50 slacks along them, an eightieth of [`OFF_PLANE`].
    pub(crate) LEAST_RISE = 0.02, safety 100.0;

    /// The same for how a face is seen: where its samples are is known to a slack over this, a hundredth of
    /// [`EDGE_CLEARANCE`].
    pub(crate) LEAST_VIEW_SINE = 1e-3, safety 200.0;

    /// A face that comes nearer to the plane than it is beyond the edge over this lies beside it. Where it reaches under the
    /// primitive it is so at least `EDGE_CLEARANCE` / 30 = 3333 slacks deep below all points that are clear of the edge, and is
    /// known to 50 slacks along rays.
    pub(crate) STEEPEST = 30.0, safety 100.0;

    /// So many slacks from an edge, or off a plane, nothing is met by rounding: hits are known to 50 slacks, their ends as well.
    pub(crate) OFF_PLANE = 4000.0, safety 100.0;

    /// How much clearer of edges points of sheets must be than they are known, in slacks. Four slacks of height are compared, so a
    /// ray has left them after 2 · 4 / [`LEAST_RISE`] = 400.
    pub(crate) SHEET_CLEARANCE = 1e4, safety 50.0;

    /// By how much weights of corners are off: this times the square of all coordinates over the area as seen. They are
    /// quotients of determinants whose terms are products of three coordinates.
    pub(crate) WEIGHT_ROUNDINGS = 64.0 * f64::EPSILON, safety 2000.0;

    /// One over the slope of sRGB's curve at black, 1 / 12.92 = 0.0774, would do for a sample alone. A pixel is a mean of samples:
    /// what is allowed must be a concave function of the value, and from the corner at [`SRGB_CUT`](crate::methods) on the inverse
    /// of the slope falls before it rises. A chord from here to [`ALLOWED_AT_CUT`] runs below, as far as it must.
    pub(crate) ALLOWED_AT_BLACK = 0.031, safety 1.1;

    /// The inverse of the slope next to the corner is 0.0774 below it and 2.4 / 1.055 · 0.0031308^(1.4/2.4) = 0.0789 above.
    pub(crate) ALLOWED_AT_CUT = 0.077, safety 1.1;

    /// Of the inverse of the slope above the corner: the curve is steeper below, where the value may be by the error itself.
    pub(crate) ALLOWED_ABOVE = 0.97, safety 1.1;

    /// Linear values that are filled and traced are rounded to single precision, by 2⁻²⁴ of the greatest; the filled one is a sum of
    /// three terms there.
    pub(crate) STORED_ROUNDINGS = 8.0 * f32::EPSILON as f64, safety 10.0;

    /// The share of a tolerance that is left for weights and sums that make a pixel of its samples: they round to 2⁻²⁴, which is
    /// 255 · 2⁻²⁴ = 1.5·10⁻⁵ of a level at white, a few times.
    pub(crate) RESERVE = 1e-3, safety 4.0;

    /// What is met on the way to a light from this share before its end on does not hide the light. A lamp may lie exactly in a
    /// ceiling, and whether the ceiling is met just before it or just behind only rounding would tell, point by point: hits of
    /// planes at ordinary angles are off by some 8 ε of coordinates.
    pub(crate) LIGHT_MARGIN = 1e-9, safety 1e6;

    /// Roundings by which a primitive may lie off a carrier that it is given, as a share of the greatest of its coordinates and
    /// the carrier's distance: a corner that was turned and moved, and a plane through three such corners, round by fewer than
    /// 16 ε each. Rays then meet it by up to that over [`LEAST_SINE`](brt_geometry::LEAST_SINE) beside where it is: 1.8·10⁻⁸ of
    /// both. Each is at most 4.5 sizes of the scene, so this is 1.6·10⁻⁷ of it, a sixth of [`BOX_MARGIN`].
    pub(crate) CARRIER_ROUNDINGS = 32.0 * f64::EPSILON, safety 30.0;

    /// Roundings of coordinates that two descriptions of one carrier may differ by where their keys are compared. Nothing rests on
    /// it: a pair that is missed stays two surfaces.
    pub(crate) KEY_ROUNDINGS = 64.0 * f64::EPSILON, safety 200.0;

    /// A scene whose middle is farther away than this many of its sizes is moved to the origin. Coordinates are then within half
    /// a size of the middle, so between half and twice of it, and their difference is exact (Sterbenz 1974): from one size on.
    pub(crate) FAR_FROM_ORIGIN = 4.0, safety 4.1;
}
