//! How much of each margin is needed: by the worst of many random cases, against exact arithmetic.

use brt_testkit::Random;
use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::*;
use crate::{Aabb, Lanes, Plane, Ray, RayBlock, Start, Taylor, Triangle, Vec3, vec3};

const CASES: u32 = 20_000;

#[test]
fn every_margin_is_needed_but_for_its_safety() {
    for margin in ALL {
        let used = match margin.name {
            "BOX_MARGIN" => beside_faces(LEAST_SINE) / BOX_MARGIN,
            // Beside a face hits lie in inverse proportion to the sine: this one puts them at the end of their room.
            "LEAST_SINE" => beside_faces(LEAST_SINE) / BOX_MARGIN,
            "FACE_FLATNESS" => beside_a_corner_off_its_plane() / BOX_MARGIN,
            "SLIVER_ROUNDINGS" => sines_at_which_slivers_are_lines() / SLIVER_ROUNDINGS,
            "AREA_ROUNDINGS" => rounding_of_areas() / AREA_ROUNDINGS,
            "GRID_ROOM" => farthest_corner_of_a_grid() / GRID_ROOM,
            "WALK_MARGIN" => rounding_of_walks() / WALK_MARGIN,
            "TREE_SLACK" => rounding_of_slabs() / TREE_SLACK,
            "START_ROUNDINGS" => rounding_of_points() / START_ROUNDINGS,
            "SHAFT_SLACK" => rounding_of_sides_of_boxes() / (3.0 * SHAFT_SLACK),
            "OFFSET_ROUNDINGS" => rounding_of_offsets() / OFFSET_ROUNDINGS,
            "MOMENT_ROUNDINGS" => rounding_of_moments() / MOMENT_ROUNDINGS,
            "MODEL_ROUNDING" => share_of_remainders_used_up(),
            "BLOCK_ROUNDINGS" => rounding_of_sides_of_edges() / BLOCK_ROUNDINGS,
            "COORDINATE_ROUNDING" => rounding_of_heights() / COORDINATE_ROUNDING,
            name => panic!("no measurement of {name}"),
        };
        margin.check(used);
    }
}

fn exact(x: f64) -> BigRational {
    BigRational::from_float(x).unwrap()
}

/// How far a number is off an exact one.
fn off(x: f64, right: &BigRational) -> f64 {
    (exact(x) - right).to_f64().unwrap().abs()
}

/// The greatest of what many random cases need.
fn worst(seed: u64, cases: u32, mut case: impl FnMut(&mut Random) -> f64) -> f64 {
    let mut random = Random::new(seed);
    (0..cases).map(|_| case(&mut random)).fold(0.0, f64::max)
}

fn point(random: &mut Random, half: f64) -> Vec3 {
    vec3(random.between(-half, half), random.between(-half, half), random.between(-half, half))
}

fn direction(random: &mut Random) -> Vec3 {
    point(random, 1.0).try_normalize().unwrap_or(vec3(1.0, 0.0, 0.0))
}

fn size(p: Vec3) -> f64 {
    p.x.abs() + p.y.abs() + p.z.abs()
}

/// How far beside a face rays of about this sine meet it, as a share of the way to its farthest corner.
fn beside_faces(sine: f64) -> f64 {
    worst(3, 200_000, |random| {
        let (a, size) = (point(random, 1.0), random.magnitude(-3.0, 0.0));
        let corners = [a, a + direction(random) * size, a + direction(random) * size];
        let Some(triangle) = Triangle::new(corners) else { return 0.0 };
        let normal = triangle.plane.normal;
        let side = corners[(1 + random.below(2)) as usize];
        let place = a
            + (side - a) * random.between(-0.1, 1.1)
            + direction(random) * size * random.magnitude(-12.0, -1.0);
        let (u, v) = normal.tangents();
        let turn = random.between(0.0, std::f64::consts::TAU);
        let rise = sine * random.between(1.0, 1.2) * if random.one_in(2) { 1.0 } else { -1.0 };
        let along = u * libm::cos(turn) + v * libm::sin(turn) + normal * rise;
        let ray = Ray::new(place - along * random.magnitude(0.0, 3.0), along);
        let hit = triangle.first_hit(&ray, Start::Elsewhere);
        let way = corners.iter().map(|&p| (p - ray.origin).length()).fold(0.0, f64::max);
        if hit.found { outside(&corners, normal, ray.at(hit.t)) / way } else { 0.0 }
    })
}

