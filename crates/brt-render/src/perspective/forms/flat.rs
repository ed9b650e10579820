//! Flat primitives: inverse depth and edge functions are linear (Pineda 1988).

use brt_geometry::{Plane, RayBlock, Real, Taylor, Vec3};

use super::LinearForm;
use crate::margins::{EDGE_CLEARANCE, FARTHEST_FORM};
use crate::products::{SamplePattern, Tile, slack};

/// The forms of a flat primitive.
#[derive(Clone, Debug)]
pub(crate) struct FlatForms {
    /// Of the depth in units of the ray's direction.
    pub(in crate::perspective) inverse_depth: LinearForm,
    /// The primitive's plane is certainly met ahead where the inverse depth is greater.
    pub(in crate::perspective) least: f64,
    /// Positive on the primitive's side; their margins hold what is too near to the edge to be clear of it.
    pub(in crate::perspective) edges: Vec<LinearForm>,
}

impl FlatForms {
    /// The forms over a tile whose rays leave one eye; `None` for what is seen from its own plane.
    pub(super) fn new(
        plane: &Plane,
        corners: &[Vec3],
        rays: &RayBlock,
        tile: &Tile,
        pattern: &SamplePattern,
    ) -> Option<Self> {
        let ray = &rays.ray;
        let ahead = plane.ahead(ray);
        let inverse_depth = LinearForm::of(plane.facing(ray) / ahead, tile, pattern);
        let longest = ray.dd.range()[1].sqrt();
        let least =
            2.0 * plane.least_sine_squared.sqrt() * longest / ahead.c.abs() + 2.0 * inverse_depth.margin;
        // Written so that NaN is refused.
        if !(least < f64::INFINITY && least > 1.0 / FARTHEST_FORM) {
            return None;
        }
        // Ahead of the eye the plane's normal has one direction along all rays: seen from the front, edges run the
        // one way round, else the other.
        let towards = if ahead.c < 0.0 { Taylor::constant(-1.0) } else { Taylor::constant(1.0) };
        let side = |edge: Taylor| LinearForm::of(edge * towards, tile, pattern);
        let mut edges: Vec<LinearForm> = match corners {
            [] => Vec::new(),
            corners => rays.sides(corners).map(side).collect(),
        };
        // The side of an edge is six times the volume of eye, corners and hit, over the depth.
        let eye = Vec3 { x: ray.origin.x.c, y: ray.origin.y.c, z: ray.origin.z.c };
        let [farthest, nearest] = inverse_depth.over_tile(tile).range();
        let clear = EDGE_CLEARANCE * slack(eye, corners) * ahead.c.abs() * nearest.max(-farthest);
        for (i, edge) in edges.iter_mut().enumerate() {
            let before = corners[(i + corners.len() - 1) % corners.len()];
            edge.margin += clear * (corners[i] - before).length();
        }
        edges.iter().all(|edge| edge.margin.is_finite()).then_some(Self { inverse_depth, least, edges })
    }
}
