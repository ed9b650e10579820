//! Sheets: pieces of smooth meshes, filled across the edges of their triangles.
//!
//! A block of a fine mesh shows many triangles. Which one each sample shows is known from the perspective image. Between
//! their corners, points lie near one plane, and normals are nearly linear in where the points are ([`fit`]): both are
//! averages of those at the corners, so what the corners deviate from the plane and the line bounds all points between
//! them. That gives one colour model for the whole block, given how it sees the lights ([`lighting`]).

mod facet;
mod fit;
mod lighting;
#[cfg(test)]
mod tests;

use brt_geometry::{Real, Taylor};
use brt_image::Rgb;

use self::facet::{Facet, Facets};
use self::fit::fitted;
use self::lighting::{LightsOfSheet, light_of_sheet};
use super::Certified;
use crate::filling::LinearFill;
use crate::products::{
    Area, Certificate, NO_COLORS, NO_NORMALS, NO_TEXCOORDS, NOTHING, PreparedLight, PreparedScene,
    SampleState,
};
use crate::tracing::Patch;

/// Blocks of this side are not divided: what they leave is traced.
const LEAST_SIDE: u32 = 8;

/// Fewer samples of a block are traced.
const LEAST_SHOWN: usize = 24;

/// Blocks whose triangles have fewer samples on the average are traced.
const LEAST_EACH: usize = 14;

/// Blocks that show more triangles are divided.
const MOST_FACETS: usize = 48;

/// Is a primitive a part of a smooth mesh whose colours can be bounded?
pub(super) fn is_of_sheet(scene: &PreparedScene, primitive: u32) -> bool {
    let info = &scene.infos[primitive as usize];
    let is_smooth = info.normals != NO_NORMALS && info.colors == NO_COLORS && info.texcoords == NO_TEXCOORDS;
    let material = &scene.materials[info.material as usize];
    is_smooth && material.ends_view() && material.reflection == 0.0 && material.checker.is_none()
}

impl Certified<'_, '_> {
    /// Fills what can be of the pending samples of an area; the others stay pending.
    pub(super) fn fill_sheets(&mut self, area: Area) {
        let is_left = match self.shown_in(area) {
            Shown::Sheet(facets) => !self.fill_sheet(area, &facets),
            Shown::Several => true,
            Shown::Other => false,
        };
        if is_left && !area.is_within(LEAST_SIDE) {
            self.worker.tracer.counters.blocks.divided += 1;
            area.quarters().for_each(|quarter| self.fill_sheets(quarter));
        }
    }

    /// What an area's pending samples show.
    fn shown_in(&self, area: Area) -> Shown {
        let scene = self.follower.scene;
        let (mut ids, mut last, mut count) = (Vec::with_capacity(2 * MOST_FACETS), NOTHING, 0);
        self.for_each_pending(area, |_, _, primitive| {
            count += 1;
            if primitive != last {
                last = primitive;
                ids.push(primitive);
            }
        });
        if count < LEAST_SHOWN {
            return Shown::Other;
        }
        ids.sort_unstable();
        ids.dedup();
        let of = |id: u32| {
            let info = &scene.infos[id as usize];
            (info.surface, info.material)
        };
        if ids.len() > MOST_FACETS
            || count < LEAST_EACH * ids.len()
            || ids.iter().any(|&id| of(id) != of(ids[0]))
        {
            return Shown::Several;
        }
        if !is_of_sheet(scene, ids[0]) {
            return Shown::Other;
        }
        Facets::new(scene, self.worker.camera, area, &ids).map_or(Shown::Several, Shown::Sheet)
    }

    /// Calls for all pending samples of an area, by column and row of the picture, with what they show.
    fn for_each_pending(&self, area: Area, mut act: impl FnMut(u32, u32, u32)) {
        for y in area.y0..area.y1 {
            let start = self.tile.index(area.x0 - self.tile.x, y - self.tile.y);
            let run = start..start + (area.x1 - area.x0) as usize;
            let shown = &self.worker.perspective.primitive[run.clone()];
            for ((x, &primitive), state) in (area.x0..).zip(shown).zip(&self.worker.samples.state[run]) {
                if *state == SampleState::Pending {
                    act(x, y, primitive);
                }
            }
        }
    }

