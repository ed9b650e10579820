//! Each lane has the bits of scalar numbers, whatever instructions compute it.

use crate::common::{KINDS, random_primitive};
use brt_geometry::{LANES, LaneMask, Lanes, Mask, Primitive, Ray, Real, SimdLevel, Start, Vec3, vec3};
use brt_testkit::Random;

fn lanes_of(values: [Vec3; LANES]) -> Vec3<Lanes> {
    let of = |axis: usize| Lanes::from_fn(|i| values[i][axis]);
    vec3(of(0), of(1), of(2))
}

fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan())
}

/// Hits, normals and their products, of eight rays.
#[inline(always)]
fn met<R: Real>(primitive: &Primitive, ray: &Ray<R>, start: Start) -> (R::Mask, [R; 4]) {
    let hit = primitive.first_hit(ray, start);
    let normal = primitive.normal_at(ray.at(hit.t));
    let lit = normal.dot(ray.direction).max(R::constant(0.0)) / ray.dd.sqrt();
    (hit.found, [hit.t, normal.x, normal.y, lit.whole_power(7)])
}

#[test]
fn hits_and_normals_in_lanes_are_those_of_single_rays() {
    for (level, kind) in SimdLevel::ALL.into_iter().flat_map(|l| (0..KINDS).map(move |k| (l, k))) {
        let mut random = Random::new(u64::from(kind));
        let mut hits = 0;
        for _ in 0..2000 {
            let primitive = random_primitive(&mut random, kind);
            let start = random.pick(&[Start::Elsewhere, Start::OnPrimitive]);
            let origins = [(); LANES].map(|()| random.point(4.0));
            let directions = [(); LANES].map(|()| random.direction() * random.magnitude(-3.0, 3.0));
            let (found, values) = level.run(
                #[inline(always)]
                || met(&primitive, &Ray::new(lanes_of(origins), lanes_of(directions)), start),
            );
            for i in 0..LANES {
                let (expected, numbers) = met(&primitive, &Ray::new(origins[i], directions[i]), start);
                assert_eq!(found.has(i), expected, "{level:?} {primitive:?}");
                if expected {
                    hits += 1;
                    assert!((0..4).all(|n| same(values[n].0[i], numbers[n])), "{level:?} {primitive:?}");
                }
            }
        }
        assert!(hits > 100, "kind {kind}: {hits}");
    }
}

#[test]
fn operations_in_lanes_are_those_of_numbers() {
    let specials = [0.0, -0.0, 1.0, -3.5, 1e300, -1e-300, f64::INFINITY, f64::NAN];
    let mut random = Random::new(8);
    for _ in 0..500 {
        let a = Lanes::from_fn(|_| random.pick(&specials) * random.between(0.5, 2.0));
        let b = Lanes::from_fn(|_| random.pick(&specials) * random.between(0.5, 2.0));
        for i in 0..LANES {
            let (x, y) = (a.0[i], b.0[i]);
            let pairs = [
                (a + b, x + y),
                (a - b, x - y),
                (a * b, x * y),
                (a / b, x / y),
                (-a, -x),
                (a.sqrt(), x.sqrt()),
                (Real::min(a, b), Real::min(x, y)),
                (Real::max(a, b), Real::max(x, y)),
                (Lanes::select(a.lt(b), a, b), if x < y { x } else { y }),
                (a.broken_power(1.5), x.broken_power(1.5)),
            ];
            assert!(pairs.iter().all(|(lanes, scalar)| same(lanes.0[i], *scalar)), "{x} {y}");
            let answers = [(a.le(b), x <= y), (a.gt(b), x > y), (a.lt(b), x < y), (a.equals(b), x == y)];
            assert!(answers.iter().all(|(mask, answer)| mask.has(i) == *answer), "{x} {y}");
        }
    }
}

#[test]
fn masks_tell_their_lanes() {
    let three = LaneMask::first(3);
    assert_eq!((three.count(), three.any(), three.all()), (3, true, false));
    assert_eq!((!three).lanes().collect::<Vec<_>>(), [3, 4, 5, 6, 7]);
    assert_eq!((three & !three, three | !three), (LaneMask::FALSE, LaneMask::TRUE));
}

#[test]
fn levels_are_read_as_they_are_written() {
    for level in SimdLevel::ALL {
        assert_eq!(level.to_string().parse(), Ok(level));
    }
    let unknown = "sse9".parse::<SimdLevel>().unwrap_err();
    assert_eq!(unknown.to_string(), "expected one of widest, avx2, baseline");
    assert_eq!(SimdLevel::default(), SimdLevel::Widest);
}
