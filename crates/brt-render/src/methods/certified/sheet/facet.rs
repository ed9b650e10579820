//! The triangles of a sheet, as seen.

use brt_geometry::{COORDINATE_ROUNDING, Primitive, Ray, Taylor, Triangle, Vec3};

use super::{LEAST_SINE, greatest_length};
use crate::prepare::PreparedCamera;
use crate::products::{Area, PreparedScene};

/// A triangle, from the side that it is seen from.
pub(super) struct Facet {
    pub(super) id: u32,
    pub(super) triangle: Triangle,
    /// Its unit normal towards the viewer, and how far along it its plane lies.
    pub(super) normal: Vec3,
    pub(super) distance: f64,
    /// Normals of the corners as they shade, of any length.
    pub(super) normals: [Vec3; 3],
    /// Lines in its plane that it does not reach beyond: along the sides opposite to each corner, and through the corners,
    /// across their bisectors. Unit normals away from it, and how far the lines lie along them.
    pub(super) borders: [(Vec3, f64); BORDERS],
    /// How far each corner lies from the side opposite.
    altitudes: [f64; 3],
    /// How much the weights of the corners may be off by rounding.
    weight_error: f64,
}

/// Three sides and three corners.
pub(super) const BORDERS: usize = 6;

/// Triangles of one surface, in the order of their ids.
pub(super) struct Facets {
    pub(super) all: Vec<Facet>,
    /// Points are known to this.
    pub(super) slack: f64,
    /// Points that lie this far inside of a triangle are outside of its neighbours, whatever rounding does.
    pub(super) clearance: f64,
    /// The greatest error of weights.
    pub(super) weight_error: f64,
}

/// Weights of corners that may be off by more mean nothing.
const MOST_WEIGHT_ERROR: f64 = 1e-6;

/// How much clearer of edges points must be than they are known: with [`LEAST_SINE`] a ray has left the slack before it
/// gets across an edge.
const CLEARANCE: f64 = 1e4;

impl Facets {
    /// `None` where rays of the area may run along one of the triangles, or normals are not what they seem.
    pub(super) fn new(
        scene: &PreparedScene,
        camera: &PreparedCamera,
        area: Area,
        ids: &[u32],
    ) -> Option<Self> {
        let [x, y] = area.coordinates();
        let ray = camera.ray(x, y);
        let mut all = Vec::with_capacity(ids.len());
        let (mut reach, mut weight_error) = (size_of(&ray.origin), 0.0_f64);
        for &id in ids {
            let Primitive::Triangle(triangle) = &scene.primitives[id as usize] else { return None };
            let corners = scene.normals[scene.infos[id as usize].normals as usize];
            let facet = Facet::new(id, triangle, corners, &ray)?;
            reach = reach.max(size_of(&ray.origin) + facet.triangle.corners.map(sum).iter().sum::<f64>());
            weight_error = weight_error.max(facet.weight_error);
            all.push(facet);
        }
        let slack = COORDINATE_ROUNDING * reach;
        Some(Self { all, slack, clearance: CLEARANCE * slack, weight_error })
    }

    /// Where the triangle with this id is.
    pub(super) fn position(&self, id: u32) -> Option<usize> {
        self.all.binary_search_by_key(&id, |facet| facet.id).ok()
    }
}

impl Facet {
    fn new(id: u32, triangle: &Triangle, corners: [Vec3; 3], ray: &Ray<Taylor>) -> Option<Self> {
        let outward = triangle.plane.normal;
        let least = greatest_length(ray.dd) * LEAST_SINE;
        let [lo, hi] = ray.direction.along(outward).range();
        let turn = match () {
            () if lo > least => -1.0,
            () if hi < -least => 1.0,
            () => return None,
        };
        // As in `Interaction::at`: normals are on the side that the order of the corners says, then turned.
        let [least, greatest] = extremes(corners.map(|n| n.dot(outward)));
        let agrees = match () {
            () if least > COORDINATE_ROUNDING => 1.0,
            () if greatest < -COORDINATE_ROUNDING => -1.0,
            () => return None,
        };
        let normal = outward * turn;
        let [a, b, c] = triangle.corners;
        let side = |from: Vec3, to: Vec3, opposite: Vec3| {
            let across = (to - from).cross(outward).try_normalize()?;
            let across = if across.dot(opposite - from) > 0.0 { -across } else { across };
            Some(((across, across.dot(from)), across.dot(from - opposite)))
        };
        let [(first, x), (second, y), (third, z)] = [side(b, c, a)?, side(c, a, b)?, side(a, b, c)?];
        let through = |corner: Vec3, one: (Vec3, f64), other: (Vec3, f64)| {
            let across = (one.0 + other.0).try_normalize()?;
            Some((across, across.dot(corner)))
        };
        let corner_lines =
            [through(a, second, third)?, through(b, third, first)?, through(c, first, second)?];
        let altitudes = [x, y, z];
        // Products of up to three coordinates over twice the area as seen.
        let reach = size_of(&ray.origin) + sum(a).max(sum(b)).max(sum(c));
        let longest = (b - a).length().max((c - b).length()).max((a - c).length());
        let area = longest * altitudes.into_iter().fold(f64::INFINITY, f64::min) * LEAST_SINE;
        let weight_error = 64.0 * f64::EPSILON * reach * reach / area;
        let is_exact = weight_error <= MOST_WEIGHT_ERROR;
        is_exact.then(|| Self {
            id,
            triangle: *triangle,
            normal,
            distance: normal.dot(a),
            normals: corners.map(|n| n * (turn * agrees)),
            borders: [first, second, third, corner_lines[0], corner_lines[1], corner_lines[2]],
            altitudes,
            weight_error,
        })
    }

    /// Does a ray meet it this far from all its sides?
    pub(super) fn is_met_inside(&self, ray: &Ray, clearance: f64) -> bool {
        let weights = self.triangle.weights(ray);
        weights
            .iter()
            .zip(self.altitudes)
            .all(|(weight, altitude)| (weight - self.weight_error) * altitude >= clearance)
    }
}

pub(super) fn sum(p: Vec3) -> f64 {
    p.x.abs() + p.y.abs() + p.z.abs()
}

fn size_of(v: &Vec3<Taylor>) -> f64 {
    [v.x, v.y, v.z].map(|x| x.c.abs() + x.u.abs() + x.v.abs() + x.e).iter().sum()
}

pub(super) fn extremes<const N: usize>(numbers: [f64; N]) -> [f64; 2] {
    numbers.into_iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[lo, hi], x| [lo.min(x), hi.max(x)])
}