    /// Fills what is linear of a sheet; returns whether nothing is gained by dividing it.
    fn fill_sheet(&mut self, area: Area, facets: &Facets) -> bool {
        self.worker.tracer.counters.blocks.judged += 1;
        let (scene, camera) = (self.follower.scene, self.worker.camera);
        let patch = fitted(scene, camera, area, facets, &facets.all);
        self.follower.counts.note(Certificate::Surface, patch.is_some());
        let Some(patch) = patch else { return false };
        let Some(lights) = self.lights_of_sheet(facets, &patch) else { return false };
        let color = color_of(scene, &patch, &lights);
        if self.follower.counts.note(Certificate::Color, self.tolerance.excess(&color) <= 1.0) {
            self.worker.tracer.counters.blocks.filled += 1;
            self.fill_facets(area, facets, None, &color);
            return true;
        }
        self.worker.tracer.counters.blocks.filled += 1;
        for (facet, area) in facets.all.iter().zip(self.areas_of_facets(area, facets)) {
            let Some(area) = area else { continue };
            let patch = fitted(scene, camera, area, facets, std::slice::from_ref(facet));
            let Some(color) = patch.map(|patch| color_of(scene, &patch, &lights)) else { continue };
            if self.follower.counts.note(Certificate::Color, self.tolerance.excess(&color) <= 1.0) {
                self.fill_facets(area, facets, Some(facet), &color);
            }
        }
        true
    }

    /// How a sheet sees all lights.
    fn lights_of_sheet(&mut self, facets: &Facets, patch: &Patch) -> Option<Vec<LightsOfSheet>> {
        let (counts, candidates) = (&mut self.follower.counts, &mut self.follower.candidates);
        let of = |light: &PreparedLight| {
            let known = light_of_sheet(candidates, facets, patch, light, &patch.ways_to(light));
            counts.note(Certificate::Shadow, known.is_some());
            known
        };
        self.follower.scene.lights.iter().map(of).collect()
    }

    /// For each triangle the smallest area around its pending samples.
    fn areas_of_facets(&self, area: Area, facets: &Facets) -> Vec<Option<Area>> {
        let mut areas: Vec<Option<Area>> = vec![None; facets.all.len()];
        let mut at = 0;
        self.for_each_pending(area, |x, y, primitive| {
            if facets.all[at].id != primitive {
                at = facets.position(primitive).unwrap_or(at);
            }
            let here = Area { x0: x, y0: y, x1: x + 1, y1: y + 1 };
            areas[at] = Some(areas[at].map_or(here, |area| area.joined(&here)));
        });
        areas
    }

    /// Fills the samples of a sheet, or those that show one of its triangles, but for those that lie so near an edge that
    /// rounding may decide what they meet.
    fn fill_facets(&mut self, area: Area, facets: &Facets, only: Option<&Facet>, color: &Rgb<Taylor>) {
        self.lap(|seconds| &mut seconds.select);
        let (simd, pattern) = (self.worker.simd, &self.worker.camera.pattern);
        let fill = LinearFill::new(simd, area, pattern, color, self.follower.scene.darkest);
        let (camera, tile) = (self.worker.camera, self.tile);
        let mut facet = only.unwrap_or(&facets.all[0]);
        let mut filled = Vec::with_capacity(area.sample_count() as usize);
        self.for_each_pending(area, |x, y, primitive| {
            if facet.id != primitive {
                match facets.position(primitive) {
                    Some(at) if only.is_none() => facet = &facets.all[at],
                    _ => return,
                }
            }
            if facet.is_met_inside(&camera.sample_ray([x, y]), facets.clearance) {
                filled.push([x - tile.x, y - tile.y]);
            }
        });
        for [x, y] in filled {
            if self.worker.wants_histories {
                self.worker.note_history_of(tile, x, y);
            }
            let index = tile.index(x, y);
            let samples = &mut self.worker.samples;
            samples.color[index] = fill.color(fill.start(tile.y + y), tile.x + x);
            samples.state[index] = SampleState::Filled;
        }
        self.lap(|seconds| &mut seconds.fill);
    }
}

/// The colour of a patch that sees the lights so.
fn color_of(scene: &PreparedScene, patch: &Patch, lights: &[LightsOfSheet]) -> Rgb<Taylor> {
    let body = patch.material.color;
    let seen = scene.lights.iter().zip(lights).filter(|(_, known)| **known == LightsOfSheet::Seen);
    seen.fold(patch.ambient(body), |color, (light, _)| {
        color + patch.reflected(body, light, &patch.ways_to(light))
    })
}

/// What an area shows.
enum Shown {
    /// A piece of one smooth mesh.
    Sheet(Facets),
    /// More than can be looked at together.
    Several,
    /// Nothing that could be filled.
    Other,
}

/// The length of the longest vector of a model.
fn greatest_length(squared: Taylor) -> f64 {
    squared.max(Taylor::constant(0.0)).range()[1].sqrt()
}
