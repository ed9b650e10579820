//! A Z-buffer for the samples of a small block.

use std::array::from_fn;

use brt_geometry::{Lanes, Ray, Real, SimdLevel, Start};

use super::forms::{FlatForms, Forms, LinearForm, RoundForms};
use super::outlines::Outline;
use crate::margins::QUOTIENT_ROUNDINGS;
use crate::prepare::PreparedCamera;
use crate::products::{Area, NOTHING, PreparedScene, Tile};

/// Samples along the side of the largest block: a row has a lane for each.
pub(super) const SIDE: usize = brt_geometry::LANES;

/// What each sample of a block meets first.
pub(super) struct DepthBuffer<'a> {
    scene: &'a PreparedScene,
    camera: &'a PreparedCamera,
    simd: SimdLevel,
    area: Area,
    samples: [[Sample; SIDE]; SIDE],
    /// Inverse depths from forms may be off by this.
    margin: f64,
    /// Edges of one candidate that cross the block.
    crossing: Vec<LinearForm>,
    /// The rays of each row, once they are needed.
    rays: [Option<Ray<Lanes>>; SIDE],
}

#[derive(Clone, Copy)]
struct Sample {
    nearest: u32,
    inverse_depth: f64,
    /// Could rounding have decided?
    is_doubtful: bool,
    /// Does it lie on an edge, or nearly?
    is_on_edge: bool,
}

impl Sample {
    const EMPTY: Self = Self { nearest: NOTHING, inverse_depth: 0.0, is_doubtful: false, is_on_edge: false };
}

impl<'a> DepthBuffer<'a> {
    pub(super) fn new(scene: &'a PreparedScene, camera: &'a PreparedCamera, simd: SimdLevel) -> Self {
        let area = Area { x0: 0, y0: 0, x1: 0, y1: 0 };
        let samples = [[Sample::EMPTY; SIDE]; SIDE];
        let (crossing, rays) = (Vec::new(), [None; SIDE]);
        Self { scene, camera, simd, area, samples, margin: 0.0, crossing, rays }
    }

