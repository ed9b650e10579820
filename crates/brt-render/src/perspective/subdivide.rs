//! Painting a tile: bounds over blocks first, a Z-buffer for the rest.

use std::cell::LazyCell;

use brt_geometry::{RayBlock, Start};

use super::block_hit::BlockHit;
use super::depth_buffer::{DepthBuffer, SIDE};
use super::forms::Forms;
use super::outlines::Outline;
use crate::prepare::PreparedCamera;
use crate::products::{Area, MIXED, NOTHING, PerspectiveImage, PreparedScene, Tile};
use crate::run::{Cancel, Run};

/// Primitives whose outlines have fewer samples in a tile are tested ray by ray: forms would not pay.
const LEAST_SAMPLES_FOR_FORMS: u32 = 64;

/// Stands for "no forms".
const NO_FORMS: u32 = u32::MAX;

/// Paints tiles of the perspective image; keeps its working memory.
pub(crate) struct Painter<'a> {
    scene: &'a PreparedScene,
    camera: &'a PreparedCamera,
    /// Forms of the tile's larger primitives.
    forms: Vec<Forms>,
    /// Candidates of the blocks that are open, each block's behind its parent's.
    candidates: Vec<Candidate>,
    /// Hits of the candidates of one block; `None` where they were not looked for.
    hits: Vec<Option<BlockHit>>,
    buffer: DepthBuffer<'a>,
    cancel: Cancel<'a>,
}

/// A primitive that may be seen in a block.
#[derive(Clone, Copy)]
struct Candidate {
    outline: Outline,
    /// Position of its forms or [`NO_FORMS`].
    forms: u32,
}

impl<'a> Painter<'a> {
    pub(crate) fn new(scene: &'a PreparedScene, camera: &'a PreparedCamera, run: &Run<'a>) -> Self {
        let buffer = DepthBuffer::new(scene, camera, run.simd);
        Self {
            scene,
            camera,
            forms: Vec::new(),
            candidates: Vec::new(),
            hits: Vec::new(),
            buffer,
            cancel: run.cancel(),
        }
    }

    /// Paints a tile, given the outlines that reach into it in the order of primitives.
    pub(crate) fn paint(&mut self, tile: &Tile, outlines: &[Outline], image: &mut PerspectiveImage) {
        image.reset(tile);
        let area = tile.area();
        self.start_with(tile, area, outlines);
        image.clear.extend(self.candidates.iter().filter(|c| self.has_edges(c)).map(|c| c.outline.primitive));
        self.paint_area(area, 0, &mut Canvas { tile, image, scene: self.scene });
    }

    /// The same row by row: a scan-line Z-buffer (Watkins 1970, without his sorting).
    pub(crate) fn scan(&mut self, tile: &Tile, outlines: &[Outline], image: &mut PerspectiveImage) {
        image.reset(tile);
        let mut canvas = Canvas { tile, image, scene: self.scene };
        let mut nearest = vec![(f64::INFINITY, NOTHING); tile.width as usize];
        for y in tile.y..tile.y + tile.height {
            if self.cancel.is_set() {
                return;
            }
            let row = Area { x0: tile.x, y0: y, x1: tile.x + tile.width, y1: y + 1 };
            nearest.fill((f64::INFINITY, NOTHING));
            for outline in outlines {
                let Some(part) = outline.clip(&row) else { continue };
                self.keep_nearer(part, tile.x, outline.primitive, &mut nearest);
            }
            for (x, &(_, primitive)) in (tile.x..).zip(&nearest) {
                canvas.fill(Area { x0: x, x1: x + 1, ..row }, primitive);
            }
        }
    }

    /// Tests a primitive on samples of one row that begins at column `first`.
    fn keep_nearer(&self, part: Area, first: u32, id: u32, nearest: &mut [(f64, u32)]) {
        let primitive = &self.scene.primitives[id as usize];
        for x in part.x0..part.x1 {
            let hit = primitive.first_hit(&self.camera.sample_ray([x, part.y0]), Start::Elsewhere);
            let at = &mut nearest[(x - first) as usize];
            // Primitives come in the order of ids: of equally near ones the first stays.
            if hit.found && hit.t < at.0 {
                *at = (hit.t, id);
            }
        }
    }

    /// Makes the outlines the tile's candidates.
    fn start_with(&mut self, tile: &Tile, area: Area, outlines: &[Outline]) {
        self.forms.clear();
        self.candidates.clear();
        let rays = RayBlock::new(self.camera.block(&area));
        for outline in outlines {
            let samples = |part: Area| (part.x1 - part.x0) * (part.y1 - part.y0);
            let pays = self.camera.is_perspective
                && outline.clip(&area).is_some_and(|part| samples(part) >= LEAST_SAMPLES_FOR_FORMS);
            let primitive = &self.scene.primitives[outline.primitive as usize];
            let forms = pays.then(|| Forms::new(primitive, &rays, tile, &self.camera.pattern)).flatten();
            let place = if forms.is_some() { self.forms.len() as u32 } else { NO_FORMS };
            self.forms.extend(forms);
            self.candidates.push(Candidate { outline: *outline, forms: place });
        }
    }

    /// Do forms tell how far samples are from a candidate's edges?
    fn has_edges(&self, candidate: &Candidate) -> bool {
        matches!(self.forms.get(candidate.forms as usize), Some(Forms::Flat(forms)) if !forms.edges.is_empty())
    }

