//! Proves that all points of a sheet see a light, or that none does.
//!
//! From: the shaft between the light and the sheet, as for any patch ([`super::super::certificates`]), without what lies
//! below the sheet. A triangle B that it touches, the sheet's own ones among them, hides no point of a triangle A if
//! B lies below the plane of A; or if it lies beyond a border of A, and light rises faster than B does on its way there. As
//! neighbours begin at that border, the point must be clear of it. (`q = p + s·L`, of height `s·rise` over A, is
//! `s·nearer` less the point's clearance beyond the border: too near for its height.)

use brt_geometry::{COORDINATE_ROUNDING, Mask, Primitive, Ray, RayBlock, Shaft, Start, Vec3};

use super::facet::{BORDERS, Border, Facet, Facets, extremes, sum};
use super::greatest_length;
use crate::margins::LEAST_RISE;
use crate::methods::certified::candidates::Candidates;
use crate::methods::certified::certificates::{before_light, hides_together, is_beside, shaft_of};
use crate::products::PreparedLight;
use crate::tracing::{LightWays, Patch};

/// More primitives than these are not looked at: smaller blocks have fewer.
const MOST_IN_THE_WAY: usize = 96;

/// How light climbs that comes no nearer: higher than anything. Finite, so that products with 0 are 0.
const AWAY: f64 = 1e300;

/// How all points of a sheet see a light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum LightsOfSheet {
    Seen,
    Hidden,
}

/// `None` where neither is proven.
pub(super) fn light_of_sheet(
    candidates: &mut Candidates,
    facets: &Facets,
    patch: &Patch,
    light: &PreparedLight,
    ways: &LightWays,
) -> Option<LightsOfSheet> {
    if !patch.faces(ways)? || all_turn_away(facets, ways) {
        return Some(LightsOfSheet::Hidden);
    }
    let shaft = shaft_of(candidates, patch, light, ways)?;
    if is_open(candidates, facets, patch, light, ways, shaft) {
        return Some(LightsOfSheet::Seen);
    }
    hides_together(candidates, &shaft, patch, light, ways).then_some(LightsOfSheet::Hidden)
}

/// Does certainly nothing hide the light?
fn is_open(
    candidates: &mut Candidates,
    facets: &Facets,
    patch: &Patch,
    light: &PreparedLight,
    ways: &LightWays,
    shaft: Shaft,
) -> bool {
    let climbs: Option<Vec<_>> = facets.all.iter().map(|facet| Climb::of(facet, ways)).collect();
    // Only shafts in a tree have room for how hits are rounded.
    let shaft = (shaft.margin() > 0.0).then_some(shaft);
    let shaft = shaft.and_then(|shaft| shaft.above_points(facets.all[0].normal, &patch.point));
    let (Some(climbs), Some(shaft)) = (climbs, shaft) else { return false };
    let scene = candidates.scene;
    let may_hide = |id: u32| {
        scene.infos[id as usize].casts_shadow
            && !is_beside(&scene.primitives[id as usize], &patch.point, light)
    };
    if !candidates.find(&shaft, None, MOST_IN_THE_WAY, may_hide) {
        return false;
    }
    let ray = Ray::new(patch.point, ways.towards);
    let block = match light {
        PreparedLight::Point { position, .. } => RayBlock::to_point(ray, *position),
        PreparedLight::Directional { .. } => RayBlock::new(ray),
    };
    let is_clear = |&id: &u32| {
        let primitive = &scene.primitives[id as usize];
        let blocker = Blocker::of(id, primitive, facets, ways);
        if blocker.is_some_and(|blocker| blocker.is_clear_of_all(facets, &climbs)) {
            return true;
        }
        let may_be_met = || {
            // Not all points lie on one triangle, so it is none that all rays start on.
            let hit = block.first_hit(primitive, Start::Elsewhere);
            before_light(&hit, ways).any()
        };
        facets.position(id).is_none() && !may_be_met()
    };
    candidates.found.iter().all(is_clear)
}

/// Do all triangles turn away from the light?
fn all_turn_away(facets: &Facets, ways: &LightWays) -> bool {
    facets.all.iter().all(|facet| ways.towards.along(facet.normal).range()[1] < 0.0)
}

/// How light climbs from a triangle: per border, the least height that it gains while it comes one unit nearer to what is
/// beyond that border.
struct Climb([f64; BORDERS]);

impl Climb {
    /// `None` where light may run along the triangle.
    fn of(facet: &Facet, ways: &LightWays) -> Option<Self> {
        let [rise, _] = ways.towards.along(facet.normal).range();
        if rise <= least_rise(ways) {
            return None;
        }
        let over = |border: Border| {
            let [_, nearer] = ways.towards.along(border.across).range();
            if nearer > 0.0 { rise / nearer } else { AWAY }
        };
        Some(Self(facet.borders.map(over)))
    }
}

fn least_rise(ways: &LightWays) -> f64 {
    LEAST_RISE * greatest_length(ways.towards.length_squared())
}

/// A triangle in the way to a light.
struct Blocker {
    id: u32,
    corners: [Vec3; 3],
}

impl Blocker {
    /// `None` where light may run along it, or it is known less well than the sheet.
    fn of(id: u32, primitive: &Primitive, facets: &Facets, ways: &LightWays) -> Option<Self> {
        let Primitive::Triangle(triangle) = primitive else { return None };
        let corners = triangle.corners;
        let [lo, hi] = ways.towards.along(triangle.plane.normal).range();
        let is_steep = lo.max(-hi) > least_rise(ways);
        // A sliver's normal is little but rounding; parts of a polygon are off the plane that they share.
        let off = |q: &Vec3| (triangle.plane.normal.dot(*q) - triangle.plane.distance).abs();
        let is_known = COORDINATE_ROUNDING * corners.map(sum).iter().sum::<f64>() <= 4.0 * facets.slack
            && corners.iter().all(|q| off(q) <= facets.slack)
            && (0..3).all(|i| (corners[i] - corners[(i + 1) % 3]).length() > facets.clearance);
        (is_steep && is_known).then_some(Self { id, corners })
    }

    fn is_clear_of_all(&self, facets: &Facets, climbs: &[Climb]) -> bool {
        let slack = 4.0 * facets.slack;
        // A flat triangle does not hide itself.
        facets
            .all
            .iter()
            .zip(climbs)
            .all(|(facet, climb)| facet.id == self.id || self.is_clear_of(facet, climb, slack))
    }

    /// Does it hide no point of a triangle that is clear of its borders?
    fn is_clear_of(&self, facet: &Facet, climb: &Climb, slack: f64) -> bool {
        let heights = self.corners.map(|q| facet.normal.dot(q) - facet.distance);
        let [_, highest] = extremes(heights);
        if highest < -slack {
            return true;
        }
        facet.borders.iter().zip(climb.0).any(|(border, climb)| {
            self.corners.iter().zip(heights).all(|(corner, height)| {
                let beyond = border.beyond(*corner);
                beyond >= -slack && height <= climb * beyond.max(0.0) + slack
            })
        })
    }
}
