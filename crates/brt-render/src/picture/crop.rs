//! From the rows of whole tiles to those of the window that was asked for.

use std::borrow::Cow;

use super::layers::LayerRows;
use super::sink::Rows;
use crate::products::SampleGrid;
use crate::settings::Window;

/// Where a window lies in the tiles that are rendered for it, in pixels.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Crop {
    x: u32,
    y: u32,
    width: u32,
    height: u32,
}

impl Crop {
    pub(crate) fn new(window: &Window, grid: &SampleGrid) -> Self {
        let [x, y] = [window.x - grid.first[0], window.y - grid.first[1]].map(|offset| offset as u32);
        Self { x, y, width: window.width, height: window.height }
    }

    /// The window's row that this row of the grid is; `None` above it and below.
    pub(crate) fn row(&self, row: u32) -> Option<u32> {
        row.checked_sub(self.y).filter(|row| *row < self.height)
    }

    /// The window's part of rows; `None` if it has none of them.
    pub(crate) fn of<'r>(&self, rows: &'r Rows) -> Option<Cow<'r, Rows>> {
        let first = rows.first.max(self.y);
        let end = (rows.first + rows.count()).min(self.y + self.height);
        if first >= end {
            return None;
        }
        if self.x == 0 && self.width == rows.width && end - first == rows.count() && self.y == 0 {
            return Some(Cow::Borrowed(rows));
        }
        let runs = Runs {
            first: ((first - rows.first) * rows.width + self.x) as usize,
            stride: rows.width as usize,
            length: self.width as usize,
            count: (end - first) as usize,
        };
        Some(Cow::Owned(Rows {
            first: first - self.y,
            width: self.width,
            colors: runs.of(&rows.colors),
            alpha: rows.alpha.as_deref().map(|alpha| runs.of(alpha)),
            full: rows.full.as_deref().map(|full| runs.of(full)),
            full_alpha: rows.full_alpha.as_deref().map(|alpha| runs.of(alpha)),
            layers: rows.layers.iter().map(|layer| runs.of_layer(layer)).collect(),
        }))
    }
}

/// Runs of pixels, one in each row.
struct Runs {
    first: usize,
    stride: usize,
    length: usize,
    count: usize,
}

impl Runs {
    fn starts(&self) -> impl Iterator<Item = usize> {
        (0..self.count).map(|row| self.first + row * self.stride)
    }

    fn of<T: Copy>(&self, values: &[T]) -> Vec<T> {
        let mut kept = Vec::with_capacity(self.count * self.length);
        self.starts().for_each(|start| kept.extend_from_slice(&values[start..start + self.length]));
        kept
    }

    fn of_layer(&self, layer: &LayerRows) -> LayerRows {
        let mut kept = LayerRows::empty(layer.layer(), self.count * self.length);
        for (row, start) in self.starts().enumerate() {
            kept.copy_run(row * self.length, layer, start, self.length);
        }
        kept
    }
}