    /// Paints an area, its candidates being those from `first` on. Takes them off the list.
    fn paint_area(&mut self, area: Area, first: usize, canvas: &mut Canvas) {
        if self.cancel.is_set() {
            return;
        }
        self.keep_what_may_be_seen(area, first, canvas.tile);
        let left = &self.candidates[first..];
        if left.is_empty() {
            canvas.fill_whole(area, NOTHING);
        } else if left.len() == 1 && self.hits[0].is_some_and(|hit| hit.is_everywhere) {
            canvas.fill_whole(area, left[0].outline.primitive);
        } else if area.is_within(SIDE as u32) {
            self.paint_samples(area, first, canvas);
        } else {
            for part in area.quarters() {
                let end = self.candidates.len();
                for i in first..end {
                    if self.candidates[i].outline.meets(&part) {
                        self.candidates.push(self.candidates[i]);
                    }
                }
                self.paint_area(part, end, canvas);
            }
        }
        self.candidates.truncate(first);
    }

    /// Removes candidates that certainly miss the area or are certainly behind one that covers it.
    fn keep_what_may_be_seen(&mut self, area: Area, first: usize, tile: &Tile) {
        // Most need no rays.
        let camera = self.camera;
        let rays = LazyCell::new(move || camera.block(&area));
        self.hits.clear();
        for Candidate { outline, forms } in &self.candidates[first..] {
            let hit = match self.forms.get(*forms as usize) {
                Some(Forms::Flat(forms)) => Some(BlockHit::of_flat(forms, &area, tile)),
                Some(Forms::Round(forms)) => Some(BlockHit::of_round(forms, &rays, &area, tile)),
                // Small primitives cannot cover the area; bounds on them rarely pay.
                None => outline
                    .contains(&area)
                    .then(|| BlockHit::of(&self.scene.primitives[outline.primitive as usize], &rays)),
            };
            self.hits.push(hit);
        }
        let covering = |hit: &Option<BlockHit>| hit.filter(|hit| hit.is_everywhere);
        let front = self.hits.iter().filter_map(covering).min_by(|a, b| a.farthest.total_cmp(&b.farthest));
        let limit = front.map_or(f64::INFINITY, |hit| hit.farthest);
        let first_cover = self.first_cover(first);
        let is_seen = |candidate: &Candidate, hit: &Option<BlockHit>| match hit {
            Some(hit) => hit.is_anywhere && front.is_none_or(|front| hit.may_be_before(&front)),
            None => candidate.outline.nearest <= limit,
        };
        let mut kept = 0;
        for i in 0..self.hits.len() {
            let candidate = &self.candidates[first + i];
            let is_hidden =
                first_cover.is_some_and(|id| self.scene.hides_coincident(id, candidate.outline.primitive));
            if !is_hidden && is_seen(candidate, &self.hits[i]) {
                self.candidates[first + kept] = self.candidates[first + i];
                self.hits[kept] = self.hits[i];
                kept += 1;
            }
        }
        self.candidates.truncate(first + kept);
        self.hits.truncate(kept);
    }

    /// The first face that covers the area, of those that several are: it hides what coincides with it. Their depths are one,
    /// so comparing them would tell nothing.
    fn first_cover(&self, first: usize) -> Option<u32> {
        let covers = |(_, hit): &(&Candidate, &Option<BlockHit>)| hit.is_some_and(|hit| hit.is_everywhere);
        let candidates = self.candidates[first..].iter().zip(&self.hits);
        candidates.filter(covers).map(|(candidate, _)| candidate.outline.primitive).min()
    }

    /// Z-buffer over the samples of a small area.
    fn paint_samples(&mut self, area: Area, first: usize, canvas: &mut Canvas) {
        let forms = &self.forms;
        let candidates = self.candidates[first..].iter().map(|c| (&c.outline, forms.get(c.forms as usize)));
        self.buffer.draw(canvas.tile, area, &candidates);
        canvas.image.areas.push((area, MIXED));
        let Tile { x: left, y: top, .. } = *canvas.tile;
        canvas.image.doubtful.extend(self.buffer.on_edges().map(|[x, y]| [x - left, y - top]));
        for y in area.y0..area.y1 {
            canvas.fill_row(area.x0, y, self.buffer.row(y));
        }
    }
}

/// Where a tile is painted.
struct Canvas<'a> {
    tile: &'a Tile,
    image: &'a mut PerspectiveImage,
    scene: &'a PreparedScene,
}

impl Canvas<'_> {
    fn surface_of(&self, primitive: u32) -> u32 {
        match primitive {
            NOTHING => NOTHING,
            id => self.scene.infos[id as usize].surface,
        }
    }

    /// Paints samples of one row from column `x` on.
    fn fill_row(&mut self, x: u32, y: u32, primitives: impl Iterator<Item = u32>) {
        let start = self.tile.index(x - self.tile.x, y - self.tile.y);
        for (i, primitive) in (start..).zip(primitives) {
            self.image.primitive[i] = primitive;
            self.image.surface[i] = self.surface_of(primitive);
        }
    }

    fn fill_whole(&mut self, area: Area, primitive: u32) {
        self.image.areas.push((area, primitive));
        self.fill(area, primitive);
    }

    fn fill(&mut self, area: Area, primitive: u32) {
        let surface = self.surface_of(primitive);
        for y in area.y0..area.y1 {
            let start = self.tile.index(area.x0 - self.tile.x, y - self.tile.y);
            let end = start + (area.x1 - area.x0) as usize;
            self.image.primitive[start..end].fill(primitive);
            self.image.surface[start..end].fill(surface);
        }
    }
}
