//! How much of each margin is needed: by the worst of many random cases, or by the inequality itself where a margin follows from
//! others.

use brt_geometry::{Aabb, LEAST_SINE, Plane, Primitive, Ray, Sphere, Start, Triangle, Vec3, vec3};
use brt_image::Transfer;
use brt_testkit::Random;
use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::*;

const CASES: u32 = 20_000;

#[test]
fn every_margin_is_needed_but_for_its_safety() {
    for margin in ALL {
        let used = match margin.name {
            "DISCRIMINANT_ROUNDINGS" => rounding_of_discriminants() / DISCRIMINANT_ROUNDINGS,
            "FORM_ROUNDINGS" => rounding_of_forms() / FORM_ROUNDINGS,
            "QUOTIENT_ROUNDINGS" => rounding_of_quotients() / QUOTIENT_ROUNDINGS,
            "STORED_ROUNDINGS" => rounding_of_stored_values() / STORED_ROUNDINGS,
            "DEPTH_ROUNDING" => DISCRIMINANT_ROUNDINGS.sqrt() / DEPTH_ROUNDING,
            "EDGE_CLEARANCE" => slacks_to_leave(1.0, LEAST_RISE) / EDGE_CLEARANCE,
            "LEAST_RISE" => slacks_along(LEAST_RISE) / OFF_PLANE,
            "LEAST_VIEW_SINE" => slacks_along(LEAST_VIEW_SINE) / EDGE_CLEARANCE,
            "STEEPEST" => slacks_along(LEAST_RISE) / (EDGE_CLEARANCE / STEEPEST),
            "OFF_PLANE" => 2.0 * slacks_along(LEAST_RISE) / OFF_PLANE,
            "SHEET_CLEARANCE" => slacks_to_leave(4.0, LEAST_RISE) / SHEET_CLEARANCE,
            "WEIGHT_ROUNDINGS" => rounding_of_weights() / WEIGHT_ROUNDINGS,
            "ALLOWED_AT_BLACK" => ALLOWED_AT_BLACK / greatest_at_black(),
            "ALLOWED_AT_CUT" => ALLOWED_AT_CUT * slope(0.5 * CUT),
            "ALLOWED_ABOVE" => {
                ALLOWED_ABOVE * slope(2.0 * CUT) * (2.4 / 1.055) * libm::pow(2.0 * CUT, 1.4 / 2.4)
            }
            "RESERVE" => rounding_of_means() / RESERVE,
            "LIGHT_MARGIN" => rounding_of_ways_to_lights() / LIGHT_MARGIN,
            "CARRIER_ROUNDINGS" => corners_off_each_others_planes() / CARRIER_ROUNDINGS,
            "KEY_ROUNDINGS" => share_of_the_errors_of_keys(),
            "FAR_FROM_ORIGIN" => sizes_from_which_moving_is_exact() / FAR_FROM_ORIGIN,
            name => panic!("no measurement of {name}"),
        };
        margin.check(used);
    }
}

fn exact(x: f64) -> BigRational {
    BigRational::from_float(x).unwrap()
}

fn off(x: f64, right: &BigRational) -> f64 {
    (exact(x) - right).to_f64().unwrap().abs()
}

/// The greatest of what many random cases need.
fn worst(seed: u64, cases: u32, mut case: impl FnMut(&mut Random) -> f64) -> f64 {
    let mut random = Random::new(seed);
    (0..cases).map(|_| case(&mut random)).fold(0.0, f64::max)
}

fn size(p: Vec3) -> f64 {
    p.x.abs() + p.y.abs() + p.z.abs()
}

/// By how much the discriminant and the square of half a chord, which stands for it, are off, as a share of their terms.
fn rounding_of_discriminants() -> f64 {
    worst(1, CASES / 4, |random| {
        let (center, along) = (random.point(3.0), random.point(1.0));
        let radius = size(center) * random.magnitude(-4.0, -0.3);
        let from_center = -center;
        let coordinates = |v: Vec3| [v.x, v.y, v.z].map(exact);
        let dot = |a: &[BigRational; 3], b: &[BigRational; 3]| &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2];
        let (p, d) = (coordinates(from_center), coordinates(along));
        let (b, dd) = (dot(&p, &d), dot(&d, &d));
        let c = dot(&p, &p) - exact(radius) * exact(radius);
        let right = &b * &b - &c * &dd;
        let terms = (&b * &b + &c * &dd).to_f64().unwrap();

        let (b, dd) = (from_center.dot(along), along.length_squared());
        let by_form = b * b - (from_center.length_squared() - radius * radius) * dd;
        let nearest = from_center - along * (b / dd);
        let by_ray = (radius * radius - nearest.length_squared()) * dd;
        (off(by_form, &right) + off(by_ray, &right)) / terms
    })
}

