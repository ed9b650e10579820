//! Bounding spheres of primitives: a quick look at what a bundle of rays may meet.

use brt_geometry::{Aabb, BOX_MARGIN, Vec3};

use crate::products::PreparedScene;

/// Primitives, each with a sphere around it; those without a box apart.
pub(crate) struct BoundingSpheres {
    pub(super) spheres: Vec<BoundingSphere>,
    pub(super) unbounded: Vec<u32>,
}

/// A sphere around a primitive.
pub(super) struct BoundingSphere {
    pub(super) primitive: u32,
    pub(super) center: Vec3,
    pub(super) radius: f64,
}

impl BoundingSpheres {
    pub(crate) fn new(scene: &PreparedScene) -> Self {
        let (mut spheres, mut unbounded) = (Vec::new(), Vec::new());
        for (primitive, shape) in (0_u32..).zip(&scene.primitives) {
            match shape.bounds() {
                Some(Aabb { lo, hi }) => {
                    let (center, radius) = ((lo + hi) * 0.5, 0.5 * (hi - lo).length());
                    spheres.push(BoundingSphere { primitive, center, radius });
                }
                None => unbounded.push(primitive),
            }
        }
        Self { spheres, unbounded }
    }

    /// Distance from the origin of space that everything bounded stays within.
    pub(super) fn reach(&self) -> f64 {
        self.spheres.iter().map(|s| s.center.length() + s.radius).fold(1.0, f64::max)
    }

    /// Primitives that rays of a bundle may meet: all without a box, and those whose spheres the bundle touches.
    pub(super) fn touched_by<'a>(&'a self, bundle: &'a Bundle) -> impl Iterator<Item = u32> + 'a {
        let touched = self.spheres.iter().filter(|s| bundle.touches(s)).map(|s| s.primitive);
        self.unbounded.iter().copied().chain(touched)
    }
}

/// All rays that start within `spread` of a point and whose directions are within `turn` of an axis.
pub(super) struct Bundle {
    pub(super) origin: Vec3,
    pub(super) axis: Vec3,
    /// Greatest distance of an origin from `origin`.
    pub(super) spread: f64,
    /// Greatest length of the difference of a direction from `axis`.
    pub(super) turn: f64,
    /// Rays end at this distance in units of the direction.
    pub(super) end: f64,
}

impl Bundle {
    fn touches(&self, sphere: &BoundingSphere) -> bool {
        let to_center = sphere.center - self.origin;
        let length = self.axis.length();
        let along = (to_center.dot(self.axis) / (length * length)).clamp(0.0, self.end);
        let distance = (to_center - self.axis * along).length();
        // A ray's point at distance s is within spread + s·turn of the axis's. If it is in the sphere, s is at most
        // (|center| + radius + spread) / (|axis| − turn), where turn is less than half the axis.
        let farthest = 2.0 * (to_center.length() + sphere.radius + self.spread) / length;
        let margin = BOX_MARGIN * (to_center.length() + sphere.radius + self.spread);
        let slack = self.spread + farthest.min(self.end) * self.turn + margin;
        self.turn >= 0.5 * length || distance <= sphere.radius + slack
    }
}
