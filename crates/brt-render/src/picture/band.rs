//! Joins tiles to rows. Where filters reach beyond a band, its last row waits for the next band.

use super::filter::TileColors;
use super::layers::{Layer, LayerRows};
use super::sink::Rows;
use crate::products::{SampleGrid, Tile};
use crate::settings::{CheckedPixels, Settings};

/// A finished tile: shares of pixels, and its layers.
pub(crate) struct TilePicture {
    pub(crate) tile: Tile,
    /// `None` where pixels take no shares from other tiles: they are in the band's rows then.
    pub(crate) colors: Option<TileColors>,
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

    /// Joins the tiles of a band, left to right, and returns the rows that are finished with it. `colors` are the band's
    /// rows, if tiles have none.
    pub(crate) fn add_band(&mut self, tiles: &[TilePicture], colors: Vec<[f32; 3]>) -> Rows {
        let band_end = tiles.first().map_or(0, |t| (t.tile.y + t.tile.height) / self.grid.per_side);
        let last_row = |t: &TileColors| t.y + i64::from(t.colors.len() as u32 / t.width);
        let last_rows = tiles.iter().filter_map(|t| t.colors.as_ref()).map(last_row);
        let height = i64::from(self.grid.height);
        let end = last_rows.max().map_or(band_end, |end| end.clamp(0, height) as u32);
        let rows = end - self.open.first;
        if colors.is_empty() {
            let colors = tiles.iter().filter_map(|tile| tile.colors.as_ref());
            add_tiles(self.grid, self.open.first, rows, &mut self.open.colors, colors);
        } else {
            self.open.colors = colors;
        }
        if let Some(open) = &mut self.open.full {
            let full = tiles.iter().filter_map(|tile| tile.full.as_ref());
            add_tiles(self.grid, self.open.first, rows, open, full);
        }
        self.make_room_for_layers(rows);
        tiles.iter().for_each(|tile| self.copy_layers(tile));
        // With a wide filter the next band still adds to this band's last row.
        let is_last = band_end == self.grid.height;
        let waiting = if is_last || end == band_end { 0 } else { end - band_end + 1 };
        self.hand_out(end - waiting - self.open.first)
    }

    fn make_room_for_layers(&mut self, rows: u32) {
        let count = (rows * self.grid.width) as usize;
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

/// Adds the shares of a band's tiles to the rows of the picture from `first` on that are open.
fn add_tiles<'t>(
    grid: &SampleGrid,
    first: u32,
    rows: u32,
    open: &mut Vec<[f32; 3]>,
    tiles: impl Iterator<Item = &'t TileColors> + Clone,
) {
    let width: usize = tiles.clone().map(|tile| tile.width as usize).sum();
    if open.is_empty() && width == grid.width as usize {
        // No tile reaches into another: rows are joined as they are.
        open.reserve_exact(rows as usize * width);
        let mut lines: Vec<_> = tiles.map(|tile| tile.colors.chunks_exact(tile.width as usize)).collect();
        for _ in 0..rows {
            lines.iter_mut().filter_map(Iterator::next).for_each(|line| open.extend_from_slice(line));
        }
        return;
    }
    open.resize((rows * grid.width) as usize, [0.0; 3]);
    tiles.for_each(|tile| add_colors(grid, first, open, tile));
}

/// Adds a tile's shares to rows of the picture that begin at row `first`.
fn add_colors(grid: &SampleGrid, first: u32, rows: &mut [[f32; 3]], part: &TileColors) {
    let (width, height) = (i64::from(grid.width), i64::from(grid.height));
    // Filters reach beyond the picture's edge.
    let begin = part.x.max(0);
    let end = (part.x + i64::from(part.width)).min(width);
    for (row, colors) in (part.y..).zip(part.colors.chunks_exact(part.width as usize)) {
        if !(0..height).contains(&row) {
            continue;
        }
        let place = (row - i64::from(first)) * width;
        let sums = &mut rows[(place + begin) as usize..(place + end) as usize];
        let colors = &colors[(begin - part.x) as usize..(end - part.x) as usize];
        for (sum, color) in sums.iter_mut().zip(colors) {
            *sum = std::array::from_fn(|c| sum[c] + color[c]);
        }
    }
}
