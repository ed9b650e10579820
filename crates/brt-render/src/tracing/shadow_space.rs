//! The space between lights and a patch: where nothing that casts shadows reaches into it, no shadow ray is needed.

use brt_geometry::{BOX_MARGIN, Primitive, SMALLEST_ANGLE, Vec3};

use crate::products::{PreparedLight, PreparedScene};

/// Bounding spheres of everything that casts shadows.
pub(crate) struct ShadowSpace {
    spheres: Vec<Sphere>,
    unbounded: Vec<u32>,
    /// Width that a directional light's space has to reach through the whole scene.
    reach: f64,
}

struct Sphere {
    primitive: u32,
    center: Vec3,
    radius: f64,
}

impl ShadowSpace {
    pub(crate) fn new(scene: &PreparedScene) -> Self {
        let (mut spheres, mut unbounded) = (Vec::new(), Vec::new());
        for (id, primitive) in (0_u32..).zip(&scene.primitives) {
            if !scene.infos[id as usize].casts_shadow {
                continue;
            }
            match primitive.bounds() {
                Some(b) => {
                    let (center, half) = ((b.lo + b.hi) * 0.5, (b.hi - b.lo) * 0.5);
                    spheres.push(Sphere { primitive: id, center, radius: half.length() });
                }
                None => unbounded.push(id),
            }
        }
        let far = |s: &Sphere| s.center.length() + s.radius;
        let reach = 4.0 * spheres.iter().map(far).fold(1.0, f64::max);
        Self { spheres, unbounded, reach }
    }

    /// Bits of those among the first 64 lights that nothing can hide from any of these points of a primitive, each with
    /// its geometric normal on the viewer's side.
    pub(crate) fn lights_surely_seen(&self, scene: &PreparedScene, on: u32, points: &[(Vec3, Vec3)]) -> u64 {
        let lo = points.iter().map(|p| p.0).fold(Vec3::splat(f64::INFINITY), Vec3::min);
        let hi = points.iter().map(|p| p.0).fold(Vec3::splat(f64::NEG_INFINITY), Vec3::max);
        let (middle, radius) = ((lo + hi) * 0.5, 0.5 * (hi - lo).length());
        let mut seen = 0;
        for (bit, light) in scene.lights.iter().enumerate().take(64) {
            let end = match light {
                PreparedLight::Point { position, .. } => *position,
                PreparedLight::Directional { towards, .. } => {
                    middle + *towards * (self.reach + 2.0 * middle.length())
                }
            };
            let own = hides_nothing_itself(&scene.primitives[on as usize], points, end);
            let space = Capsule { from: middle, to: end, radius };
            let is_beside = |id: u32| (own && id == on) || space.is_beside(&scene.primitives[id as usize]);
            let is_free = |s: &Sphere| !space.meets(s) || is_beside(s.primitive);
            if self.unbounded.iter().all(|&id| is_beside(id)) && self.spheres.iter().all(is_free) {
                seen |= 1 << bit;
            }
        }
        seen
    }
}

/// Is it certain that no ray from these points to the light meets the primitive again?
fn hides_nothing_itself(primitive: &Primitive, points: &[(Vec3, Vec3)], light: Vec3) -> bool {
    match primitive {
        Primitive::Plane(_) | Primitive::Triangle(_) | Primitive::Polygon(_) | Primitive::Disc(_) => true,
        // From outside a ball, towards a light above its horizon.
        Primitive::Sphere(sphere) => points.iter().all(|(point, normal)| {
            let towards = light - *point;
            let outward = (*point - sphere.center).dot(*normal) > 0.0;
            outward && normal.dot(towards) > SMALLEST_ANGLE * towards.length()
        }),
        Primitive::Cylinder(_) | Primitive::Cone(_) => false,
    }
}

/// All points nearer than `radius` to a segment.
struct Capsule {
    from: Vec3,
    to: Vec3,
    radius: f64,
}

impl Capsule {
    fn meets(&self, sphere: &Sphere) -> bool {
        let (axis, offset) = (self.to - self.from, sphere.center - self.from);
        let along = (offset.dot(axis) / axis.length_squared()).clamp(0.0, 1.0);
        let distance = (offset - axis * along).length();
        let margin = BOX_MARGIN * (offset.length() + axis.length() + sphere.radius);
        distance <= self.radius + sphere.radius + margin
    }

    /// Does it lie on one side of a flat primitive's plane?
    fn is_beside(&self, primitive: &Primitive) -> bool {
        let plane = match primitive {
            Primitive::Plane(plane) => plane,
            Primitive::Triangle(triangle) => &triangle.plane,
            Primitive::Polygon(polygon) => &polygon.plane,
            Primitive::Disc(disc) => &disc.plane,
            Primitive::Sphere(_) | Primitive::Cylinder(_) | Primitive::Cone(_) => return false,
        };
        let height = |p: Vec3| plane.normal.dot(p) - plane.distance;
        let (a, b) = (height(self.from), height(self.to));
        let margin =
            self.radius + BOX_MARGIN * (self.from.length() + self.to.length() + plane.distance.abs());
        a.abs() > margin && b.abs() > margin && (a > 0.0) == (b > 0.0)
    }
}
