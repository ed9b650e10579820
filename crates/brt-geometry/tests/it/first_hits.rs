//! First hits of each primitive against numbers computed by hand: from outside, from inside, tangent, behind, leaving.

use brt_geometry::{
    Cone, Cylinder, Disc, Plane, Polygon, Primitive, Ray, Sphere, Start, Triangle, Vec3, vec3,
};

const X: Vec3 = vec3(1.0, 0.0, 0.0);
const Y: Vec3 = vec3(0.0, 1.0, 0.0);
const Z: Vec3 = vec3(0.0, 0.0, 1.0);

fn hit(primitive: &Primitive, origin: Vec3, direction: Vec3, start: Start) -> Option<f64> {
    let hit = primitive.first_hit(&Ray::new(origin, direction), start);
    hit.found.then_some(hit.t)
}

/// The distance at which a ray from elsewhere hits.
fn from(primitive: &Primitive, origin: Vec3, direction: Vec3) -> Option<f64> {
    hit(primitive, origin, direction, Start::Elsewhere)
}

/// The distance at which a ray that leaves the primitive hits it again.
fn leaving(primitive: &Primitive, origin: Vec3, direction: Vec3) -> Option<f64> {
    hit(primitive, origin, direction, Start::OnPrimitive)
}

fn about(t: Option<f64>, expected: f64) -> bool {
    t.is_some_and(|t| (t - expected).abs() <= 1e-12 * expected.abs())
}

#[test]
fn spheres() {
    let ball = Primitive::Sphere(Sphere { center: vec3(0.0, 0.0, -5.0), radius: 2.0 });
    assert_eq!(from(&ball, Vec3::ZERO, -Z), Some(3.0));
    assert_eq!(from(&ball, Vec3::ZERO, -Z * 4.0), Some(0.75), "units of the direction");
    assert_eq!(from(&ball, vec3(0.0, 0.0, -5.0), X), Some(2.0), "from its middle");
    assert_eq!(from(&ball, vec3(0.0, 0.0, -4.0), -Z), Some(3.0), "from inside");
    assert_eq!(from(&ball, vec3(2.0, 0.0, 0.0), -Z), Some(5.0), "tangent");
    assert_eq!(from(&ball, vec3(2.000_001, 0.0, 0.0), -Z), None, "just past");
    assert_eq!(from(&ball, Vec3::ZERO, Z), None, "behind");
    assert_eq!(from(&ball, vec3(0.0, 0.0, -8.0), -Z), None, "just behind");
    // Leaving inwards from its front: across the diameter; outwards: no more.
    assert_eq!(leaving(&ball, vec3(0.0, 0.0, -3.0), -Z), Some(4.0));
    assert_eq!(leaving(&ball, vec3(0.0, 0.0, -3.0), Z), None);
    assert_eq!(leaving(&ball, vec3(0.0, 0.0, -3.0), X), None, "along its tangent");
    // At 45° into it: a chord of 2·2·cos 45° = √8, direction of length √2.
    assert!(about(leaving(&ball, vec3(0.0, 0.0, -3.0), X - Z), 2.0));
    assert_eq!(ball.normal_at(vec3(0.0, 2.0, -5.0)), Y);
}

#[test]
fn planes() {
    let plane = Primitive::Plane(Plane::through(vec3(7.0, 2.0, -3.0), Y));
    assert_eq!(from(&plane, Vec3::ZERO, Y), Some(2.0));
    assert_eq!(from(&plane, vec3(0.0, 5.0, 0.0), vec3(1.0, -1.5, 0.0)), Some(2.0), "from its front");
    assert_eq!(from(&plane, Vec3::ZERO, -Y), None, "behind");
    assert_eq!(from(&plane, Vec3::ZERO, X), None, "parallel");
    assert_eq!(from(&plane, vec3(0.0, 2.0, 0.0), X), None, "in it");
    assert_eq!(leaving(&plane, vec3(0.0, 2.0, 0.0), vec3(0.0, 1.0, 0.0)), None);
    assert_eq!(plane.bounds(), None);
}

