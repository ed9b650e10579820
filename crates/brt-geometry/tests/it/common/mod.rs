//! What tests of hits share.

use brt_geometry::{Cone, Cylinder, Disc, Plane, Polygon, Primitive, Sphere, Triangle};
use brt_testkit::Random;

/// Any primitive near the origin.
pub(crate) fn random_primitive(random: &mut Random, kind: u32) -> Primitive {
    let (base, axis) = (random.point(2.0), random.direction());
    let height = random.between(0.2, 2.5);
    match kind {
        0 => Primitive::Sphere(Sphere { center: base, radius: random.magnitude(-2.0, 0.4) }),
        1 => Primitive::Plane(Plane::through(base, axis)),
        2 => loop {
            let corners = [random.point(3.0), random.point(3.0), random.point(3.0)];
            if let Some(triangle) = Triangle::new(corners) {
                break Primitive::Triangle(triangle);
            }
        },
        3 => {
            let (u, v) = axis.tangents();
            let count = 3 + random.below(6);
            let corner = |i: u32| {
                let angle = std::f64::consts::TAU * f64::from(i) / f64::from(count);
                base + (u * libm::cos(angle) + v * libm::sin(angle)) * height
            };
            let corners = (0..count).map(corner).collect();
            Primitive::Polygon(Polygon { plane: Plane::through(base, axis), corners })
        }
        4 => Primitive::Disc(Disc::new(base, axis, height)),
        5 => Primitive::Cylinder(Cylinder {
            base,
            axis,
            low: 0.0,
            high: height,
            radius: random.magnitude(-1.5, 0.3),
        }),
        _ => {
            let (base_radius, top_radius) = (random.between(0.0, 1.5), random.between(0.0, 1.5));
            let top_radius = if random.one_in(3) { 0.0 } else { top_radius };
            Primitive::Cone(Cone {
                base,
                axis,
                low: 0.0,
                high: height,
                base_radius,
                slope: (top_radius - base_radius) / height,
            })
        }
    }
}

/// Kinds of primitive.
pub(crate) const KINDS: u32 = 7;
