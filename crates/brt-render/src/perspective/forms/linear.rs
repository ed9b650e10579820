//! Numbers linear in a sample's position.

use brt_geometry::Taylor;

use crate::margins::FORM_ROUNDINGS;
use crate::products::{Area, SamplePattern, Tile};

/// A number linear in the position, counted from where the first sample of a tile has its place.
#[derive(Clone, Copy, Debug)]
pub(in crate::perspective) struct LinearForm {
    base: f64,
    column: f64,
    row: f64,
    /// A ray through the sample computes a number that differs from this one by less.
    pub(in crate::perspective) margin: f64,
    pattern: SamplePattern,
}

impl LinearForm {
    /// A model over all samples of a tile.
    pub(super) fn of(model: Taylor, tile: &Tile, pattern: &SamplePattern) -> Self {
        let area = Area { x0: 0, y0: 0, x1: tile.width, y1: tile.height };
        let ([middle_x, middle_y], [half_x, half_y]) = (area.middle(), area.half_sides(pattern));
        let slope = |change: f64, half: f64| if half > 0.0 { change / half } else { 0.0 };
        let (column, row) = (slope(model.u, half_x), slope(model.v, half_y));
        let rounding = FORM_ROUNDINGS * (model.c.abs() + model.u.abs() + model.v.abs());
        Self {
            base: model.c - column * middle_x - row * middle_y,
            column,
            row,
            margin: model.e + rounding,
            pattern: *pattern,
        }
    }

    #[inline(always)]
    pub(in crate::perspective) fn at(&self, column: f64, row: f64) -> f64 {
        self.base + self.column * column + self.row * row
    }

    /// Over the whole tile.
    pub(super) fn over_tile(&self, tile: &Tile) -> Taylor {
        self.over(&tile.area(), tile)
    }

    /// Over an area of the tile.
    pub(in crate::perspective) fn over(&self, area: &Area, tile: &Tile) -> Taylor {
        let ([x, y], [half_x, half_y]) = (area.middle(), area.half_sides(&self.pattern));
        Taylor {
            c: self.at(x - f64::from(tile.x), y - f64::from(tile.y)),
            u: self.column * half_x,
            v: self.row * half_y,
            e: self.margin,
        }
    }
}
