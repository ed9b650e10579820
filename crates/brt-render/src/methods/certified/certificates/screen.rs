//! Proves that faces together hide a light from all points of a patch, where none of them does alone.
//!
//! From: flat faces between the light and the patch that turn the same side to the light. How often their outlines wind
//! around a way to the light, seen along it, is how many of them it crosses. That changes only where the way, moved over
//! the shaft, gets across an edge; but an edge of two of them counts for one as much as against the other, since their
//! outlines run along it in opposite directions. If all edges in the shaft are such, every way crosses as many faces as
//! one does. Rounding changes nothing in that: a ray sees each corner at one place, whichever face it belongs to, and
//! meets whatever it lies inside of as seen so (`brt-geometry/src/primitives/polygon.rs`).

use brt_geometry::{Mask, Plane, Primitive, Ray, RayBlock, Shaft, Start, Taylor, Vec3};

use super::before_light;
use crate::margins::LEAST_RISE;
use crate::methods::certified::candidates::Candidates;
use crate::products::{PreparedLight, PreparedScene};
use crate::tracing::{LightWays, Patch};

/// More faces are not looked at together: smaller blocks have fewer.
const MOST_FACES: usize = 128;

/// Do some of the faces that a shaft touches certainly hide the light from the whole patch? Some of them were found last.
pub(in crate::methods::certified) fn hides_together(
    candidates: &mut Candidates,
    shaft: &Shaft,
    patch: &Patch,
    light: &PreparedLight,
    ways: &LightWays,
) -> bool {
    let scene = candidates.scene;
    // Polygons of their own have their shadows' ends nearly everywhere: looking at them costs more than it brings.
    let is_of_mesh = |id: u32| matches!(scene.primitives[id as usize], Primitive::Triangle(_));
    if !candidates.found.iter().all(|&id| is_of_mesh(id)) {
        return false;
    }
    let may_be_part = |id: u32| is_of_mesh(id) && scene.infos[id as usize].casts_shadow;
    candidates.find(shaft, None, MOST_FACES, may_be_part)
        && is_screened(scene, &candidates.found, shaft, patch, light, ways)
}

/// Do some of these faces certainly hide the light from the whole patch?
pub(super) fn is_screened(
    scene: &PreparedScene,
    ids: &[u32],
    shaft: &Shaft,
    patch: &Patch,
    light: &PreparedLight,
    ways: &LightWays,
) -> bool {
    // Only shafts in a tree have room for how rays are rounded; and what dims the light is a matter of its own.
    if scene.has_dimmers || shaft.margin() <= 0.0 {
        return false;
    }
    let between = Between::of(shaft, patch, light);
    let middle = middle_way(patch, ways);
    [1.0, -1.0].into_iter().any(|turn| {
        let mut edges = Edges { shaft, found: Vec::new() };
        let mut is_met = false;
        for &id in ids {
            let primitive = &scene.primitives[id as usize];
            // What starts on a flat primitive does not meet it.
            let Some((plane, corners)) = primitive.flat().filter(|_| scene.carrier(id) != patch.carrier)
            else {
                continue;
            };
            if between.holds_face(plane, corners, turn, ways) {
                edges.add(corners);
                is_met |= before_light(&middle.first_hit(primitive, Start::Elsewhere), ways).all();
            }
        }
        is_met && edges.are_paired()
    })
}

/// The way to the light from the middle of a patch.
fn middle_way(patch: &Patch, ways: &LightWays) -> RayBlock {
    let middle = |v: &Vec3<Taylor>| Vec3 { x: v.x.c, y: v.y.c, z: v.z.c }.lift();
    RayBlock::new(Ray::new(middle(&patch.point), middle(&ways.towards)))
}

/// What lies between a patch and a light, measured along a shaft.
struct Between {
    axis: Vec3,
    least: f64,
    greatest: f64,
    margin: f64,
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
        Self { axis, least, greatest, margin: shaft.margin() }
    }

    /// Does all light that crosses a face come from this side of it, between the patch and the light; and is its outline
    /// so clearly convex that it stays so however its corners are rounded?
    fn holds_face(&self, plane: &Plane, corners: &[Vec3], turn: f64, ways: &LightWays) -> bool {
        let least_rise = LEAST_RISE * ways.towards.length_squared().range()[1].max(0.0).sqrt();
        let rises_above = |normal: Vec3, least: f64| ways.towards.along(normal * turn).range()[0] > least;
        if corners.is_empty() || !rises_above(plane.normal, least_rise) {
            return false;
        }
        let off_plane = |corner: &Vec3| (plane.normal.dot(*corner) - plane.distance).abs();
        let off = corners.iter().map(off_plane).fold(0.0, f64::max) / LEAST_RISE + self.margin;
        let is_inside = |corner: &Vec3| {
            let at = corner.dot(self.axis);
            self.least + off < at && at < self.greatest - off
        };
        // As seen along the light every corner stands out from the line between its neighbours, to the same side.
        let count = corners.len();
        let stands_out = |i: usize| {
            let (before, after) = (corners[(i + count - 1) % count], corners[(i + 1) % count]);
            let area = (corners[i] - before).cross(after - corners[i]);
            rises_above(area, least_rise * self.margin * (after - before).length())
        };
        corners.iter().all(is_inside) && (0..count).all(stands_out)
    }
}

/// A corner that can be compared.
type Corner = [u64; 3];

/// Edges of faces that a shaft touches.
struct Edges<'a> {
    shaft: &'a Shaft,
    /// Ends in their order, and whether the outline runs from the first to the second.
    found: Vec<(Corner, Corner, bool)>,
}

impl Edges<'_> {
    fn add(&mut self, corners: &[Vec3]) {
        // Zeros of both signs are one place.
        let place = |p: Vec3| [p.x, p.y, p.z].map(|x| (x + 0.0).to_bits());
        let mut from = corners[corners.len() - 1];
        for &to in corners {
            if !self.shaft.misses_edge(from, to) {
                let (a, b) = (place(from), place(to));
                self.found.push(if a < b { (a, b, true) } else { (b, a, false) });
            }
            from = to;
        }
    }

    /// Does each edge belong to as many outlines in one direction as in the other?
    fn are_paired(mut self) -> bool {
        self.found.sort_unstable();
        self.found.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)).all(|outlines| {
            2 * outlines.iter().filter(|(.., is_forward)| *is_forward).count() == outlines.len()
        })
    }
}