#[test]
fn triangles_and_polygons_from_both_sides_and_at_their_edges() {
    let triangle = Triangle::new([vec3(0.0, 0.0, -4.0), vec3(3.0, 0.0, -4.0), vec3(0.0, 3.0, -4.0)]).unwrap();
    let square = Polygon {
        plane: Plane::through(vec3(0.0, 0.0, -4.0), Z),
        corners: [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]].map(|[x, y]| vec3(x, y, -4.0)).into(),
    };
    // The weights at (1, 0.5): c has 0.5/3, b has 1/3, a the rest.
    let [a, b, c] = triangle.weights(&Ray::new(vec3(1.0, 0.5, 0.0), -Z));
    assert!((a - 0.5).abs() < 1e-15 && (b - 1.0 / 3.0).abs() < 1e-15 && (c - 1.0 / 6.0).abs() < 1e-15);
    for flat in [Primitive::Triangle(triangle), Primitive::Polygon(square)] {
        for (x, y, is_hit) in [
            (1.0, 0.5, true),
            (0.0, 0.0, true),
            (1.0, 0.0, true),
            (0.0, 1.0, true),
            (-1e-9, 1.0, false),
            (1.0, -1e-9, false),
            (2.5, 1.9, false),
        ] {
            let expected = is_hit.then_some(4.0);
            assert_eq!(from(&flat, vec3(x, y, 0.0), -Z), expected, "front at {x},{y}");
            assert_eq!(from(&flat, vec3(x, y, -8.0), Z), expected, "back at {x},{y}");
        }
        assert_eq!(from(&flat, vec3(1.0, 0.5, 0.0), Z), None, "behind");
        assert_eq!(from(&flat, vec3(-1.0, 0.5, -4.0), X), None, "edge-on");
        assert_eq!(leaving(&flat, vec3(1.0, 0.5, -4.0), -Z), None);
        assert_eq!(flat.normal_at(vec3(1.0, 0.5, -4.0)), Z);
    }
    assert!(Triangle::new([Vec3::ZERO, X, X * 2.0]).is_none(), "no area");
}

#[test]
fn discs() {
    let disc = Primitive::Disc(Disc::new(vec3(1.0, 0.0, -4.0), Z, 1.5));
    assert_eq!(from(&disc, vec3(1.0, 0.0, 0.0), -Z), Some(4.0));
    assert_eq!(from(&disc, vec3(2.5, 0.0, 0.0), -Z), Some(4.0), "its rim");
    assert_eq!(from(&disc, vec3(2.500_001, 0.0, 0.0), -Z), None, "past its rim");
    assert_eq!(from(&disc, vec3(0.0, 0.0, -6.0), Z * 0.5), Some(4.0), "from behind");
    assert_eq!(from(&disc, vec3(1.0, 0.0, 0.0), Z), None, "behind the ray");
    assert_eq!(leaving(&disc, vec3(1.0, 0.0, -4.0), Z), None);
    let bounds = disc.bounds().unwrap();
    assert_eq!((bounds.lo, bounds.hi), (vec3(-0.5, -1.5, -4.0), vec3(2.5, 1.5, -4.0)));
}

