//! What a whole block of rays hits, by Taylor models, holds for each of its rays.

use crate::common::{KINDS, random_primitive};
use brt_geometry::{
    Aabb, Hit, LANES, LaneRays, Lanes, Mask, Primitive, Ray, RayBlock, Real, Shaft, Start, Taylor, Vec3, vec3,
};
use brt_testkit::Random;

/// A block of rays of a camera: column and row in, ray out.
struct View {
    eye: Vec3,
    corner: Vec3,
    right: Vec3,
    down: Vec3,
    is_perspective: bool,
    count: [u32; 2],
}

impl View {
    fn random(random: &mut Random) -> Self {
        let forward = random.direction();
        let (right, down) = forward.tangents();
        let step = random.magnitude(-3.5, -0.5);
        let place = right * random.between(-1.0, 1.0) + down * random.between(-1.0, 1.0);
        Self {
            eye: forward * -random.between(0.0, 6.0) + place * random.between(0.0, 1.0),
            corner: forward + place * 0.2,
            right: right * step,
            down: down * step,
            is_perspective: !random.one_in(4),
            count: [1 + random.below(10), 1 + random.below(10)],
        }
    }

    fn ray<R: Real>(&self, x: R, y: R) -> Ray<R> {
        let offset = self.right.lift::<R>() * x + self.down.lift::<R>() * y;
        if self.is_perspective {
            Ray::new(self.eye.lift(), self.corner.lift::<R>() + offset)
        } else {
            Ray::new(self.eye.lift::<R>() + offset, self.corner.lift())
        }
    }

    fn block(&self) -> Ray<Taylor> {
        let [x, y] = self.count.map(|n| 0.5 * f64::from(n - 1));
        self.ray(Taylor::linear(x, x, 0.0), Taylor::linear(y, 0.0, y))
    }

    fn rays(&self) -> impl Iterator<Item = Ray> + '_ {
        let samples = (0..self.count[1]).flat_map(|y| (0..self.count[0]).map(move |x| (x, y)));
        samples.map(|(x, y)| self.ray(f64::from(x), f64::from(y)))
    }
}

/// How many blocks were said to be hit by all rays, by none, and by maybe some.
#[derive(Debug, Default)]
struct Verdicts {
    all: u32,
    none: u32,
    open: u32,
    /// Open though all rays hit or none does.
    undecided: u32,
}

fn check(primitive: &Primitive, view: &View, start: Start, verdicts: &mut Verdicts) {
    let bound = primitive.first_hit(&view.block(), start);
    check_bound(&bound, primitive, view, start, verdicts);
}

fn check_bound(
    bound: &Hit<Taylor>,
    primitive: &Primitive,
    view: &View,
    start: Start,
    verdicts: &mut Verdicts,
) {
    let [lo, hi] = bound.t.range();
    let (mut hits, mut misses) = (0, 0);
    for ray in view.rays() {
        let hit = primitive.first_hit(&ray, start);
        assert!(hit.found || !bound.found.all(), "certain, but missed by {ray:?}: {primitive:?}");
        assert!(!hit.found || bound.found.any(), "impossible, but hit by {ray:?}: {primitive:?}");
        if hit.found {
            assert!(lo <= hit.t && hit.t <= hi, "{} not in {lo}..{hi}: {ray:?} {primitive:?}", hit.t);
            hits += 1;
        } else {
            misses += 1;
        }
    }
    match (bound.found.all(), bound.found.any()) {
        (true, _) => verdicts.all += 1,
        (_, false) => verdicts.none += 1,
        _ => {
            verdicts.open += 1;
            verdicts.undecided += u32::from(hits == 0 || misses == 0);
        }
    }
}

#[test]
fn what_is_certain_of_a_block_is_true_of_every_ray() {
    for kind in 0..KINDS {
        let mut random = Random::new(100 + u64::from(kind));
        let mut verdicts = Verdicts::default();
        for _ in 0..4000 {
            let primitive = random_primitive(&mut random, kind);
            check(&primitive, &View::random(&mut random), Start::Elsewhere, &mut verdicts);
        }
        // Bounds must be good for something: most blocks are decided, those hit as well as those missed.
        let Verdicts { all, none, undecided, .. } = verdicts;
        assert!(all > 200 && none > 200 && undecided < 1200, "kind {kind}: {verdicts:?}");
    }
}

#[test]
fn what_is_certain_of_rays_that_leave_the_primitive_is_true_as_well() {
    for kind in 0..KINDS {
        let mut random = Random::new(200 + u64::from(kind));
        let mut verdicts = Verdicts::default();
        for _ in 0..2000 {
            let primitive = random_primitive(&mut random, kind);
            check(&primitive, &View::random(&mut random), Start::OnPrimitive, &mut verdicts);
        }
        assert!(verdicts.none > 100, "kind {kind}: {verdicts:?}");
    }
}

#[test]
fn moments_say_the_same_and_leave_less_open() {
    for kind in 0..KINDS {
        let mut random = Random::new(400 + u64::from(kind));
        let (mut plain, mut by_moments) = (Verdicts::default(), Verdicts::default());
        for _ in 0..4000 {
            let primitive = random_primitive(&mut random, kind);
            let view = View::random(&mut random);
            let block = RayBlock::new(view.block());
            check(&primitive, &view, Start::Elsewhere, &mut plain);
            let bound = block.first_hit(&primitive, Start::Elsewhere);
            check_bound(&bound, &primitive, &view, Start::Elsewhere, &mut by_moments);
            let [lo, hi] = block.distance(&primitive, Start::Elsewhere).range();
            let hits = view.rays().map(|ray| primitive.first_hit(&ray, Start::Elsewhere));
            assert!(hits.filter(|hit| hit.found).all(|hit| lo <= hit.t && hit.t <= hi), "{primitive:?}");
        }
        assert!(by_moments.undecided <= plain.undecided + 5, "kind {kind}: {plain:?} {by_moments:?}");
    }
}