/// By how much a linear form is off that was read off a model over a tile.
fn rounding_of_forms() -> f64 {
    worst(8, CASES / 4, |random| {
        let number = |random: &mut Random| random.between(-1.0, 1.0) * random.magnitude(-2.0, 2.0);
        let (c, u, v) = (number(random), number(random), number(random));
        let (middle, half) = (63.5, 63.5);
        let (column, row) = (u / half, v / half);
        let base = c - column * middle - row * middle;
        let [x, y] = [random.between(0.0, 127.0), random.between(0.0, 127.0)];
        let share = |x: f64| (exact(x) - exact(middle)) / exact(half);
        let right = exact(c) + exact(u) * share(x) + exact(v) * share(y);
        off(base + column * x + row * y, &right) / (c.abs() + u.abs() + v.abs())
    })
}

/// By how much an inverse depth and the inverse of a depth that is compared with it are off together.
fn rounding_of_quotients() -> f64 {
    worst(9, CASES, |random| {
        let x = random.magnitude(-3.0, 3.0);
        let inverse = 1.0 / x;
        (off(inverse, &(exact(1.0) / exact(x))) + off(1.0 / inverse, &exact(x)) / (x * x)) * x
    })
}

/// By how much a filled and a traced value of the same colour differ, as a share of the greatest value.
fn rounding_of_stored_values() -> f64 {
    worst(10, CASES, |random| {
        let (middle, across, down) = (random.unit(), random.between(-0.5, 0.5), random.between(-0.5, 0.5));
        let (x, y) = (random.between(-1.0, 1.0), random.between(-1.0, 1.0));
        let [a, b, c, s, t] = [middle, across, down, x, y].map(|x| x as f32);
        let (s, t) = (f64::from(s), f64::from(t));
        let right = middle + across * s + down * t;
        let filled = a + b * s as f32 + c * t as f32;
        let greatest = middle + across.abs() + down.abs();
        (f64::from(filled) - f64::from(right as f32)).abs() / greatest
    })
}

/// How many slacks along a plane a ray comes that starts so many slacks below it, before it is as many above.
fn slacks_to_leave(height: f64, sine: f64) -> f64 {
    2.0 * height * (1.0 - sine * sine).sqrt() / sine
}

/// To how many slacks along a ray it is known where it meets a plane at this sine.
fn slacks_along(sine: f64) -> f64 {
    1.0 / sine
}

/// By how much weights of corners are off, as a share of the square of coordinates over the area as seen.
fn rounding_of_weights() -> f64 {
    worst(2, CASES / 4, |random| {
        let a = random.point(1.0);
        let corners = [a, a + random.direction() * 0.3, a + random.direction() * 0.3];
        let Some(triangle) = Triangle::new(corners) else { return 0.0 };
        let normal = triangle.plane.normal;
        let place = (corners[0] + corners[1] + corners[2]) * (1.0 / 3.0);
        let (u, _) = normal.tangents();
        let ray = Ray::new(place + u * 2.0 + normal * (2.0 * LEAST_RISE), -u - normal * LEAST_RISE);
        let p = corners.map(|c| {
            [(c.x, ray.origin.x), (c.y, ray.origin.y), (c.z, ray.origin.z)].map(|(c, o)| exact(c) - exact(o))
        });
        let d = [ray.direction.x, ray.direction.y, ray.direction.z].map(exact);
        let volume = |q: &[BigRational; 3], r: &[BigRational; 3]| {
            let minor = |i: usize, j: usize| &q[i] * &r[j] - &q[j] * &r[i];
            &d[0] * minor(1, 2) + &d[1] * minor(2, 0) + &d[2] * minor(0, 1)
        };
        let volumes = [volume(&p[1], &p[2]), volume(&p[2], &p[0]), volume(&p[0], &p[1])];
        let whole = &volumes[0] + &volumes[1] + &volumes[2];
        let error = triangle
            .weights(&ray)
            .iter()
            .zip(&volumes)
            .map(|(w, v)| off(*w, &(v / &whole)))
            .fold(0.0, f64::max);
        let reach = size(ray.origin) + corners.into_iter().map(size).fold(0.0, f64::max);
        let area = (corners[1] - corners[0]).cross(corners[2] - corners[0]).length() * LEAST_RISE;
        error * area / (reach * reach)
    })
}

/// Where sRGB's curve ceases to be straight.
const CUT: f64 = 0.003_130_8;

/// Slope of sRGB's curve.
fn slope(x: f64) -> f64 {
    let step = 1e-4 * x;
    (Transfer::Srgb.encode(x + step) - Transfer::Srgb.encode(x - step)) / (2.0 * step)
}

