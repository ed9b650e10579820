//! Flat primitives seen from one eye: on which side of each edge a sample lies, and the inverse of its depth, are
//! linear in the sample's column and row (Pineda 1988).
//!
//! The forms of a tile are read off the primitives' own predicates, evaluated over the whole tile as Taylor models:
//! the remainder is nothing but rounding then, and bounds how far a form is from what a ray through a sample computes.
//! Where a form is within this margin of a decision, the ray decides.

use brt_geometry::{Primitive, Ray, Real, SMALLEST_ANGLE, Taylor, edge_functions};

use crate::products::{Area, Tile};

/// A number linear in column and row, counted from the first sample of a tile.
#[derive(Clone, Copy, Debug)]
pub(super) struct LinearForm {
    base: f64,
    column: f64,
    row: f64,
    /// A ray through the sample computes a number that differs from this one by less.
    pub(super) margin: f64,
}

impl LinearForm {
    fn of(model: Taylor, tile: &Tile) -> Self {
        let slope = |change: f64, count: u32| if count > 1 { 2.0 * change / f64::from(count - 1) } else { 0.0 };
        let rounding = 16.0 * f64::EPSILON * (model.c.abs() + model.u.abs() + model.v.abs());
        Self {
            base: model.c - model.u - model.v,
            column: slope(model.u, tile.width),
            row: slope(model.v, tile.height),
            margin: model.e + rounding,
        }
    }

    #[inline(always)]
    pub(super) fn at(&self, column: f64, row: f64) -> f64 {
        self.base + self.column * column + self.row * row
    }

    /// Over an area of the tile.
    pub(super) fn over(&self, area: &Area, tile: &Tile) -> Taylor {
        let middle = |a: u32, b: u32, first: u32| 0.5 * (f64::from(a - first) + f64::from(b - 1 - first));
        let half = |a: u32, b: u32| 0.5 * f64::from(b - 1 - a);
        Taylor {
            c: self.at(middle(area.x0, area.x1, tile.x), middle(area.y0, area.y1, tile.y)),
            u: self.column * half(area.x0, area.x1),
            v: self.row * half(area.y0, area.y1),
            e: self.margin,
        }
    }
}

/// The forms of a flat primitive.
#[derive(Clone, Debug)]
pub(super) struct FlatForms {
    /// Of the depth in units of the ray's direction.
    pub(super) inverse_depth: LinearForm,
    /// The primitive's plane is certainly met ahead where the inverse depth is greater.
    pub(super) least: f64,
    /// Positive on the primitive's side.
    pub(super) edges: Vec<LinearForm>,
}

impl FlatForms {
    /// The forms over a tile whose rays leave one eye; `None` for what is not flat or seen from its own plane.
    pub(super) fn new(primitive: &Primitive, ray: &Ray<Taylor>, tile: &Tile) -> Option<Self> {
        // Farther away a hit might not count any more (`FARTHEST`).
        const FAR: f64 = 1e200;
        let (plane, corners) = primitive.flat()?;
        let ahead = plane.ahead(ray);
        let inverse_depth = LinearForm::of(plane.facing(ray) / ahead, tile);
        let longest = ray.dd.range()[1].sqrt();
        let least = 2.0 * SMALLEST_ANGLE * longest / ahead.c.abs() + 2.0 * inverse_depth.margin;
        // Written so that NaN is refused.
        if !(least < f64::INFINITY && least > 1.0 / FAR) {
            return None;
        }
        // Ahead of the eye the plane's normal has one direction along all rays: seen from the front, edges run the
        // one way round, else the other.
        let towards = if ahead.c < 0.0 { Taylor::constant(-1.0) } else { Taylor::constant(1.0) };
        let side = |edge: Taylor| LinearForm::of(edge * towards, tile);
        let edges = match corners {
            [] => Vec::new(),
            corners => edge_functions(corners, ray).map(side).collect(),
        };
        Some(Self { inverse_depth, least, edges })
    }
}