/// How far a point lies outside of a triangle.
fn outside(corners: &[Vec3; 3], normal: Vec3, p: Vec3) -> f64 {
    let beyond = |i: usize| {
        let (from, to) = (corners[i], corners[(i + 1) % 3]);
        (to - from).cross(normal).try_normalize().map_or(0.0, |across| across.dot(p - from))
    };
    (0..3).map(beyond).fold(normal.dot(p - corners[0]).abs(), f64::max)
}

/// How far from a corner that is off its plane by [`FACE_FLATNESS`] of the face a ray at [`LEAST_SINE`] meets the plane.
fn beside_a_corner_off_its_plane() -> f64 {
    worst(4, CASES, |random| {
        let turn = random.between(0.0, std::f64::consts::TAU);
        let corner = vec3(libm::cos(turn), libm::sin(turn), FACE_FLATNESS);
        let along = vec3(-libm::sin(turn), libm::cos(turn), -1.001 * LEAST_SINE);
        let ray = Ray::new(corner - along * random.between(0.1, 1.0), along);
        let hit = Plane::new(vec3(0.0, 0.0, 1.0), 0.0).first_hit(&ray, Start::Elsewhere);
        (ray.at(hit.t) - corner).length()
    })
}

/// The greatest sine, times the share of a sliver's area, at which it seems to be met beyond its ends.
fn sines_at_which_slivers_are_lines() -> f64 {
    worst(5, 200_000, |random| {
        let (base, long) = (point(random, 1.0), direction(random));
        let share = random.magnitude(-11.0, -8.0);
        let (across, _) = long.tangents();
        let corners = [base, base + long, base + long * random.unit() + across * share];
        let Some(triangle) = Triangle::new(corners) else { return 0.0 };
        let sine = random.magnitude(-8.0, -3.0);
        let beyond = base
            + long * if random.one_in(2) { random.between(1.1, 2.0) } else { random.between(-1.0, -0.1) };
        let along = long.cross(triangle.plane.normal)
            + triangle.plane.normal * sine
            + long * random.between(-0.5, 0.5);
        let ray = Ray::new(beyond - along * random.unit(), along);
        // What is asked of their area, too, leaves few of them.
        let seen = corners.map(ray.view_along());
        let side = |i: usize| seen[(i + 2) % 3][0] * seen[i][1] - seen[(i + 2) % 3][1] * seen[i][0];
        let sides = [side(0), side(1), side(2)];
        let is_inside = sides.iter().all(|s| *s >= 0.0) || sides.iter().all(|s| *s <= 0.0);
        // The side of the triangle that is as long as its longest is what its area is compared with.
        if is_inside { 0.5 * share * sine } else { 0.0 }
    })
}

/// By how much areas of polygons of three to six corners are off, as a share of their products.
fn rounding_of_areas() -> f64 {
    worst(6, CASES / 4, |random| {
        let place = random.magnitude(0.0, 3.0);
        let corner =
            |random: &mut Random| [random.between(-1.0, 1.0) + place, random.between(-1.0, 1.0) + place];
        let corners: Vec<[f64; 2]> = (0..3 + random.below(4)).map(|_| corner(random)).collect();
        let (mut area, mut sizes, mut right) = (0.0, 0.0, exact(0.0));
        for i in 0..corners.len() {
            let (a, b) = (corners[(i + corners.len() - 1) % corners.len()], corners[i]);
            let (forward, backward) = (a[0] * b[1], a[1] * b[0]);
            area += forward - backward;
            sizes += forward.abs() + backward.abs();
            right += exact(a[0]) * exact(b[1]) - exact(a[1]) * exact(b[0]);
        }
        off(area, &right) / sizes
    })
}

