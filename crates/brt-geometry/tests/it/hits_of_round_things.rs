//! How far beside round primitives hits lie by rounding: far less than the room that boxes and shafts have for them. (Flat ones
//! need the room: `margins.rs`.)

use brt_geometry::{BOX_MARGIN, Cone, Cylinder, Primitive, Ray, Sphere, Start, Triangle, Vec3, vec3};
use brt_testkit::Random;

/// How far a hit of a ray lies from a primitive, as a share of the way from the ray's start to the primitive's end; 0 where it
/// does not hit.
fn beside(primitive: &Primitive, ray: &Ray, off: impl Fn(Vec3) -> f64) -> f64 {
    let hit = primitive.first_hit(ray, Start::Elsewhere);
    if !hit.found {
        return 0.0;
    }
    let bounds = primitive.bounds().unwrap();
    let way = bounds.corners().iter().map(|&p| (p - ray.origin).length()).fold(0.0, f64::max);
    off(ray.at(hit.t)) / way
}

/// A ray towards a point from so far away in any direction.
fn towards(random: &mut Random, point: Vec3, distance: f64) -> Ray {
    let origin = point + random.direction() * distance;
    Ray::new(origin, (point - origin) * random.magnitude(-3.0, 3.0))
}

/// A point just beside a distance from an axis or a centre.
fn nearly(random: &mut Random, radius: f64, distance: f64) -> f64 {
    radius + random.between(-1.0, 1.0) * random.magnitude(-17.0, -6.0) * distance
}

#[test]
fn hits_of_balls_lie_on_them() {
    let mut random = Random::new(1);
    let mut worst = 0.0_f64;
    for _ in 0..200_000 {
        let (center, radius) = (random.point(1.0), random.magnitude(-9.0, 0.0));
        let distance = random.magnitude(0.0, 6.0);
        let ball = Primitive::Sphere(Sphere { center, radius });
        let rim = center + random.direction() * nearly(&mut random, radius, distance);
        let ray = towards(&mut random, rim, distance);
        worst = worst.max(beside(&ball, &ray, |p| ((p - center).length() - radius).abs()));
    }
    assert!((1e-17..BOX_MARGIN * 1e-3).contains(&worst), "{worst:e} of the way");
}

#[test]
fn hits_of_cylinders_and_cones_lie_on_them() {
    let mut random = Random::new(2);
    let mut worst = 0.0_f64;
    for i in 0..200_000 {
        let (base, axis) = (random.point(1.0), random.direction());
        let (high, radius) = (random.magnitude(-5.0, 1.0), random.magnitude(-9.0, 0.0));
        let distance = random.magnitude(0.0, 5.0);
        // Up to the flattest cone that a scene may have.
        let slope = if i % 2 == 0 { 0.0 } else { (random.magnitude(-9.0, 6.0)).min(1e6) };
        let radius_at = |height: f64| radius + slope * height;
        let primitive = match i % 2 {
            0 => Primitive::Cylinder(Cylinder { base, axis, low: 0.0, high, radius }),
            _ => Primitive::Cone(Cone { base, axis, low: 0.0, high, base_radius: radius, slope }),
        };
        let height = high * random.between(-0.1, 1.1);
        let (u, v) = axis.tangents();
        let turn = random.between(0.0, std::f64::consts::TAU);
        let outward = u * libm::cos(turn) + v * libm::sin(turn);
        let rim = base + axis * height + outward * nearly(&mut random, radius_at(height), distance);
        let ray = towards(&mut random, rim, distance + slope * high);
        worst = worst.max(beside(&primitive, &ray, |p| {
            let height = axis.dot(p - base);
            let from_axis = (p - base - axis * height).length();
            // Across the side, not across the axis: a flat cone's radius says little of where its side is.
            let across = (from_axis - radius_at(height)).abs() / (1.0 + slope * slope).sqrt();
            across.max(-height).max(height - high)
        }));
    }
    assert!((1e-17..BOX_MARGIN).contains(&worst), "{worst:e} of the way");
}

#[test]
fn what_is_smaller_than_rounding_is_met_nowhere() {
    let mut random = Random::new(4);
    for _ in 0..50_000 {
        let place = random.point(1.0);
        let size = random.magnitude(-24.0, -17.0);
        let corners = [place, place + vec3(size, 0.0, 0.0), place + vec3(0.0, size, 0.0)];
        let Some(triangle) = Triangle::new(corners) else { continue };
        let far =
            place + vec3(random.between(-1.0, 1.0), random.between(-1.0, 1.0), 0.0) + vec3(1e-3, 0.0, 0.0);
        let ray = towards(&mut random, far, 10.0);
        assert!(!triangle.first_hit(&ray, Start::Elsewhere).found, "{corners:?} by {ray:?}");
    }
}
