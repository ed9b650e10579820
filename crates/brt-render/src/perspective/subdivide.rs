//! Painting a tile: bounds over blocks first, a Z-buffer for the rest.

use brt_geometry::{Hit, Mask, Ray, Real, Start, Taylor};

use super::outlines::Outline;
use crate::prepare::PreparedCamera;
use crate::products::{Area, NOTHING, PerspectiveImage, PreparedScene, Tile};

/// Blocks of this side and less are not divided further: their samples go through the Z-buffer.
const SMALLEST_BLOCK: u32 = 8;

/// Paints tiles of the perspective image; keeps its working memory.
pub(crate) struct Painter<'a> {
    scene: &'a PreparedScene,
    camera: &'a PreparedCamera,
    /// Candidates of the blocks that are open, each block's behind its parent's.
    candidates: Vec<Outline>,
    /// Hits of the candidates of one block.
    hits: Vec<Option<Hit<Taylor>>>,
}

impl<'a> Painter<'a> {
    pub(crate) fn new(scene: &'a PreparedScene, camera: &'a PreparedCamera) -> Self {
        Self { scene, camera, candidates: Vec::new(), hits: Vec::new() }
    }

    /// Paints a tile, given the outlines that reach into it in the order of primitives.
    pub(crate) fn paint(&mut self, tile: &Tile, outlines: &[Outline], image: &mut PerspectiveImage) {
        image.reset(tile);
        self.candidates.clear();
        self.candidates.extend_from_slice(outlines);
        let area = Area { x0: tile.x, y0: tile.y, x1: tile.x + tile.width, y1: tile.y + tile.height };
        self.paint_area(area, 0, &mut Canvas { tile, image, scene: self.scene });
    }

    /// The same row by row: a scan-line Z-buffer (Watkins 1970, without his sorting).
    pub(crate) fn scan(&mut self, tile: &Tile, outlines: &[Outline], image: &mut PerspectiveImage) {
        image.reset(tile);
        let mut canvas = Canvas { tile, image, scene: self.scene };
        let mut nearest = vec![(f64::INFINITY, NOTHING); tile.width as usize];
        for y in tile.y..tile.y + tile.height {
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
            let hit =
                primitive.first_hit(&self.camera.ray(f64::from(x), f64::from(part.y0)), Start::Elsewhere);
            let at = &mut nearest[(x - first) as usize];
            // Primitives come in the order of ids: of equally near ones the first stays.
            if hit.found && hit.t < at.0 {
                *at = (hit.t, id);
            }
        }
    }

    /// Paints an area, its candidates being those from `first` on. Takes them off the list.
    fn paint_area(&mut self, area: Area, first: usize, canvas: &mut Canvas) {
        self.keep_what_may_be_seen(area, first);
        let left = &self.candidates[first..];
        if left.is_empty() {
            canvas.fill(area, NOTHING);
        } else if left.len() == 1 && self.hits[0].is_some_and(|hit| hit.found.all()) {
            canvas.fill(area, left[0].primitive);
        } else if area.is_within(SMALLEST_BLOCK) {
            self.paint_samples(area, first, canvas);
        } else {
            for part in area.quarters() {
                let end = self.candidates.len();
                for i in first..end {
                    if self.candidates[i].meets(&part) {
                        self.candidates.push(self.candidates[i]);
                    }
                }
                self.paint_area(part, end, canvas);
            }
        }
        self.candidates.truncate(first);
    }

    /// Removes candidates that certainly miss the area or are certainly behind one that covers it.
    fn keep_what_may_be_seen(&mut self, area: Area, first: usize) {
        let ray = self.block_of_rays(area);
        self.hits.clear();
        let scene = self.scene;
        // Small primitives cannot cover the area; bounds on them rarely pay.
        self.hits.extend(self.candidates[first..].iter().map(|outline| {
            let primitive = &scene.primitives[outline.primitive as usize];
            outline.contains(&area).then(|| primitive.first_hit(&ray, Start::Elsewhere))
        }));
        let covering = |hit: &Option<Hit<Taylor>>| hit.filter(|hit| hit.found.all());
        let greatest = |hit: &Hit<Taylor>| hit.t.range()[1];
        let front = self.hits.iter().filter_map(covering).min_by(|a, b| greatest(a).total_cmp(&greatest(b)));
        let limit = front.map_or(f64::INFINITY, |hit| greatest(&hit));
        let is_seen = |outline: &Outline, hit: &Option<Hit<Taylor>>| match hit {
            Some(hit) => hit.found.any() && front.is_none_or(|front| hit.t.le(front.t).any()),
            None => outline.nearest <= limit,
        };
        let mut kept = 0;
        for i in 0..self.hits.len() {
            if is_seen(&self.candidates[first + i], &self.hits[i]) {
                self.candidates[first + kept] = self.candidates[first + i];
                self.hits[kept] = self.hits[i];
                kept += 1;
            }
        }
        self.candidates.truncate(first + kept);
        self.hits.truncate(kept);
    }

    /// The rays of all samples of an area.
    fn block_of_rays(&self, area: Area) -> Ray<Taylor> {
        let [x, y] = area.coordinates();
        self.camera.ray(x, y)
    }

    /// Z-buffer over the samples of a small area.
    fn paint_samples(&mut self, area: Area, first: usize, canvas: &mut Canvas) {
        const SIDE: usize = SMALLEST_BLOCK as usize;
        let mut depth = [[f64::INFINITY; SIDE]; SIDE];
        let mut nearest = [[NOTHING; SIDE]; SIDE];
        for outline in &self.candidates[first..] {
            let primitive = &self.scene.primitives[outline.primitive as usize];
            let Some(part) = outline.clip(&area) else { continue };
            for y in part.y0..part.y1 {
                for x in part.x0..part.x1 {
                    let ray = self.camera.ray(f64::from(x), f64::from(y));
                    let hit = primitive.first_hit(&ray, Start::Elsewhere);
                    let at = &mut depth[(y - area.y0) as usize][(x - area.x0) as usize];
                    // Candidates come in the order of ids: of equally near ones the first stays.
                    if hit.found && hit.t < *at {
                        *at = hit.t;
                        nearest[(y - area.y0) as usize][(x - area.x0) as usize] = outline.primitive;
                    }
                }
            }
        }
        for y in area.y0..area.y1 {
            for x in area.x0..area.x1 {
                let primitive = nearest[(y - area.y0) as usize][(x - area.x0) as usize];
                canvas.fill(Area { x0: x, y0: y, x1: x + 1, y1: y + 1 }, primitive);
            }
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
    fn fill(&mut self, area: Area, primitive: u32) {
        let surface = match primitive {
            NOTHING => NOTHING,
            id => self.scene.infos[id as usize].surface,
        };
        for y in area.y0..area.y1 {
            let start = self.tile.index(area.x0 - self.tile.x, y - self.tile.y);
            let end = start + (area.x1 - area.x0) as usize;
            self.image.primitive[start..end].fill(primitive);
            self.image.surface[start..end].fill(surface);
        }
    }
}
