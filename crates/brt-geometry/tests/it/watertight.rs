//! No ray slips between two polygons that share an edge, nor through a corner that several share.

use brt_geometry::{Ray, Start, Triangle, Vec3, triangulate};
use brt_testkit::Random;

fn hits(corners: [Vec3; 3], ray: &Ray) -> bool {
    Triangle::new(corners).is_some_and(|t| t.first_hit(ray, Start::Elsewhere).found)
}

/// On which side of the plane through the eye and an edge a point lies.
fn side(eye: Vec3, a: Vec3, b: Vec3, point: Vec3) -> f64 {
    (point - eye).dot((a - eye).cross(b - eye))
}

#[test]
fn a_ray_through_a_shared_edge_hits_one_of_both() {
    let mut random = Random::new(21);
    let (mut tried, mut both) = (0, 0);
    while tried < 30_000 {
        let size = random.pick(&[1.0, 1.0, 1e6, 1e-6]);
        let offset = Vec3::splat(random.pick(&[0.0, 0.0, 1e3]) * size);
        let mut point = || random.point(1.0) * size + offset;
        let (a, b, c, d, eye) = (point(), point(), point(), point(), point());
        // Seen from the eye the triangles must lie on both sides of the edge: a fold can be passed by.
        let (at_c, at_d) = (side(eye, a, b, c), side(eye, a, b, d));
        if at_c * at_d >= 0.0 || at_c.abs().min(at_d.abs()) < 1e-3 * size * size * size {
            continue;
        }
        tried += 1;
        let share = if random.one_in(8) { f64::from(random.below(2)) } else { random.unit() };
        let target = a + (b - a) * share;
        let ray = Ray::new(eye, (target - eye) * random.magnitude(-10.0, 10.0));
        // The neighbour has the edge the other way round, and either may begin with any corner.
        let first = random.pick(&[[a, b, c], [b, c, a], [c, a, b]]);
        let second = random.pick(&[[b, a, d], [a, d, b], [d, b, a], [a, b, d]]);
        let at = [hits(first, &ray), hits(second, &ray)];
        // At the very ends of the edge the rounded target may lie outside of both.
        if share > 1e-9 && share < 1.0 - 1e-9 {
            assert!(at[0] || at[1], "{a:?} {b:?} from {eye:?} at {share}");
        }
        both += u32::from(at[0] && at[1]);
    }
    assert!(both < tried / 2, "edges are thin: {both} of {tried} rays hit both");
}

/// How many triangles of a fan around `hub`, which surrounds the view from `eye`, are hit by a ray at `hub`.
fn fan_hits(random: &mut Random, eye: Vec3, hub: Vec3, round: impl Fn(Vec3) -> Vec3) -> usize {
    let (u, v) = (hub - eye).normalize().tangents();
    let view = (hub - eye).normalize();
    let count = 3 + random.below(6);
    let rim: Vec<Vec3> = (0..count)
        .map(|i| {
            let angle = std::f64::consts::TAU * (f64::from(i) + 0.3 * random.unit()) / f64::from(count);
            round(hub + u * libm::cos(angle) + v * libm::sin(angle) + view * random.between(-0.5, 0.5))
        })
        .collect();
    let ray = Ray::new(eye, hub - eye);
    (0..rim.len()).filter(|&i| hits([hub, rim[i], rim[(i + 1) % rim.len()]], &ray)).count()
}

#[test]
fn a_ray_at_the_common_corner_of_a_fan_hits_where_numbers_are_short() {
    let mut random = Random::new(22);
    // Multiples of 2⁻¹⁰ below 4: edge functions need 36 bits and are exact.
    let short = |p: Vec3| {
        let round = |x: f64| (x * 1024.0).round() / 1024.0;
        Vec3::from([round(p.x), round(p.y), round(p.z)])
    };
    for case in 0..5000 {
        let (eye, hub) = (short(random.point(1.0)), short(random.point(1.0)));
        if (hub - eye).length() > 0.1 {
            let met = fan_hits(&mut random, eye, hub, short);
            assert!(met > 0, "case {case}: slipped through {hub:?} from {eye:?}");
        }
    }
}

#[test]
fn no_ray_slips_through_a_common_corner() {
    let mut random = Random::new(24);
    for case in 0..100_000 {
        let size = random.pick(&[1.0, 1.0, 1e6, 1e-6]);
        let offset = Vec3::splat(random.pick(&[0.0, 0.0, 1e3]) * size);
        let mut point = || random.point(1.0) * size + offset;
        let (eye, hub) = (point(), point());
        if (hub - eye).length() > 0.1 * size {
            let met = fan_hits(&mut random, eye, hub, |p| p);
            assert!(met > 0, "case {case}: slipped through {hub:?} from {eye:?}");
        }
    }
}

#[test]
fn the_triangles_of_a_concave_polygon_leave_no_gap_inside_it() {
    let mut random = Random::new(23);
    for case in 0..300 {
        let normal = random.direction();
        let (u, v) = normal.tangents();
        let center = random.point(2.0);
        let points = 3 + random.below(5);
        let radius = |i: u32| if i.is_multiple_of(2) { 1.0 } else { 0.5 };
        let corner = |i: u32| {
            let angle = std::f64::consts::TAU * f64::from(i) / f64::from(2 * points);
            center + (u * libm::cos(angle) + v * libm::sin(angle)) * radius(i)
        };
        let outline: Vec<Vec3> = (0..2 * points).map(corner).collect();
        let triangles = triangulate(&outline, &[], normal);
        assert_eq!(triangles.len() as u32, 2 * points - 2);
        for _ in 0..50 {
            // Inside the circle that all dents leave free, also exactly on the line between two corners.
            let (i, j) = (random.below(2 * points), random.below(2 * points));
            let near = |k: u32| center + (outline[k as usize] - center) * 0.4;
            let target = near(i) + (near(j) - near(i)) * random.unit();
            let eye = target + normal * random.between(0.5, 3.0) + random.point(0.4);
            let ray = Ray::new(eye, target - eye);
            let met = triangles.iter().filter(|t| hits(t.map(|k| outline[k as usize]), &ray)).count();
            assert!(met > 0, "case {case}: slipped through at {target:?}");
        }
    }
}
