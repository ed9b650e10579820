//! The triangles of a sheet, as seen.

use brt_geometry::{COORDINATE_ROUNDING, Primitive, Ray, Taylor, Triangle, Vec3};

use super::greatest_length;
use crate::margins::{LEAST_RISE, MOST_WEIGHT_ERROR, SHEET_CLEARANCE, WEIGHT_ROUNDINGS};
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
    /// Along the sides opposite to each corner, and through the corners, across their bisectors.
    pub(super) borders: [Border; BORDERS],
    /// How far each corner lies from the side opposite.
    altitudes: [f64; 3],
    /// How much the weights of the corners may be off by rounding.
    weight_error: f64,
}

/// A line in a triangle's plane that the triangle does not reach beyond.
#[derive(Clone, Copy)]
pub(super) struct Border {
    /// Unit normal away from the triangle.
    pub(super) across: Vec3,
    /// How far the line lies along it.
    distance: f64,
}

impl Border {
    fn through(point: Vec3, across: Vec3) -> Self {
        Self { across, distance: across.dot(point) }
    }

    /// How far a point is beyond.
    pub(super) fn beyond(&self, point: Vec3) -> f64 {
        self.across.dot(point) - self.distance
    }
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

impl Facets {
    /// `None` where rays of the area may run along one of the triangles, or normals are not what they seem.
    pub(super) fn new(
        scene: &PreparedScene,
        camera: &PreparedCamera,
        area: Area,
        ids: &[u32],
    ) -> Option<Self> {
        let ray = camera.block(&area);
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
        Some(Self { all, slack, clearance: SHEET_CLEARANCE * slack, weight_error })
    }

    /// Where the triangle with this id is.
    pub(super) fn position(&self, id: u32) -> Option<usize> {
        self.all.binary_search_by_key(&id, |facet| facet.id).ok()
    }
}

impl Facet {
    fn new(id: u32, triangle: &Triangle, corners: [Vec3; 3], ray: &Ray<Taylor>) -> Option<Self> {
        let outward = triangle.plane.normal;
        let turn = -sign(ray.direction.along(outward).range(), greatest_length(ray.dd) * LEAST_RISE)?;
        // As in `Interaction::at`: normals are on the side that the order of the corners says, then turned.
        let agrees = sign(extremes(corners.map(|n| n.dot(outward))), COORDINATE_ROUNDING)?;
        let (borders, altitudes) = borders(triangle)?;
        let weight_error = weight_error(triangle, altitudes, &ray.origin);
        let normal = outward * turn;
        (weight_error <= MOST_WEIGHT_ERROR).then(|| Self {
            id,
            triangle: *triangle,
            normal,
            distance: normal.dot(triangle.corners[0]),
            normals: corners.map(|n| n * (turn * agrees)),
            borders,
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

/// The one sign that numbers have which are larger than this, if they have one.
fn sign([least, greatest]: [f64; 2], larger_than: f64) -> Option<f64> {
    if least > larger_than {
        return Some(1.0);
    }
    (greatest < -larger_than).then_some(-1.0)
}

/// The borders of a triangle, and how far each corner is from the side opposite.
fn borders(triangle: &Triangle) -> Option<([Border; BORDERS], [f64; 3])> {
    let [a, b, c] = triangle.corners;
    let side = |from: Vec3, to: Vec3, opposite: Vec3| {
        let across = (to - from).cross(triangle.plane.normal).try_normalize()?;
        let across = if across.dot(opposite - from) > 0.0 { -across } else { across };
        Some((Border::through(from, across), across.dot(from - opposite)))
    };
    let [(at_a, from_a), (at_b, from_b), (at_c, from_c)] = [side(b, c, a)?, side(c, a, b)?, side(a, b, c)?];
    let at_corner = |corner: Vec3, one: Border, other: Border| {
        Some(Border::through(corner, (one.across + other.across).try_normalize()?))
    };
    let corners = [at_corner(a, at_b, at_c)?, at_corner(b, at_c, at_a)?, at_corner(c, at_a, at_b)?];
    Some(([at_a, at_b, at_c, corners[0], corners[1], corners[2]], [from_a, from_b, from_c]))
}

/// By how much rounding may change the weights of corners: products of up to three coordinates, over twice the area as
/// seen.
fn weight_error(triangle: &Triangle, altitudes: [f64; 3], origin: &Vec3<Taylor>) -> f64 {
    let [a, b, c] = triangle.corners;
    let reach = size_of(origin) + sum(a).max(sum(b)).max(sum(c));
    let longest = (b - a).length().max((c - b).length()).max((a - c).length());
    let area = longest * altitudes.into_iter().fold(f64::INFINITY, f64::min) * LEAST_RISE;
    WEIGHT_ROUNDINGS * reach * reach / area
}

/// Sum of a point's coordinates, whatever their signs.
pub(super) fn sum(p: Vec3) -> f64 {
    p.x.abs() + p.y.abs() + p.z.abs()
}

fn size_of(v: &Vec3<Taylor>) -> f64 {
    [v.x, v.y, v.z].map(|x| x.c.abs() + x.u.abs() + x.v.abs() + x.e).iter().sum()
}

pub(super) fn extremes<const N: usize>(numbers: [f64; N]) -> [f64; 2] {
    numbers.into_iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[lo, hi], x| [lo.min(x), hi.max(x)])
}