/// What may be allowed at black so that what is allowed stays concave at the cut.
fn greatest_at_black() -> f64 {
    let above = |x: f64| ALLOWED_ABOVE * 2.4 / 1.055 * libm::pow(x, 1.4 / 2.4);
    let rise = (above(CUT * 1.001) - above(CUT)) / (CUT * 0.001);
    ALLOWED_AT_CUT - rise * CUT
}

/// By how much the mean of the samples of a pixel is off, as a share of a hundredth of a level.
fn rounding_of_means() -> f64 {
    worst(3, CASES / 20, |random| {
        let bright = random.magnitude(-2.0, 0.0);
        let samples: Vec<f32> = (0..256).map(|_| (bright * random.between(0.9, 1.0)) as f32).collect();
        let mean = samples.iter().map(|x| f64::from(*x)).sum::<f64>() / 256.0;
        let stored = |x: f64| 255.0 * Transfer::Srgb.encode(x);
        (stored(f64::from(mean as f32)) - stored(mean)).abs() / 0.01
    })
}

/// By how much the distance to a plane that a light lies in is off, where ways to it are not along it.
fn rounding_of_ways_to_lights() -> f64 {
    worst(4, CASES, |random| {
        let (normal, light) = (random.direction(), random.point(1.0));
        let plane = Plane::through(light, normal);
        let point = light + (random.direction() + normal * 2.0) * random.magnitude(-1.0, 1.0);
        let hit = plane.first_hit(&Ray::new(point, light - point), Start::Elsewhere);
        (hit.t - 1.0).abs()
    })
}

/// A turned and moved quadrilateral as its two pairs of triangles.
fn quadrilateral(random: &mut Random) -> Option<[Triangle; 2]> {
    let (across, other) = random.direction().tangents();
    let middle = random.point(1.0);
    let corner = |a: f64, b: f64| middle + across * a + other * b;
    let [a, b, c, d] = [corner(-0.4, -0.3), corner(0.5, -0.2), corner(0.4, 0.3), corner(-0.5, 0.4)];
    Some([Triangle::new([a, b, c])?, Triangle::new([b, c, d])?])
}

/// How far corners of one half of a face are off the plane of the other.
fn corners_off_each_others_planes() -> f64 {
    worst(5, CASES, |random| {
        let Some([one, other]) = quadrilateral(random) else { return 0.0 };
        let reach = other.corners.iter().map(|p| p.x.abs().max(p.y.abs()).max(p.z.abs())).fold(0.0, f64::max);
        let off = |p: &Vec3| (one.plane.normal.dot(*p) - one.plane.distance).abs();
        other.corners.iter().map(off).fold(0.0, f64::max) / (reach + one.plane.distance.abs())
    })
}

/// How much of the errors of two keys of one plane their difference is.
fn share_of_the_errors_of_keys() -> f64 {
    let bounds = Aabb::around(Vec3::ZERO, Vec3::splat(2.0));
    worst(6, CASES, |random| {
        let Some(halves) = quadrilateral(random) else { return 0.0 };
        let keys = crate::prepare::keys_for_tests(&halves.map(Primitive::Triangle), &bounds);
        (keys[0].0 - keys[1].0).abs() / (keys[0].1 + keys[1].1)
    })
}

/// From how many sizes away on the difference of a coordinate and the middle is exact.
fn sizes_from_which_moving_is_exact() -> f64 {
    // The coordinate is half of the middle at the least.
    const LEAST: f64 = 1.0;
    let inexact =
        |coordinate: f64, middle: f64| off(coordinate - middle, &(exact(coordinate) - exact(middle)));
    let beyond = worst(7, CASES, |random| {
        let middle = random.between(LEAST, 20.0);
        inexact(middle + random.between(-0.5, 0.5), middle)
    });
    assert_eq!(beyond, 0.0);
    // Nearer, a coordinate may be so small that it has digits which the difference has not.
    let within =
        worst(11, CASES, |random| inexact(random.magnitude(-6.0, -2.0), 0.5 * random.between(0.9, 1.0)));
    assert!(within > 0.0);
    LEAST
}

/// What is shared moves hits by less than the room that they have.
#[test]
fn shared_carriers_leave_hits_in_their_room() {
    let scene_sizes = 4.5 + 4.5;
    assert!(CARRIER_ROUNDINGS * scene_sizes / LEAST_SINE < 0.25 * BOX_MARGIN);
    let ball = Sphere { center: vec3(4.5, 4.5, 4.5), radius: 1.0 };
    assert!(CARRIER_ROUNDINGS * (size(ball.center) + ball.radius) < 0.25 * BOX_MARGIN);
}