/// The distance, in sizes of a grid, from where a walk may start to the grid's farthest corner; and one more for rounding.
fn farthest_corner_of_a_grid() -> f64 {
    worst(7, CASES, |random| {
        let half = vec3(0.5 * random.unit(), 0.5, 0.5 * random.unit());
        let start = direction(random);
        let start = start * ((GRID_ROOM - 2.0) / size(start));
        let corners = Aabb::around(Vec3::ZERO, half).corners();
        1.0 + corners.iter().map(|&p| (p - start).length()).fold(0.0, f64::max)
    })
}

/// By how much the distance to a boundary of cells is off.
fn rounding_of_walks() -> f64 {
    worst(8, CASES, |random| {
        let (boundary, origin) = (random.between(-1.0, 1.0), random.between(-60.0, 60.0));
        let along = random.magnitude(-6.0, 0.0);
        let right = (exact(boundary) - exact(origin)) / exact(along);
        off((boundary - origin) * (1.0 / along), &right) / right.to_f64().unwrap().abs()
    })
}

/// By how much the distance to a plane of a box is off in single precision, as walks of the tree compute it.
fn rounding_of_slabs() -> f64 {
    worst(9, 200_000, |random| {
        let (plane, origin) = (random.between(-1.0, 1.0) as f32, random.between(-4.0, 4.0) as f32);
        let along = random.magnitude(-6.0, 0.0);
        let shortened = (plane - origin) * (1.0 / along as f32) * (1.0 - TREE_SLACK as f32);
        let right = (f64::from(plane) - f64::from(origin)) / along;
        (f64::from(shortened) / (1.0 - TREE_SLACK) - right).abs() / right.abs()
    })
}

/// How far a point of a ray next to its start is from where it should be, as a share of the coordinates' sum.
fn rounding_of_points() -> f64 {
    worst(17, CASES, |random| {
        let ray = Ray::new(point(random, 1.0) * 0.3, direction(random));
        let t = random.magnitude(-18.0, -14.0);
        let (at, o, d) = (ray.at(t), ray.origin, ray.direction);
        let off = [(at.x, o.x, d.x), (at.y, o.y, d.y), (at.z, o.z, d.z)]
            .map(|(x, o, d)| off(x, &(exact(o) + exact(d) * exact(t))));
        off.into_iter().fold(0.0, f64::max) / size(o)
    })
}

/// By how much the side of a box's corner is off in single precision, as a share of the tree's reach.
fn rounding_of_sides_of_boxes() -> f64 {
    worst(10, 200_000, |random| {
        let normal = point(random, 1.0);
        let normal = normal * (1.0 / normal.x.abs().max(normal.y.abs()).max(normal.z.abs()));
        let corner = point(random, 1.0);
        let [n, p] = [normal, corner].map(|v| [v.x as f32, v.y as f32, v.z as f32]);
        let side = n[0] * p[0] + n[1] * p[1] + n[2] * p[2];
        let right = normal.dot(vec3(f64::from(p[0]), f64::from(p[1]), f64::from(p[2])));
        (f64::from(side) - right).abs()
    })
}

/// By how much the offset of a face from the tree's centre is off, as a share of its terms.
fn rounding_of_offsets() -> f64 {
    worst(15, CASES, |random| {
        let (normal, center, offset) =
            (point(random, 1.0), point(random, 100.0), random.between(-100.0, 100.0));
        let along = exact(normal.x) * exact(center.x)
            + exact(normal.y) * exact(center.y)
            + exact(normal.z) * exact(center.z);
        off(offset - normal.dot(center), &(exact(offset) - along))
            / (offset.abs() + normal.length() * center.length())
    })
}

/// How large the moment of a ray to a point around this point is, which would be 0.
fn rounding_of_moments() -> f64 {
    worst(16, CASES, |random| {
        let (origin, to) = (point(random, 1.0) * 0.3, point(random, 1.0) * (5.0 / 7.0));
        let along = to - origin;
        let way = [(to.x, origin.x), (to.y, origin.y), (to.z, origin.z)].map(|(p, o)| exact(o) - exact(p));
        let d = [along.x, along.y, along.z].map(exact);
        let moment = |i: usize, j: usize| (&way[i] * &d[j] - &way[j] * &d[i]).to_f64().unwrap().abs();
        let greatest = along.x.abs().max(along.y.abs()).max(along.z.abs());
        moment(1, 2).max(moment(2, 0)).max(moment(0, 1)) / (greatest * greatest)
    })
}

