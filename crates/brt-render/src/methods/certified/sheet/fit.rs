//! One plane and one linear normal for all triangles of a sheet, and how far they are off.

use brt_geometry::{COORDINATE_ROUNDING, Real, Taylor, Vec3, vec3};

use super::facet::{Facet, Facets};
use crate::prepare::PreparedCamera;
use crate::products::{Area, PreparedScene};
use crate::tracing::Patch;

/// What is fitted at each corner: the normal's coordinates, and the height over the tangent plane.
const FITTED: usize = 4;
const HEIGHT: usize = 3;

/// A linear function of a place on the tangent plane: at its middle, and per unit along both tangents.
type Line = [f64; 3];

/// Points and normals of some triangles of a sheet, where the rays of an area meet them.
pub(super) fn fitted<'a>(
    scene: &'a PreparedScene,
    camera: &PreparedCamera,
    area: Area,
    facets: &Facets,
    some: &[Facet],
) -> Option<Patch<'a>> {
    let plane = TangentPlane::of(some)?;
    let lines = plane.lines(some);
    let deviations = plane.deviations(some, &lines, facets.weight_error);
    let ray = camera.block(&area);

    // Where the rays meet the fitted plane, give or take how far corners are off.
    let [height, slope, other_slope] = lines[HEIGHT];
    let up = plane.normal - plane.first * slope - plane.second * other_slope;
    let from_center = ray.origin - plane.center.lift();
    let off = deviations[HEIGHT] + 2.0 * facets.slack;
    let ahead = Taylor { e: off, ..Taylor::constant(height) } - from_center.along(up);
    let t = ahead / ray.direction.along(up);

    let place = |tangent: Vec3| from_center.along(tangent) + t * ray.direction.along(tangent);
    let (a, b) = (place(plane.first), place(plane.second));
    let coordinate = |i: usize| {
        let [middle, along, other] = lines[i];
        let line = Taylor::constant(middle) + a * Taylor::constant(along) + b * Taylor::constant(other);
        Taylor { e: line.e + deviations[i], ..line }
    };
    let normal = vec3(coordinate(0), coordinate(1), coordinate(2));
    Patch::with_normal(scene, &ray, some[0].id, t, normal.normalize())
}

/// A plane near all corners.
struct TangentPlane {
    center: Vec3,
    normal: Vec3,
    first: Vec3,
    second: Vec3,
}

impl TangentPlane {
    fn of(facets: &[Facet]) -> Option<Self> {
        let share = 1.0 / (3 * facets.len()) as f64;
        let corners = facets.iter().flat_map(|facet| facet.triangle.corners);
        let center = corners.fold(Vec3::ZERO, |sum, p| sum + p * share);
        let normal = facets.iter().fold(Vec3::ZERO, |sum, facet| sum + facet.normal).try_normalize()?;
        let (first, second) = normal.tangents();
        Some(Self { center, normal, first, second })
    }

    /// Calls with every corner's place, and its values.
    fn for_each_corner(&self, facets: &[Facet], mut act: impl FnMut([f64; 2], [f64; FITTED])) {
        for facet in facets {
            for (corner, n) in facet.triangle.corners.iter().zip(facet.normals) {
                let p = *corner - self.center;
                act([p.dot(self.first), p.dot(self.second)], [n.x, n.y, n.z, p.dot(self.normal)]);
            }
        }
    }

    /// The lines nearest to the values of all corners (least squares). Any would do: how far they are off is found next.
    fn lines(&self, facets: &[Facet]) -> [Line; FITTED] {
        // The middle of all places is the origin: sums of first powers vanish.
        let (mut aa, mut ab, mut bb) = (0.0, 0.0, 0.0);
        let (mut sums, mut with_a, mut with_b) = ([0.0; FITTED], [0.0; FITTED], [0.0; FITTED]);
        self.for_each_corner(facets, |[a, b], values| {
            (aa, ab, bb) = (aa + a * a, ab + a * b, bb + b * b);
            for i in 0..FITTED {
                sums[i] += values[i];
                with_a[i] += a * values[i];
                with_b[i] += b * values[i];
            }
        });
        let inverse = 1.0 / (aa * bb - ab * ab);
        let inverse = if inverse.is_finite() { inverse } else { 0.0 };
        let share = 1.0 / (3 * facets.len()) as f64;
        std::array::from_fn(|i| {
            let (a, b) = (with_a[i], with_b[i]);
            [sums[i] * share, (a * bb - b * ab) * inverse, (b * aa - a * ab) * inverse]
        })
    }

    /// How far values between the corners may be off the lines: no more than those at the corners, and what rounding adds.
    fn deviations(&self, facets: &[Facet], lines: &[Line; FITTED], weight_error: f64) -> [f64; FITTED] {
        let mut greatest = [0.0_f64; FITTED];
        let mut size = 1.0_f64;
        self.for_each_corner(facets, |[a, b], values| {
            for i in 0..FITTED {
                let [middle, along, other] = lines[i];
                greatest[i] = greatest[i].max((values[i] - (middle + along * a + other * b)).abs());
                size = size.max(values[i].abs() + (along * a).abs() + (other * b).abs());
            }
        });
        // Weights are off by rounding; three of them, and corners' values as large as this.
        let rounding = (COORDINATE_ROUNDING + 6.0 * weight_error) * size;
        greatest.map(|x| x + rounding)
    }
}
