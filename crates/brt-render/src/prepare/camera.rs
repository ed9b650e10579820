//! From sample indices to rays.

use brt_geometry::{Ray, Real, Taylor, Vec3};
use brt_scene::{Camera, Projection};

use crate::products::{Area, SampleGrid, SamplePattern};

/// Rays of a picture. A ray's direction has length 1 along the view, so distances along it are depths.
#[derive(Clone, Copy, Debug)]
pub struct PreparedCamera {
    pub(crate) eye: Vec3,
    pub(crate) forward: Vec3,
    pub(crate) right: Vec3,
    pub(crate) up: Vec3,
    pub(crate) is_perspective: bool,
    /// Offset from the whole picture's middle to the grid's first sample, in half samples.
    pub(crate) first: [f64; 2],
    /// Half a sample in units of `right` and `up` at distance 1 (perspective) or in scene units.
    pub(crate) half_sample: f64,
    /// Where samples lie in the grid.
    pub(crate) pattern: SamplePattern,
}

impl PreparedCamera {
    /// The rays of a grid in coordinates that have this point of the scene as their origin
    /// ([`PreparedScene::origin`](crate::PreparedScene::origin)). The camera must have passed the scene's check.
    pub fn new(camera: &Camera, origin: Vec3, grid: &SampleGrid) -> Self {
        let forward = (camera.look_at - camera.eye).try_normalize().unwrap_or_default();
        let right = forward.cross(camera.up.try_normalize().unwrap_or_default()).normalize();
        // All of these are integers below 2⁵³, and so are positions of samples, but for a few binary places: exact.
        let samples = |pixels: u64| (pixels * u64::from(grid.per_side)) as f64;
        let ([wide, high], [left, above]) = (grid.picture.map(samples), grid.first.map(samples));
        let (is_perspective, half_extent) = match camera.projection {
            Projection::Perspective { fov_deg } => (true, libm::tan(0.5 * fov_deg.to_radians())),
            Projection::Orthographic { extent } => (false, 0.5 * extent),
        };
        Self {
            eye: camera.eye - origin,
            forward,
            right,
            up: right.cross(forward),
            is_perspective,
            first: [2.0 * left + (1.0 - wide), 2.0 * above + (1.0 - high)],
            half_sample: half_extent / wide.min(high),
            pattern: grid.pattern(),
        }
    }

    /// The ray through a sample, given its column and row.
    #[inline(always)]
    pub(crate) fn sample_ray(&self, sample: [u32; 2]) -> Ray {
        let [x, y] = self.pattern.position(sample);
        self.ray(x, y)
    }

    /// The rays through all samples of an area.
    pub(crate) fn block(&self, area: &Area) -> Ray<Taylor> {
        // Doubled and shifted without rounding, so that the models do not know from where columns and rows are counted.
        let from_middle =
            |x: Taylor, first: f64| Taylor { c: 2.0 * x.c + first, u: 2.0 * x.u, v: 2.0 * x.v, e: 0.0 };
        let [x, y] = area.coordinates(&self.pattern);
        self.ray_beside_middle(from_middle(x, self.first[0]), from_middle(y, self.first[1]))
    }

    /// The ray through a position of the grid, in columns and rows from the middle of the first sample's place.
    #[inline(always)]
    pub fn ray<R: Real>(&self, x: R, y: R) -> Ray<R> {
        let two = R::constant(2.0);
        let from_middle = |x: R, first: f64| two * x + R::constant(first);
        self.ray_beside_middle(from_middle(x, self.first[0]), from_middle(y, self.first[1]))
    }

    /// The ray through a position in half samples from the whole picture's middle.
    #[inline(always)]
    fn ray_beside_middle<R: Real>(&self, x: R, y: R) -> Ray<R> {
        let (across, down) = (x * R::constant(self.half_sample), y * R::constant(self.half_sample));
        let offset = self.right.lift::<R>() * across - self.up.lift::<R>() * down;
        if self.is_perspective {
            Ray::new(self.eye.lift(), self.forward.lift::<R>() + offset)
        } else {
            Ray::new(self.eye.lift::<R>() + offset, self.forward.lift())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::settings::Samples;
    use brt_geometry::vec3;

    #[test]
    fn corner_pixels_look_through_their_middle() {
        let camera = Camera {
            eye: Vec3::ZERO,
            look_at: vec3(0.0, 0.0, -1.0),
            up: vec3(0.0, 1.0, 0.0),
            projection: Projection::Perspective { fov_deg: 90.0 },
        };
        let rays = PreparedCamera::new(&camera, Vec3::ZERO, &SampleGrid::new([4, 2], Samples::One));
        // tan 45° = 1 over two rows: the middle of the first row is 0.5 up, of the first column 1.5 left.
        let d = rays.ray(0.0, 0.0).direction;
        assert!((d - vec3(-1.5, 0.5, -1.0)).length() < 1e-15);
    }
}