    /// Draws all candidates of an area, in the order of ids; each with its forms if it has any.
    pub(super) fn draw<'b>(
        &mut self,
        tile: &Tile,
        area: Area,
        candidates: &(impl Iterator<Item = (&'b Outline, Option<&'b Forms>)> + Clone),
    ) {
        self.area = area;
        self.samples = [[Sample::EMPTY; SIDE]; SIDE];
        self.rays = [None; SIDE];
        let margins = candidates.clone().filter_map(|(_, forms)| Some(forms?.depth_margin()));
        self.margin = 2.0 * margins.fold(0.0, f64::max);
        for (outline, forms) in candidates.clone() {
            let Some(part) = outline.clip(&area) else { continue };
            match forms {
                Some(Forms::Flat(forms)) => self.draw_flat(tile, part, outline.primitive, forms),
                Some(Forms::Round(forms)) => self.draw_round(tile, part, outline.primitive, forms),
                None => self.draw_exactly(part, outline.primitive),
            }
        }
        for y in area.y0..area.y1 {
            for x in area.x0..area.x1 {
                if self.sample(x, y).is_doubtful {
                    self.sample(x, y).nearest = self.nearest_by_ray(x, y, candidates.clone().map(|c| c.0));
                }
            }
        }
    }

    /// What the samples of one row of the area meet, from the left to the right.
    pub(super) fn row(&self, y: u32) -> impl Iterator<Item = u32> {
        let width = (self.area.x1 - self.area.x0) as usize;
        self.samples[(y - self.area.y0) as usize][..width].iter().map(|sample| sample.nearest)
    }

    /// Samples on edges, by column and row of the picture.
    pub(super) fn on_edges(&self) -> impl Iterator<Item = [u32; 2]> {
        let Area { x0, y0, .. } = self.area;
        let rows = (y0..).zip(&self.samples);
        rows.flat_map(move |(y, row)| (x0..).zip(row).filter(|(_, s)| s.is_on_edge).map(move |(x, _)| [x, y]))
    }

    /// Tests a primitive with the rays of a part of the area.
    fn draw_exactly(&mut self, part: Area, id: u32) {
        let primitive = &self.scene.primitives[id as usize];
        for y in part.y0..part.y1 {
            let hit = self.simd.run(
                #[inline(always)]
                || primitive.first_hit(self.rays_of(y), Start::Elsewhere),
            );
            for x in part.x0..part.x1 {
                let lane = (x - self.area.x0) as usize;
                if hit.found.has(lane) {
                    self.keep_nearer(x, y, id, 1.0 / hit.t.0[lane]);
                }
            }
        }
    }

    /// The rays of a row of the block and, where it is narrower than that, beyond.
    #[inline(always)]
    fn rays_of(&mut self, y: u32) -> &Ray<Lanes> {
        let [column, row] = self.positions(y, [0, 0]);
        let camera = self.camera;
        self.rays[(y - self.area.y0) as usize].get_or_insert_with(
            #[inline(always)]
            || camera.ray(Lanes(column), Lanes(row)),
        )
    }

    /// The same by the primitive's forms.
    fn draw_flat(&mut self, tile: &Tile, part: Area, id: u32, forms: &FlatForms) {
        let crosses = |edge: &&LinearForm| edge.over(&part, tile).range()[0] <= 0.0;
        self.crossing.clear();
        self.crossing.extend(forms.edges.iter().filter(crosses));
        // A sample is outside if edges differ in sign: that takes one edge that it is certainly inside of.
        if !self.crossing.is_empty() && self.crossing.len() == forms.edges.len() {
            self.draw_exactly(part, id);
            return self.find_on_edges(tile, part, &forms.edges);
        }
        for y in part.y0..part.y1 {
            let [column, row] = self.positions(y, [tile.x, tile.y]);
            let depth: [f64; SIDE] = from_fn(|i| forms.inverse_depth.at(column[i], row[i]));
            // Inside if the first is positive, outside if the second is negative.
            let mut inside = depth.map(|d| d - forms.least);
            let mut outside = depth.map(|d| d + forms.least);
            for edge in &self.crossing {
                for i in 0..SIDE {
                    let side = edge.at(column[i], row[i]);
                    inside[i] = Real::min(inside[i], side - edge.margin);
                    outside[i] = Real::min(outside[i], side + edge.margin);
                }
            }
            for x in part.x0..part.x1 {
                let i = (x - self.area.x0) as usize;
                if inside[i] > 0.0 {
                    self.keep_nearer(x, y, id, depth[i]);
                } else if outside[i] >= 0.0 && !self.is_hidden(x, y, id) {
                    let sample = self.sample(x, y);
                    (sample.is_doubtful, sample.is_on_edge) = (true, true);
                }
            }
        }
    }

    /// Finds the samples on edges where rays have told what is inside.
    fn find_on_edges(&mut self, tile: &Tile, part: Area, edges: &[LinearForm]) {
        for y in part.y0..part.y1 {
            let [column, row] = self.positions(y, [tile.x, tile.y]);
            for x in part.x0..part.x1 {
                let i = (x - self.area.x0) as usize;
                let is_near = |edge: &LinearForm| edge.at(column[i], row[i]).abs() <= edge.margin;
                self.sample(x, y).is_on_edge |= edges.iter().any(is_near);
            }
        }
    }

    /// Where the samples of a row of the area lie, seen from a sample's place.
    #[inline(always)]
    fn positions(&self, y: u32, [from_x, from_y]: [u32; 2]) -> [[f64; SIDE]; 2] {
        let (pattern, x0) = (&self.camera.pattern, self.area.x0);
        let column = f64::from(x0 - from_x) + pattern.shift(y);
        let row = f64::from(y - from_y);
        [from_fn(|i| column + i as f64), from_fn(|i| row - pattern.shift(x0 + i as u32))]
    }

    fn draw_round(&mut self, tile: &Tile, part: Area, id: u32, forms: &RoundForms) {
        for y in part.y0..part.y1 {
            let [column, row] = self.positions(y, [tile.x, tile.y]);
            let b: [f64; SIDE] = from_fn(|i| forms.b.at(column[i], row[i]));
            let [x, y_position] = self.positions(y, [0, 0]);
            let dd: [f64; SIDE] = from_fn(|i| RoundForms::dd(self.camera, x[i], y_position[i]));
            for x in part.x0..part.x1 {
                let i = (x - self.area.x0) as usize;
                let discriminant = b[i] * b[i] - forms.c.c * dd[i];
                if discriminant > forms.margin && b[i] < -forms.b.margin {
                    self.keep_nearer(x, y, id, forms.inverse_depth(b[i], discriminant));
                } else if discriminant >= -forms.margin && b[i] <= forms.b.margin {
                    self.sample(x, y).is_doubtful = true;
                }
            }
        }
    }

    /// Keeps the nearer of two hits; marks the sample where rounding could decide which that is.
    #[inline(always)]
    fn keep_nearer(&mut self, x: u32, y: u32, id: u32, inverse_depth: f64) {
        let margin = self.margin + QUOTIENT_ROUNDINGS * inverse_depth;
        let sample = self.sample(x, y);
        let difference = inverse_depth - sample.inverse_depth;
        if difference > margin {
            (sample.nearest, sample.inverse_depth) = (id, inverse_depth);
        } else if (difference >= -margin || difference.is_nan()) && !self.is_hidden(x, y, id) {
            self.sample(x, y).is_doubtful = true;
        }
    }

    /// Does a sample certainly show a face that comes before this one in the same plane?
    fn is_hidden(&mut self, x: u32, y: u32, id: u32) -> bool {
        let nearest = self.sample(x, y).nearest;
        self.scene.hides_coincident(nearest, id)
    }

    #[inline(always)]
    fn sample(&mut self, x: u32, y: u32) -> &mut Sample {
        &mut self.samples[(y - self.area.y0) as usize][(x - self.area.x0) as usize]
    }

    /// The primitive that a sample's ray meets first.
    fn nearest_by_ray<'b>(&self, x: u32, y: u32, outlines: impl Iterator<Item = &'b Outline>) -> u32 {
        let ray = self.camera.sample_ray([x, y]);
        let (mut nearest, mut t) = (NOTHING, f64::INFINITY);
        for outline in outlines {
            let hit = self.scene.primitives[outline.primitive as usize].first_hit(&ray, Start::Elsewhere);
            // Candidates come in the order of ids: of equally near ones the first stays.
            if hit.found && hit.t < t {
                (nearest, t) = (outline.primitive, hit.t);
            }
        }
        nearest
    }
}
