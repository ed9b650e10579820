//! Regions: where a tile shows one primitive, as areas of the perspective image's own division.

use crate::products::{Area, MIXED, PerspectiveImage, Tile};

/// An area that shows a primitive, as a whole or in some of its samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Region {
    pub(super) primitive: u32,
    pub(super) area: Area,
    /// How many samples show the primitive, at least 1.
    pub(super) samples: u32,
}

impl Region {
    pub(super) fn is_whole(&self) -> bool {
        self.samples == self.area.sample_count()
    }
}

/// How many samples regions have together.
pub(super) fn samples_of(regions: &[Region]) -> u32 {
    regions.iter().map(|region| region.samples).sum()
}

/// The regions of a tile, by primitive; those of one in the order of the division.
pub(super) fn regions_of(image: &PerspectiveImage, tile: &Tile) -> Vec<Region> {
    let mut regions = Vec::with_capacity(image.areas.len());
    for &(area, primitive) in &image.areas {
        if primitive == MIXED {
            add_mixed(area, image, tile, &mut regions);
        } else {
            regions.push(Region { primitive, area, samples: area.sample_count() });
        }
    }
    regions.sort_by_key(|region| region.primitive);
    regions
}

/// Adds a region for each primitive that an area shows.
fn add_mixed(area: Area, image: &PerspectiveImage, tile: &Tile, regions: &mut Vec<Region>) {
    let first = regions.len();
    for y in area.y0..area.y1 {
        for &primitive in shown(image, tile, &area, y) {
            // Neighbours mostly show what was met last.
            match regions[first..].iter_mut().rev().find(|region| region.primitive == primitive) {
                Some(region) => region.samples += 1,
                None => regions.push(Region { primitive, area, samples: 1 }),
            }
        }
    }
}

/// The primitives shown by one row of an area.
fn shown<'a>(image: &'a PerspectiveImage, tile: &Tile, area: &Area, y: u32) -> &'a [u32] {
    let start = tile.index(area.x0 - tile.x, y - tile.y);
    &image.primitive[start..start + (area.x1 - area.x0) as usize]
}

/// The part of a region in a quarter of its area; may have no samples.
pub(super) fn part_of(region: &Region, quarter: Area, image: &PerspectiveImage, tile: &Tile) -> Region {
    let count = |y: u32| shown(image, tile, &quarter, y).iter().filter(|&&p| p == region.primitive).count();
    let samples = (quarter.y0..quarter.y1).map(count).sum::<usize>() as u32;
    Region { area: quarter, samples, ..*region }
}

/// The smallest part of an area's division that holds all of the regions.
pub(super) fn smallest_around(regions: &[Region], mut area: Area) -> Area {
    let around = regions.iter().map(|region| region.area).reduce(|a, b| a.joined(&b)).unwrap_or(area);
    while area != around
        && let Some(quarter) = area.quarters().find(|quarter| quarter.contains(&around))
    {
        area = quarter;
    }
    area
}

/// Those regions that lie in a quarter of the area that they divide.
pub(super) fn inside(regions: &[Region], quarter: Area) -> &[Region] {
    let is_inside = |region: &Region| quarter.contains(&region.area);
    let Some(first) = regions.iter().position(is_inside) else { return &[] };
    let count = regions[first..].iter().take_while(|region| is_inside(region)).count();
    &regions[first..first + count]
}
