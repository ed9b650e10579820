//! Joins tiles to rows. Where filters reach beyond a band, its last row waits for the next band.

use super::filter::TileColors;
use super::layers::{Layer, LayerRows};
use super::sink::Rows;
use crate::products::{SampleGrid, Tile};
use crate::settings::{CheckedPixels, Settings};

/// A finished tile: shares of pixels, and its layers.
pub(crate) struct TilePicture {
    pub(crate) tile: Tile,
    pub(crate) colors: TileColors,
    /// The same by full ray tracing.
    pub(crate) full: Option<TileColors>,
    pub(crate) layers: Vec<LayerRows>,
}

/// Joins the tiles of bands, which come from the top to the bottom.
pub(crate) struct BandAssembler<'a> {
    grid: &'a SampleGrid,
    layers: &'a [Layer],
    /// Rows from `open.first` on that are not handed out yet.
    open: Rows,
}

impl<'a> BandAssembler<'a> {
    pub(crate) fn new(grid: &'a SampleGrid, settings: &'a Settings) -> Self {
        let full = (settings.checked != CheckedPixels::None).then(Vec::new);
        let layers = settings.layers.iter().map(|&layer| LayerRows::empty(layer, 0)).collect();
        let open = Rows { first: 0, width: grid.width, colors: Vec::new(), full, layers };
        Self { grid, layers: &settings.layers, open }
    }

    /// Joins the tiles of a band, left to right, and returns the rows that are finished with it.
    pub(crate) fn add_band(&mut self, tiles: &[TilePicture]) -> Rows {
        let last_row =
            |t: &TilePicture| t.colors.y + i64::from(t.colors.colors.len() as u32 / t.colors.width);
        let end = tiles.iter().map(last_row).max().unwrap_or(0).clamp(0, i64::from(self.grid.height)) as u32;
        self.make_room(end - self.open.first);
        for tile in tiles {
            add_colors(self.grid, self.open.first, &mut self.open.colors, &tile.colors);
            if let (Some(open), Some(part)) = (&mut self.open.full, &tile.full) {
                add_colors(self.grid, self.open.first, open, part);
            }
            self.copy_layers(tile);
        }
        let band_end = tiles.first().map_or(0, |t| (t.tile.y + t.tile.height) / self.grid.per_side);
        // With a wide filter the next band still adds to this band's last row.
        let is_last = band_end == self.grid.height;
        let waiting = if is_last || end == band_end { 0 } else { end - band_end + 1 };
        self.hand_out(end - waiting - self.open.first)
    }

    fn make_room(&mut self, rows: u32) {
        let count = (rows * self.grid.width) as usize;
        self.open.colors.resize(count, [0.0; 3]);
        if let Some(full) = &mut self.open.full {
            full.resize(count, [0.0; 3]);
        }
        let old = std::mem::take(&mut self.open.layers);
        self.open.layers = self.layers.iter().map(|&layer| LayerRows::empty(layer, count)).collect();
        for (new, old) in self.open.layers.iter_mut().zip(&old) {
            new.copy_run(0, old, 0, old.len());
        }
    }

    fn copy_layers(&mut self, part: &TilePicture) {
        let n = self.grid.per_side;
        let columns = (part.tile.width / n) as usize;
        for (rows, layer) in self.open.layers.iter_mut().zip(&part.layers) {
            for row in 0..part.tile.height / n {
                let place = (part.tile.y / n + row - self.open.first) * self.grid.width + part.tile.x / n;
                rows.copy_run(place as usize, layer, row as usize * columns, columns);
            }
        }
    }

    /// Splits off the first rows.
    fn hand_out(&mut self, rows: u32) -> Rows {
        let count = (rows * self.grid.width) as usize;
        let split_colors = |colors: &mut Vec<[f32; 3]>| {
            let rest = colors.split_off(count);
            std::mem::replace(colors, rest)
        };
        let colors = split_colors(&mut self.open.colors);
        let full = self.open.full.as_mut().map(split_colors);
        let split = |layer: &mut LayerRows| layer.split_front(count);
        let layers = self.open.layers.iter_mut().map(split).collect();
        let first = self.open.first;
        self.open.first += rows;
        Rows { first, width: self.grid.width, colors, full, layers }
    }
}

/// Adds a tile's shares to rows of the picture that begin at row `first`.
fn add_colors(grid: &SampleGrid, first: u32, rows: &mut [[f32; 3]], part: &TileColors) {
    let (width, height) = (i64::from(grid.width), i64::from(grid.height));
    for (row, colors) in (part.y..).zip(part.colors.chunks_exact(part.width as usize)) {
        if !(0..height).contains(&row) {
            continue;
        }
        for (column, color) in (part.x..).zip(colors) {
            if (0..width).contains(&column) {
                let at = &mut rows[((row - i64::from(first)) * width + column) as usize];
                *at = std::array::from_fn(|c| at[c] + color[c]);
            }
        }
    }
}
