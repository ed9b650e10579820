//! Joins tiles to rows. Where filters reach beyond a band, its last row waits for the next band.

use super::filter::TileShares;
use super::layers::LayerRows;
use super::sink::Rows;
use crate::products::{SampleGrid, Tile};
use crate::settings::{CheckedPixels, Layer, Settings};

/// A finished tile: shares of pixels, and its layers.
pub(crate) struct TilePicture {
    pub(crate) tile: Tile,
    /// `None` where pixels take no shares from other tiles: they are in the band's rows then.
    pub(crate) colors: Option<TileShares<3>>,
    /// If the backdrop is transparent.
    pub(crate) alpha: Option<TileShares<1>>,
    /// The same by full ray tracing.
    pub(crate) full: Option<FullTile>,
    pub(crate) layers: Vec<LayerRows>,
}

/// A tile by full ray tracing.
pub(crate) struct FullTile {
    pub(crate) colors: TileShares<3>,
    pub(crate) alpha: Option<TileShares<1>>,
}

/// Joins the tiles of bands, which come from the top to the bottom.
pub(crate) struct BandAssembler<'a> {
    grid: &'a SampleGrid,
    layers: &'a [Layer],
    /// The first row that is not handed out yet.
    first: u32,
    /// Rows from there on.
    open: OpenRows,
}

/// Rows that are not handed out yet.
struct OpenRows {
    colors: Vec<[f32; 3]>,
    alpha: Option<Vec<[f32; 1]>>,
    full: Option<Vec<[f32; 3]>>,
    full_alpha: Option<Vec<[f32; 1]>>,
    layers: Vec<LayerRows>,
}

impl<'a> BandAssembler<'a> {
    pub(crate) fn new(grid: &'a SampleGrid, settings: &'a Settings) -> Self {
        let (is_checked, has_alpha) =
            (settings.checked != CheckedPixels::None, settings.backdrop.has_alpha());
        let open = OpenRows {
            colors: Vec::new(),
            alpha: has_alpha.then(Vec::new),
            full: is_checked.then(Vec::new),
            full_alpha: (is_checked && has_alpha).then(Vec::new),
            layers: settings.layers.iter().map(|&layer| LayerRows::empty(layer, 0)).collect(),
        };
        Self { grid, layers: &settings.layers, first: 0, open }
    }

    /// Joins the tiles of a band, left to right, and returns the rows that are finished with it. `colors` are the band's
    /// rows, if tiles have none.
    pub(crate) fn add_band(&mut self, tiles: &[TilePicture], colors: Vec<[f32; 3]>) -> Rows {
        let band_end = tiles.first().map_or(0, |t| (t.tile.y + t.tile.height) / self.grid.per_side);
        let last_row = |t: &TileShares<3>| t.y + i64::from(t.values.len() as u32 / t.width);
        let last_rows = tiles.iter().filter_map(|t| t.colors.as_ref()).map(last_row);
        let height = i64::from(self.grid.height);
        let end = last_rows.max().map_or(band_end, |end| end.clamp(0, height) as u32);
        let place = Place { grid: self.grid, first: self.first, rows: end - self.first };
        let open = &mut self.open;
        if colors.is_empty() {
            place.add(Some(&mut open.colors), tiles.iter().filter_map(|tile| tile.colors.as_ref()));
        } else {
            open.colors = colors;
        }
        let full = tiles.iter().filter_map(|tile| tile.full.as_ref());
        place.add(open.alpha.as_mut(), tiles.iter().filter_map(|tile| tile.alpha.as_ref()));
        place.add(open.full.as_mut(), full.clone().map(|full| &full.colors));
        place.add(open.full_alpha.as_mut(), full.filter_map(|full| full.alpha.as_ref()));
        self.make_room_for_layers(place.rows);
        tiles.iter().for_each(|tile| self.copy_layers(tile));
        // With a wide filter the next band still adds to this band's last row.
        let is_last = band_end == self.grid.height;
        let waiting = if is_last || end == band_end { 0 } else { end - band_end + 1 };
        self.hand_out(end - waiting - self.first)
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
                let place = (part.tile.y / n + row - self.first) * self.grid.width + part.tile.x / n;
                rows.copy_run(place as usize, layer, row as usize * columns, columns);
            }
        }
    }

    /// Splits off the first rows.
    fn hand_out(&mut self, rows: u32) -> Rows {
        let count = (rows * self.grid.width) as usize;
        let OpenRows { colors, alpha, full, full_alpha, layers } = &mut self.open;
        let alphas = |plane: &mut Vec<[f32; 1]>| split_front(plane, count).into_flattened();
        let handed = Rows {
            first: self.first,
            width: self.grid.width,
            colors: split_front(colors, count),
            alpha: alpha.as_mut().map(alphas),
            full: full.as_mut().map(|full| split_front(full, count)),
            full_alpha: full_alpha.as_mut().map(alphas),
            layers: layers.iter_mut().map(|layer| layer.split_front(count)).collect(),
        };
        self.first += rows;
        handed
    }
}

fn split_front<T>(values: &mut Vec<T>, count: usize) -> Vec<T> {
    let rest = values.split_off(count);
    std::mem::replace(values, rest)
}

/// Where open rows lie in the picture.
struct Place<'a> {
    grid: &'a SampleGrid,
    first: u32,
    rows: u32,
}

impl Place<'_> {
    /// Adds the shares of a band's tiles to open rows, if there are any.
    fn add<'t, const N: usize>(
        &self,
        open: Option<&mut Vec<[f32; N]>>,
        tiles: impl Iterator<Item = &'t TileShares<N>> + Clone,
    ) {
        let Some(open) = open else { return };
        let width: usize = tiles.clone().map(|tile| tile.width as usize).sum();
        if open.is_empty() && width == self.grid.width as usize {
            // No tile reaches into another: rows are joined as they are.
            open.reserve_exact(self.rows as usize * width);
            let mut lines: Vec<_> = tiles.map(|tile| tile.values.chunks_exact(tile.width as usize)).collect();
            for _ in 0..self.rows {
                lines.iter_mut().filter_map(Iterator::next).for_each(|line| open.extend_from_slice(line));
            }
            return;
        }
        open.resize((self.rows * self.grid.width) as usize, [0.0; N]);
        tiles.for_each(|tile| self.add_tile(open, tile));
    }

    fn add_tile<const N: usize>(&self, open: &mut [[f32; N]], part: &TileShares<N>) {
        let (width, height) = (i64::from(self.grid.width), i64::from(self.grid.height));
        // Filters reach beyond the picture's edge.
        let begin = part.x.max(0);
        let end = (part.x + i64::from(part.width)).min(width);
        for (row, values) in (part.y..).zip(part.values.chunks_exact(part.width as usize)) {
            if !(0..height).contains(&row) {
                continue;
            }
            let place = (row - i64::from(self.first)) * width;
            let sums = &mut open[(place + begin) as usize..(place + end) as usize];
            let values = &values[(begin - part.x) as usize..(end - part.x) as usize];
            for (sum, value) in sums.iter_mut().zip(values) {
                *sum = std::array::from_fn(|c| sum[c] + value[c]);
            }
        }
    }
}
