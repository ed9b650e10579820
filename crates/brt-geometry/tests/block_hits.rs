//! What a whole block of rays hits, by Taylor models, holds for each of its rays.

use brt_geometry::{
    Aabb, Cone, Cylinder, Disc, Mask, Plane, Polygon, Primitive, Ray, Real, Sphere, Start, Taylor, Triangle,
    Vec3,
};
use brt_testkit::Random;

fn random_primitive(random: &mut Random, kind: u32) -> Primitive {
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
                base + (u * angle.cos() + v * angle.sin()) * height
            };
            let corners = (0..count).map(corner).collect();
            Primitive::Polygon(Polygon { plane: Plane::through(base, axis), corners })
        }
        4 => Primitive::Disc(Disc::new(base, axis, height)),
        5 => Primitive::Cylinder(Cylinder { base, axis, height, radius: random.magnitude(-1.5, 0.3) }),
        _ => {
            let (base_radius, top_radius) = (random.between(0.0, 1.5), random.between(0.0, 1.5));
            let top_radius = if random.one_in(3) { 0.0 } else { top_radius };
            Primitive::Cone(Cone {
                base,
                axis,
                height,
                base_radius,
                slope: (top_radius - base_radius) / height,
            })
        }
    }
}

const KINDS: u32 = 7;

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