#[test]
fn cylinders_are_open_and_have_two_sides() {
    let pipe = Primitive::Cylinder(Cylinder {
        base: vec3(0.0, -1.0, 0.0),
        axis: Y,
        low: 0.0,
        high: 3.0,
        radius: 2.0,
    });
    assert_eq!(from(&pipe, vec3(5.0, 0.0, 0.0), -X), Some(3.0));
    assert_eq!(from(&pipe, Vec3::ZERO, X), Some(2.0), "from inside");
    assert_eq!(from(&pipe, vec3(5.0, 2.5, 0.0), -X), None, "above");
    assert_eq!(from(&pipe, vec3(5.0, -1.0, 0.0), -X), Some(3.0), "its lower rim");
    assert_eq!(from(&pipe, vec3(0.0, 9.0, 0.0), -Y), None, "along its axis");
    assert_eq!(from(&pipe, vec3(5.0, 0.0, 2.0), -X), Some(5.0), "tangent");
    assert_eq!(from(&pipe, vec3(5.0, 0.0, 2.1), -X), None);
    // Over the near rim into the far side: at x = −2, after 7 along x, y = 4 − 3.5.
    assert_eq!(from(&pipe, vec3(5.0, 4.0, 0.0), vec3(-2.0, -1.0, 0.0)), Some(3.5));
    assert_eq!(leaving(&pipe, vec3(2.0, 0.0, 0.0), -X), Some(4.0), "to its other side");
    assert_eq!(leaving(&pipe, vec3(2.0, 0.0, 0.0), X), None);
    assert_eq!(leaving(&pipe, vec3(2.0, 0.0, 0.0), vec3(-1.0, 1.0, 0.0)), None, "out of its top");
    assert_eq!(pipe.normal_at(vec3(0.0, 1.5, -2.0)), -Z);
}

#[test]
fn cones_have_one_nappe_and_a_tip() {
    // Radius 2 at y = 0, tip at y = 4: the radius falls by ½ a unit.
    let cone = Primitive::Cone(Cone {
        base: Vec3::ZERO,
        axis: Y,
        low: 0.0,
        high: 4.0,
        base_radius: 2.0,
        slope: -0.5,
    });
    assert!(about(from(&cone, vec3(5.0, 2.0, 0.0), -X), 4.0), "radius 1 at half height");
    assert!(about(from(&cone, vec3(0.0, 2.0, 0.0), X), 1.0), "from inside");
    assert!(about(from(&cone, vec3(0.0, 9.0, 0.0), -Y), 5.0), "onto its tip");
    assert_eq!(from(&cone, vec3(5.0, 5.0, 0.0), -X), None, "the other nappe does not count");
    assert_eq!(from(&cone, vec3(5.0, -0.1, 0.0), -X), None, "below its base");
    assert_eq!(from(&cone, vec3(5.0, 2.0, 0.0), X), None, "behind");
    // From below through the open base at x = 1: radius 1 at y = 2.
    assert!(about(from(&cone, vec3(1.0, -3.0, 0.0), Y), 5.0));
    assert!(about(leaving(&cone, vec3(1.0, 2.0, 0.0), -X), 2.0), "to its other side");
    assert_eq!(leaving(&cone, vec3(1.0, 2.0, 0.0), X), None);
    // Parallel to its side line, which leads from (2, 0) to (0, 4), from inside: the other side at x = −1 + …
    // x = −t, y = 2t: radius 2 − t = |x| = t, so t = 1.
    assert!(about(from(&cone, Vec3::ZERO, vec3(-1.0, 2.0, 0.0)), 1.0));
    // The normal leans up by the slope: (2, 1)/√5.
    let normal = cone.normal_at(vec3(1.0, 2.0, 0.0));
    assert!((normal - vec3(2.0, 1.0, 0.0) * (1.0 / 5.0_f64.sqrt())).length() < 1e-15);
}

#[test]
fn a_cone_widens_upwards_too() {
    let funnel = Primitive::Cone(Cone {
        base: Vec3::ZERO,
        axis: Y,
        low: 0.0,
        high: 2.0,
        base_radius: 1.0,
        slope: 1.0,
    });
    assert!(about(from(&funnel, vec3(9.0, 1.0, 0.0), -X), 7.0));
    // Straight down at x = 2: met where the radius is 2, at y = 1.
    assert!(about(from(&funnel, vec3(2.0, 5.0, 0.0), -Y), 4.0));
    let bounds = funnel.bounds().unwrap();
    assert_eq!((bounds.lo, bounds.hi), (vec3(-3.0, 0.0, -3.0), vec3(3.0, 2.0, 3.0)));
}
