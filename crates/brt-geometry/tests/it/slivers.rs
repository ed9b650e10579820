//! Nothing is met far from where it is, however thin it is and however nearly along it a ray runs.

use brt_geometry::{BOX_MARGIN, Plane, Primitive, Ray, Start, Triangle, Vec3, polygon_plane, vec3};
use brt_testkit::Random;

/// A triangle about 2 long.
struct Sliver {
    corners: [Vec3; 3],
    /// Its long axis, the one across in its plane, and its normal.
    axes: [Vec3; 3],
}

impl Sliver {
    fn random(random: &mut Random) -> Self {
        let (center, long) = (random.direction(), random.direction());
        let (across, normal) = long.tangents();
        let (tip, width) = (random.between(-0.9, 0.9), random.magnitude(-9.0, -3.0));
        let at = |x: f64, y: f64| center + long * x + across * y;
        Self { corners: [at(-1.0, 0.0), at(1.0, 0.0), at(tip, width)], axes: [long, across, normal] }
    }
}

#[test]
fn corners_of_slivers_lie_in_their_planes() {
    let mut random = Random::new(1);
    let mut planes = 0;
    for _ in 0..100_000 {
        let Sliver { corners, .. } = Sliver::random(&mut random);
        let Some(fit) = polygon_plane(&corners) else { continue };
        planes += 1;
        let off = corners.map(|p| (p - fit.center).dot(fit.normal).abs());
        assert!(off.iter().all(|&off| off < 2e-15), "{off:?} of {corners:?}");
    }
    assert!(planes > 90_000, "{planes}");
}

/// A ray almost in the plane of a sliver, through a point of its long edge's line.
fn ray_along(random: &mut Random, sliver: &Sliver) -> Ray {
    let [long, across, normal] = sliver.axes;
    let point = sliver.corners[0] + long * random.between(-1.0, 3.0);
    let (rise, turn) = (random.magnitude(-9.0, -4.0), random.pick(&[0.0, 1e-9, 0.1, 1.0, 3.0]));
    let along = if random.one_in(2) { long } else { -long };
    let direction = along + normal * rise + across * turn;
    Ray::new(point - direction * random.between(0.0, 20.0), direction)
}

#[test]
fn hits_lie_within_bounds() {
    let mut random = Random::new(2);
    let mut met = 0;
    for _ in 0..1_000_000 {
        let sliver = Sliver::random(&mut random);
        let Some(triangle) = Triangle::new(sliver.corners) else { continue };
        let ray = ray_along(&mut random, &sliver);
        let hit = Primitive::Triangle(triangle).first_hit(&ray, Start::Elsewhere);
        if hit.found {
            met += 1;
            let (point, bounds) = (ray.at(hit.t), triangle.bounds());
            let margin = Vec3::splat(BOX_MARGIN * (1.0 + (ray.origin - sliver.corners[0]).length()));
            let beyond = (bounds.lo - margin - point).max(point - bounds.hi - margin);
            assert!(
                beyond.x.max(beyond.y).max(beyond.z) <= 0.0,
                "{point:?} of {:?} by {ray:?}",
                sliver.corners
            );
        }
    }
    assert!(met > 100_000, "{met}");
}

/// Where it would be met, so far away, nothing is known of the place.
#[test]
fn planes_seen_along_themselves_are_missed() {
    let plane = Plane::through(Vec3::ZERO, vec3(0.0, 1.0, 0.0));
    let towards = |fall: f64| Ray::new(vec3(0.0, 1.0, 0.0), vec3(1.0, -fall, 0.0));
    assert!(plane.first_hit(&towards(1e-6), Start::Elsewhere).found);
    assert!(!plane.first_hit(&towards(1e-8), Start::Elsewhere).found);
}
