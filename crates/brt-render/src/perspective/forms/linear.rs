//! Numbers linear in the sample's column and row.

use brt_geometry::Taylor;

use crate::products::{Area, Tile};

/// A number linear in column and row, counted from the first sample of a tile.
#[derive(Clone, Copy, Debug)]
pub(in crate::perspective) struct LinearForm {
    base: f64,
    column: f64,
    row: f64,
    /// A ray through the sample computes a number that differs from this one by less.
    pub(in crate::perspective) margin: f64,
}

impl LinearForm {
    pub(super) fn of(model: Taylor, tile: &Tile) -> Self {
        let slope =
            |change: f64, count: u32| if count > 1 { 2.0 * change / f64::from(count - 1) } else { 0.0 };
        let rounding = 16.0 * f64::EPSILON * (model.c.abs() + model.u.abs() + model.v.abs());
        Self {
            base: model.c - model.u - model.v,
            column: slope(model.u, tile.width),
            row: slope(model.v, tile.height),
            margin: model.e + rounding,
        }
    }

    #[inline(always)]
    pub(in crate::perspective) fn at(&self, column: f64, row: f64) -> f64 {
        self.base + self.column * column + self.row * row
    }

    /// Over an area of the tile.
    pub(in crate::perspective) fn over(&self, area: &Area, tile: &Tile) -> Taylor {
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