/// From a piece of a plane to a light.
#[test]
fn light_ways_are_judged_around_the_light() {
    for kind in 0..KINDS {
        let mut random = Random::new(500 + u64::from(kind));
        let (mut certain, mut impossible) = (0, 0);
        for _ in 0..1500 {
            let primitive = random_primitive(&mut random, kind);
            let light = random.point(5.0);
            let (corner, normal) = (random.point(4.0), random.direction());
            let step = random.magnitude(-4.0, -0.5);
            let (right, down) = (normal.tangents().0 * step, normal.tangents().1 * step);
            let at = |x: f64, y: f64| corner + right * x + down * y;
            let origin = corner.lift::<Taylor>()
                + right.lift() * Taylor::linear(2.0, 2.0, 0.0)
                + down.lift() * Taylor::linear(3.0, 0.0, 3.0);
            let ways = Ray::new(origin, light.lift() - origin);
            let bound = RayBlock::to_point(ways, light).first_hit(&primitive, Start::Elsewhere);
            let [lo, hi] = bound.t.range();
            for (x, y) in (0..=4).flat_map(|x| (0..=6).map(move |y| (f64::from(x), f64::from(y)))) {
                let ray = Ray::new(at(x, y), light - at(x, y));
                let hit = primitive.first_hit(&ray, Start::Elsewhere);
                assert!(hit.found || !bound.found.all(), "certain, but missed: {ray:?} {primitive:?}");
                assert!(!hit.found || bound.found.any(), "impossible, but hit: {ray:?} {primitive:?}");
                assert!(!hit.found || (lo <= hit.t && hit.t <= hi), "{} not in {lo}..{hi}", hit.t);
            }
            certain += u32::from(bound.found.all());
            impossible += u32::from(!bound.found.any());
        }
        assert!(certain > 20 && impossible > 100, "kind {kind}: {certain} {impossible}");
    }
}

#[test]
fn what_a_shaft_misses_no_ray_hits() {
    for kind in 0..KINDS {
        let mut random = Random::new(600 + u64::from(kind));
        let mut missed = 0;
        for _ in 0..4000 {
            let primitive = random_primitive(&mut random, kind);
            let view = View::random(&mut random);
            let block = view.block();
            let end = if random.one_in(2) { f64::INFINITY } else { random.between(0.1, 5.0) };
            let Some(shaft) = Shaft::around(&block.origin, &block.direction, end) else { continue };
            if shaft.misses(&primitive) {
                missed += 1;
                let mut hits = view.rays().map(|ray| primitive.first_hit(&ray, Start::Elsewhere));
                assert!(!hits.any(|hit| hit.found && hit.t <= end), "{primitive:?}");
            }
        }
        // Infinite planes are never missed.
        assert!(missed > 500 || kind == 1, "kind {kind}: {missed}");
    }
}

#[test]
fn what_a_shaft_of_single_rays_misses_none_of_them_hits() {
    for kind in 0..KINDS {
        let mut random = Random::new(700 + u64::from(kind));
        let mut missed = 0;
        for _ in 0..4000 {
            let primitive = random_primitive(&mut random, kind);
            let view = View::random(&mut random);
            let rays: Vec<Ray> = view.rays().take(64).collect();
            let vector = |packet: usize, of: fn(&Ray) -> Vec3| {
                let at = |lane: usize| of(&rays[(packet * LANES + lane).min(rays.len() - 1)]);
                let part = |of: fn(Vec3) -> f64| Lanes::from_fn(|lane| of(at(lane)));
                vec3(part(|v| v.x), part(|v| v.y), part(|v| v.z))
            };
            let lanes: Vec<LaneRays> = (0..rays.len().div_ceil(LANES))
                .map(|i| LaneRays { origin: vector(i, |r| r.origin), direction: vector(i, |r| r.direction) })
                .collect();
            let end = if random.one_in(2) { f64::INFINITY } else { random.between(0.1, 5.0) };
            let Some(shaft) = Shaft::around_rays(&lanes, end) else { continue };
            if shaft.misses(&primitive) {
                missed += 1;
                let mut hits = rays.iter().map(|ray| primitive.first_hit(ray, Start::Elsewhere));
                assert!(!hits.any(|hit| hit.found && hit.t <= end), "{primitive:?}");
            }
        }
        // Infinite planes are never missed.
        assert!(missed > 500 || kind == 1, "kind {kind}: {missed}");
    }
}

#[test]
fn every_hit_lies_in_the_box_of_its_primitive() {
    for kind in (0..KINDS).filter(|&kind| kind != 1) {
        let mut random = Random::new(300 + u64::from(kind));
        let mut hits = 0;
        for _ in 0..4000 {
            let primitive = random_primitive(&mut random, kind);
            let ray = Ray::new(random.point(4.0), random.direction());
            let hit = primitive.first_hit(&ray, Start::Elsewhere);
            let Some(Aabb { lo, hi }) = primitive.bounds() else { panic!("{primitive:?} has no box") };
            if hit.found {
                hits += 1;
                let p = ray.at(hit.t);
                let inside = |axis: usize| lo[axis] - 1e-7 <= p[axis] && p[axis] <= hi[axis] + 1e-7;
                assert!((0..3).all(inside), "{p:?} of {primitive:?} along {ray:?}");
            }
            let hull = Aabb::of_points(&primitive.hull());
            assert!((0..3).all(|axis| hull.lo[axis] <= lo[axis] && hi[axis] <= hull.hi[axis]));
        }
        assert!(hits > 30, "kind {kind}: {hits} hits");
    }
}