/// How much of its remainder a sum or a difference of two models uses up, which adds nothing but rounding.
fn share_of_remainders_used_up() -> f64 {
    worst(11, CASES / 4, |random| {
        let number = |random: &mut Random| random.between(-1.0, 1.0) * random.magnitude(-3.0, 3.0);
        let model = |random: &mut Random| Taylor::linear(number(random), number(random), number(random));
        let (a, b) = (model(random), model(random));
        let at = |m: &Taylor, u: f64, v: f64| exact(m.c) + exact(m.u) * exact(u) + exact(m.v) * exact(v);
        let sum = a + b;
        let corners = [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]];
        let beside =
            corners.map(|[u, v]| (at(&a, u, v) + at(&b, u, v) - at(&sum, u, v)).to_f64().unwrap().abs());
        beside.into_iter().fold(0.0, f64::max) / sum.e
    })
}

/// By how much two ways to compute the side of an edge are off together, as a share of their terms.
fn rounding_of_sides_of_edges() -> f64 {
    worst(12, CASES / 4, |random| {
        let (origin, along) = (point(random, 3.0), point(random, 1.0));
        let corners = [point(random, 1.0), point(random, 1.0), point(random, 1.0)];
        let ray = Ray::new(origin, along);
        let block = RayBlock::new(Ray::new(origin.lift::<Taylor>(), along.lift()));
        let sizes = |p: Vec3| p.x.abs().max(p.y.abs()).max(p.z.abs());
        let greatest = sizes(along);
        let by_block: Vec<Taylor> = block.sides(&corners).collect();
        let seen = corners.map(ray.view_along());
        let of_edge = |i: usize| {
            let (a, b) = (corners[(i + 2) % 3], corners[i]);
            let [p, q] = [a, b].map(|p| {
                [(p.x, origin.x), (p.y, origin.y), (p.z, origin.z)].map(|(p, o)| exact(p) - exact(o))
            });
            let d = [along.x, along.y, along.z].map(exact);
            let minor = |i: usize, j: usize| &p[i] * &q[j] - &p[j] * &q[i];
            let right = &d[0] * minor(1, 2) + &d[1] * minor(2, 0) + &d[2] * minor(0, 1);
            // Single rays see the same determinant over the direction's greatest coordinate, of either sign.
            let (s, t) = (seen[(i + 2) % 3], seen[i]);
            let single = s[0] * t[1] - s[1] * t[0];
            let scale = [along.x, along.y, along.z].into_iter().find(|x| x.abs() == greatest).unwrap();
            let by_ray =
                [scale, -scale].map(|scale| off(single / scale, &right)).into_iter().fold(f64::MAX, f64::min);
            let terms = size(along) * (sizes(a) + sizes(origin)) * (sizes(b) + sizes(origin));
            (off(by_block[i].c, &right) + by_ray) / terms
        };
        (0..3).map(of_edge).fold(0.0, f64::max)
    })
}

/// By how much heights over a plane are off, as a share of all coordinates.
fn rounding_of_heights() -> f64 {
    worst(13, CASES, |random| {
        let (normal, distance, p) = (direction(random), random.between(-1.0, 1.0), point(random, 1.0));
        let right =
            exact(normal.x) * exact(p.x) + exact(normal.y) * exact(p.y) + exact(normal.z) * exact(p.z)
                - exact(distance);
        off(normal.dot(p) - distance, &right) / (size(p) + distance.abs())
    })
}

/// The same in lanes: bits are those of single numbers, so margins are, too.
#[test]
fn lanes_round_as_numbers_do() {
    let mut random = Random::new(14);
    let (a, b) = (point(&mut random, 1.0), point(&mut random, 1.0));
    assert_eq!(a.lift::<Lanes>().dot(b.lift()).0[0].to_bits(), a.dot(b).to_bits());
}
