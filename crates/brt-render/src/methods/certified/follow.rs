//! Following a block along its mirror rays.

use brt_geometry::{Real, Taylor};
use brt_image::Rgb;

use super::candidates::Lists;
use super::certificates::{cell_color, first_seen, lighting};
use super::known_history::{KnownHistory, KnownLighting, KnownSight, MOST_LEVELS};
use crate::prepare::PreparedCamera;
use crate::products::{Area, NOTHING, PreparedScene};
use crate::tracing::{FROM_NOWHERE, Patch, constant, start};

/// What became of a block.
pub(super) enum Outcome {
    /// Its history is not proven.
    Open,
    /// Its history is proven; the colour where it could be bounded.
    Proven(Option<Rgb<Taylor>>),
}

/// Follows blocks; keeps their lists.
pub(super) struct Follower<'a> {
    pub(super) scene: &'a PreparedScene,
    pub(super) lists: Lists,
    camera: &'a PreparedCamera,
    max_depth: u32,
    /// Working memory.
    found: Vec<u32>,
}

/// The colours of a block's levels without what mirrors add.
struct Locals {
    colors: [Option<(Rgb<Taylor>, f64)>; MOST_LEVELS],
    is_bounded: bool,
}

impl<'a> Follower<'a> {
    pub(super) fn new(scene: &'a PreparedScene, camera: &'a PreparedCamera, max_depth: u32) -> Self {
        Self { scene, lists: Lists::default(), camera, max_depth, found: Vec::new() }
    }

    /// Proves what can be proven of a block, given what is known already.
    pub(super) fn follow(&mut self, area: Area, history: &mut KnownHistory) -> Outcome {
        let [x, y] = area.coordinates();
        let mut ray = self.camera.ray(x, y);
        let mut from = FROM_NOWHERE;
        let mut locals = Locals { colors: [None; MOST_LEVELS], is_bounded: true };
        let mut is_proven = true;
        for depth in 0..MOST_LEVELS {
            let level = &mut history.levels[depth];
            level.sight = match level.sight {
                KnownSight::Met(primitive) => KnownSight::Met(primitive),
                known => first_seen(self.scene, &mut self.lists, &mut self.found, &ray, from, known),
            };
            let KnownSight::Met(primitive) = level.sight else { return Outcome::Open };
            if primitive == NOTHING {
                return locals.ended(depth, constant(self.scene.background), is_proven);
            }
            let hit = self.scene.primitives[primitive as usize].first_hit(&ray, start(primitive, from));
            let Some(patch) = Patch::at(self.scene, &ray, primitive, hit.t) else { return Outcome::Open };
            let body = cell_color(patch.material, &patch.point);
            locals.is_bounded &= body.is_some();
            let body = body.unwrap_or(patch.material.color);
            let mut color = patch.ambient(body);
            for (index, light) in self.scene.lights.iter().enumerate() {
                let Some(known) = level.lights.get_mut(index) else {
                    is_proven = false;
                    break;
                };
                let ways = patch.ways_to(light);
                *known = lighting(self.scene, &mut self.lists, &mut self.found, &patch, light, &ways, *known);
                match known {
                    KnownLighting::Hidden => {}
                    // The colour is only asked for where everything is proven.
                    KnownLighting::Seen if is_proven && locals.is_bounded => {
                        color = color + patch.reflected(body, &ways);
                    }
                    KnownLighting::Seen => {}
                    _ => is_proven = false,
                }
            }
            if patch.material.transmission > 0.0 {
                return Outcome::Open;
            }
            if patch.material.reflection == 0.0 || depth as u32 >= self.max_depth {
                return locals.ended(depth, color, is_proven);
            }
            locals.colors[depth] = Some((color, patch.material.reflection));
            ray = patch.mirror_ray(&ray);
            from = primitive;
        }
        Outcome::Open
    }
}

impl Locals {
    /// The colour of the whole, given that of the last level.
    fn ended(&self, depth: usize, last: Rgb<Taylor>, is_proven: bool) -> Outcome {
        if !is_proven {
            return Outcome::Open;
        }
        if !self.is_bounded {
            return Outcome::Proven(None);
        }
        let above = self.colors[..depth].iter().flatten();
        let fold = |seen: Rgb<Taylor>, (local, reflection): &(Rgb<Taylor>, f64)| {
            *local + seen * Taylor::constant(*reflection)
        };
        Outcome::Proven(Some(above.rev().fold(last, fold)))
    }
}
