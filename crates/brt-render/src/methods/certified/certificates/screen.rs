//! Proves that faces together hide a light from all points of a patch, where none of them does alone.
//!
//! From: the faces that the shaft between the light and the patch touches, those that turn the same side to the light. A
//! ray that is turned over the shaft leaves such a face only across an edge. If the edge belongs to two of them, it enters
//! the other, for their outlines run through the edge in opposite directions. So all rays cross as many of them, and one
//! ray decides for all. (No ray slips through an edge or a corner by rounding: `brt-geometry/tests/watertight.rs`.)

use brt_geometry::{Mask, Ray, Real, Shaft, Start, Taylor, Vec3};

use crate::methods::certified::candidates::Candidates;
use crate::products::PreparedLight;
use crate::tracing::{LightWays, Patch};

/// More faces are not looked at together: smaller blocks have fewer.
const MOST_FACES: usize = 256;

/// Sine of the angle to a face below which light counts as along it.
const LEAST_SINE: f64 = 1e-3;

/// Do faces between a patch and a light certainly hide it?
pub(in crate::methods::certified) fn is_screened(
    candidates: &mut Candidates,
    shaft: &Shaft,
    patch: &Patch,
    light: &PreparedLight,
    ways: &LightWays,
) -> bool {
    let scene = candidates.scene;
    let may_be_part = |id: u32| scene.infos[id as usize].casts_shadow;
    if scene.has_dimmers || !candidates.find(shaft, None, MOST_FACES, may_be_part) {
        return false;
    }
    let between = Between::of(shaft, patch, light);
    let middle = middle_way(patch, ways);
    let least = LEAST_SINE * ways.towards.length_squared().max(Taylor::constant(0.0)).range()[1].sqrt();
    [1.0, -1.0].into_iter().any(|turn| {
        let mut edges = Edges { shaft, open: Vec::new() };
        let mut is_met = false;
        for &id in &candidates.found {
            let Some((plane, corners)) = scene.primitives[id as usize].flat() else { continue };
            let rise = ways.towards.along(plane.normal * turn).range()[0];
            if corners.is_empty() || rise <= least {
                continue;
            }
            if !between.holds(corners) {
                return false;
            }
            edges.add(corners);
            let hit = scene.primitives[id as usize].first_hit(&middle, Start::Elsewhere);
            is_met |=
                hit.found.all() && (ways.t_max.is_infinite() || hit.t.lt(Taylor::constant(ways.t_max)).all());
        }
        is_met && edges.are_paired()
    })
}

/// The way to the light from the middle of a patch.
fn middle_way(patch: &Patch, ways: &LightWays) -> Ray<Taylor> {
    let middle = |v: &Vec3<Taylor>| Vec3 { x: v.x.c, y: v.y.c, z: v.z.c }.lift();
    Ray::new(middle(&patch.point), middle(&ways.towards))
}

/// What lies between a patch and a light, measured along a shaft.
struct Between {
    axis: Vec3,
    least: f64,
    greatest: f64,
}

impl Between {
    fn of(shaft: &Shaft, patch: &Patch, light: &PreparedLight) -> Self {
        let axis = shaft.axis();
        let [first, last] = patch.point.along(axis).range();
        let (least, greatest) = match light {
            // Their shafts begin at the light.
            PreparedLight::Point { position, .. } => (position.dot(axis), first),
            PreparedLight::Directional { .. } => (last, f64::INFINITY),
        };
        Self { axis, least: least + shaft.margin(), greatest: greatest - shaft.margin() }
    }

    fn holds(&self, corners: &[Vec3]) -> bool {
        corners.iter().all(|corner| {
            let at = corner.dot(self.axis);
            self.least < at && at < self.greatest
        })
    }
}

/// A point that can be compared.
type Place = [u64; 3];

/// Edges of faces that a shaft touches.
struct Edges<'a> {
    shaft: &'a Shaft,
    /// Ends in their order, and whether the outline runs from the first to the second.
    open: Vec<(Place, Place, bool)>,
}

impl Edges<'_> {
    fn add(&mut self, corners: &[Vec3]) {
        // Zeros of both signs are one place.
        let place = |p: Vec3| [p.x, p.y, p.z].map(|x| (x + 0.0).to_bits());
        let mut from = corners[corners.len() - 1];
        for &to in corners {
            if !self.shaft.misses_edge(from, to) {
                let (a, b) = (place(from), place(to));
                self.open.push(if a < b { (a, b, true) } else { (b, a, false) });
            }
            from = to;
        }
    }

    /// Does each edge belong to as many outlines in one direction as in the other?
    fn are_paired(mut self) -> bool {
        self.open.sort_unstable();
        self.open.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)).all(|outlines| {
            2 * outlines.iter().filter(|(.., is_forward)| *is_forward).count() == outlines.len()
        })
    }
}
