//! A walk through the tree visits everything that a ray touches.

use brt_geometry::{
    Aabb, Bvh, FARTHEST, Primitive, Ray, Shaft, Sphere, Start, Taylor, Traversal, Triangle, Vec3, vec3,
};
use brt_testkit::Random;

/// Items visited by walks of both kinds that never stop early.
fn visited(tree: &Bvh, ray: &Ray, t_max: f64) -> Vec<u32> {
    let mut walk = Traversal::default();
    let (mut closest, mut any) = (Vec::new(), Vec::new());
    tree.closest(ray, t_max, &mut walk, |item| {
        closest.push(item);
        t_max
    });
    let stopped = tree.any(ray, t_max, &mut walk, |item| {
        any.push(item);
        false
    });
    assert!(!stopped);
    closest.sort_unstable();
    any.sort_unstable();
    assert_eq!(closest, any, "both walks visit the same");
    assert!(any.windows(2).all(|pair| pair[0] < pair[1]), "nothing is visited twice");
    any
}

fn random_box(random: &mut Random, size: f64) -> Aabb {
    let (a, mut b) = (random.point(1.0), random.point(1.0));
    if random.one_in(3) {
        b = a + (b - a) * random.magnitude(-6.0, 0.0);
    }
    // Flat boxes and boxes that are points.
    (0..3).filter(|_| random.one_in(5)).collect::<Vec<_>>().into_iter().for_each(|axis| b[axis] = a[axis]);
    Aabb::of_points(&[a * size, b * size])
}

/// A point of a box, often on its faces, edges and corners.
fn point_in(random: &mut Random, bounds: &Aabb) -> Vec3 {
    let mut point = bounds.lo;
    for axis in 0..3 {
        let share = if random.one_in(2) { f64::from(random.below(2)) } else { random.unit() };
        point[axis] = (bounds.lo[axis] + (bounds.hi[axis] - bounds.lo[axis]) * share).min(bounds.hi[axis]);
    }
    point
}

/// A ray through a point: from anywhere, near or far, along an axis, in a plane along two axes, or starting there.
fn ray_through(random: &mut Random, point: Vec3, size: f64) -> (Ray, f64) {
    // From far away the tree's f32 sees the origin itself only roughly.
    let distance = random.pick(&[3.0, 3.0, 3e3, 3e5]);
    let mut origin = random.point(distance) * size;
    (0..random.below(4)).for_each(|_| {
        let axis = random.below(3) as usize;
        origin[axis] = point[axis];
    });
    let direction = point - origin;
    // Subtracting may round; the point that the ray meets is off by less than any margin.
    if direction.length() == 0.0 {
        return (Ray::new(point, random.direction() * random.magnitude(-20.0, 20.0)), 0.0);
    }
    let length = if random.one_in(2) { random.magnitude(-20.0, 20.0) } else { 1.0 };
    let mut scaled = direction * length;
    (0..3).for_each(|axis| {
        if scaled[axis] == 0.0 {
            scaled[axis] = random.zero();
        }
    });
    (Ray::new(origin, scaled), 1.0 / length)
}

fn check_boxes(random: &mut Random, count: u32, size: f64, offset: Vec3) {
    let boxes: Vec<(u32, Aabb)> = (0..count)
        .map(|i| {
            let b = random_box(random, size);
            (7 * i, Aabb { lo: b.lo + offset, hi: b.hi + offset })
        })
        .collect();
    let tree = Bvh::build(&boxes, 1);
    for _ in 0..60 {
        let (item, bounds) = boxes[random.below(count) as usize];
        let target = point_in(random, &bounds);
        let (local, t) = ray_through(random, target - offset, size);
        let ray = Ray::new(local.origin + offset, local.direction);
        for t_max in [f64::INFINITY, FARTHEST, t * (1.0 + 1e-9) + f64::MIN_POSITIVE] {
            let seen = visited(&tree, &ray, t_max);
            assert!(seen.contains(&item), "{bounds:?} is missed by {ray:?} up to {t_max}");
        }
    }
}

#[test]
fn every_box_that_a_ray_touches_is_visited() {
    let mut random = Random::new(11);
    for case in 0..400 {
        let count = [1, 2, 3, 5, 20, 200][case % 6];
        let size = random.pick(&[1.0, 1.0, 1e6, 1e-6, 1e20, 1e-20]);
        check_boxes(&mut random, count, size, Vec3::ZERO);
    }
}

#[test]
fn nothing_is_missed_a_million_units_from_the_origin() {
    let mut random = Random::new(12);
    for _ in 0..100 {
        check_boxes(&mut random, 60, 1.0, vec3(1e6, -1e6, 1e6));
    }
}

#[test]
fn rays_from_the_faces_of_a_box_and_along_them_touch_it() {
    let bounds = Aabb { lo: vec3(-1.0, -2.0, -3.0), hi: vec3(1.0, 2.0, 3.0) };
    let tree = Bvh::build(&[(5, bounds)], 4);
    for corner in bounds.corners() {
        for axis in 0..3 {
            for (sign, zero) in [(1.0, 0.0), (1.0, -0.0), (-1.0, 0.0), (-1.0, -0.0)] {
                let mut direction = Vec3::splat(zero);
                direction[axis] = sign;
                assert_eq!(
                    visited(&tree, &Ray::new(corner, direction), f64::INFINITY),
                    [5],
                    "{corner:?} {direction:?}"
                );
                let away = Ray::new(corner - direction * 10.0, direction);
                assert_eq!(visited(&tree, &away, f64::INFINITY), [5]);
                let miss = Ray::new(corner * 1.001 - direction * 10.0, direction);
                assert_eq!(visited(&tree, &miss, f64::INFINITY), [0_u32; 0], "{corner:?} {direction:?}");
            }
        }
    }
}

#[test]
fn a_tree_of_no_box_visits_nothing_and_one_of_a_speck_its_speck() {
    let ray = Ray::new(Vec3::ZERO, vec3(0.0, 0.0, 1.0));
    assert_eq!(visited(&Bvh::build(&[], 4), &ray, f64::INFINITY), [0_u32; 0]);
    // A point alone has no size that margins could be a share of; no primitive has such a box.
    let speck = Aabb::around(vec3(0.0, 0.0, 4.0), Vec3::splat(1e-20));
    assert_eq!(visited(&Bvh::build(&[(3, speck)], 1), &ray, f64::INFINITY), [3]);
    assert_eq!(visited(&Bvh::build(&[(3, speck)], 1), &ray, 3.9), [0_u32; 0]);
}

#[test]
fn thousands_of_boxes_in_one_place_are_all_visited() {
    let bounds = Aabb { lo: Vec3::splat(-1.0), hi: Vec3::splat(1.0) };
    for count in [2, 5, 4096, 5000] {
        let boxes: Vec<(u32, Aabb)> = (0..count).map(|i| (i, bounds)).collect();
        let ray = Ray::new(vec3(0.3, 0.2, 5.0), vec3(0.0, 0.0, -1.0));
        assert_eq!(visited(&Bvh::build(&boxes, 4), &ray, f64::INFINITY), (0..count).collect::<Vec<u32>>());
    }
}

/// Boxes that lie in each other, or shrink from one to the next, have no neighbours that choose each other.
#[test]
fn building_takes_time_in_proportion_to_the_number_of_boxes() {
    let around = |center: Vec3, half: f64| Aabb::around(center, Vec3::splat(half));
    type BoxAt = fn(f64) -> Aabb;
    let kinds: [(&str, BoxAt); 5] = [
        ("a row", |share| Aabb::around(vec3(share, 0.0, 0.0), Vec3::splat(1e-6))),
        ("nested", |share| Aabb::around(Vec3::ZERO, Vec3::splat(share))),
        ("from one corner", |share| Aabb::of_points(&[Vec3::ZERO, Vec3::splat(share)])),
        ("flat and nested", |share| Aabb::of_points(&[vec3(0.0, 0.0, 0.0), vec3(share, 1.0, 0.5)])),
        ("shrinking", |share| {
            let size = libm::exp(-30.0 * share);
            Aabb::of_points(&[vec3(0.0, 0.0, size), vec3(size, size, size)])
        }),
    ];
    for (name, boxes) in kinds {
        let seconds = |count: u32| {
            let share = |i: u32| f64::from(i + 1) / f64::from(count);
            let boxes: Vec<(u32, Aabb)> = (0..count).map(|i| (i, boxes(share(i)))).collect();
            let begin = std::time::Instant::now();
            let tree = Bvh::build(&boxes, 4);
            let seconds = begin.elapsed().as_secs_f64();
            // Something to find, at least.
            let ray = Ray::new(vec3(-1.0, 1e-7, 1e-7), vec3(1.0, 0.0, 0.0));
            assert!(name == "shrinking" || !visited(&tree, &ray, FARTHEST).is_empty(), "{name}");
            seconds
        };
        // 16 times as many: 256 times as long if each is compared with all.
        let [few, many] = [seconds(4_000), seconds(64_000)];
        assert!(many < 80.0 * few.max(0.003), "{name}: {few} and {many} s");
    }
    // Sizes at which a tree is as deep as it has boxes, but small enough to be optimized.
    for count in [150, 250, 400, 900] {
        let nested: Vec<(u32, Aabb)> =
            (0..count).map(|i| (i, around(Vec3::ZERO, libm::pow(0.9, f64::from(i))))).collect();
        assert_eq!(
            visited(&Bvh::build(&nested, 1), &Ray::new(vec3(3.0, 0.0, 0.0), vec3(-1.0, 0.0, 0.0)), FARTHEST)
                .len(),
            count as usize
        );
    }
}

fn random_primitive(random: &mut Random, size: f64, offset: Vec3) -> Primitive {
    let center = random.point(1.0) * size + offset;
    if random.one_in(2) {
        return Primitive::Sphere(Sphere { center, radius: size * random.magnitude(-4.0, -0.5) });
    }
    loop {
        let corners = [center, center + random.point(0.4) * size, center + random.point(0.4) * size];
        if let Some(triangle) = Triangle::new(corners) {
            return Primitive::Triangle(triangle);
        }
    }
}

/// Nearest hit by testing everything, or what a walk leaves to be tested; and number of tests.
fn nearest(primitives: &[Primitive], ray: &Ray, tree: Option<&Bvh>, walk: &mut Traversal) -> (f64, u64) {
    let (mut best, mut tests) = (f64::INFINITY, 0);
    let mut test = |item: u32| {
        tests += 1;
        let hit = primitives[item as usize].first_hit(ray, Start::Elsewhere);
        if hit.found && hit.t < best {
            best = hit.t;
        }
        best
    };
    match tree {
        Some(tree) => tree.closest(ray, f64::INFINITY, walk, test),
        None => (0..primitives.len() as u32).for_each(|item| {
            test(item);
        }),
    }
    (best, tests)
}

#[test]
fn the_closest_hit_is_that_of_brute_force_with_far_fewer_tests() {
    let mut random = Random::new(13);
    for (size, offset) in [(1.0, 0.0), (1e6, 0.0), (1e-6, 0.0), (1.0, 1e6), (1e3, -1e6)] {
        let offset = vec3(offset, 0.5 * offset, -offset);
        let primitives: Vec<Primitive> =
            (0..1000).map(|_| random_primitive(&mut random, size, offset)).collect();
        let boxes: Vec<(u32, Aabb)> =
            (0..).zip(&primitives).filter_map(|(i, p)| Some((i, p.bounds()?))).collect();
        let tree = Bvh::build(&boxes, 4);
        let mut walk = Traversal::default();
        let (mut hits, mut tests, rays) = (0, 0, 2000);
        for _ in 0..rays {
            let origin = random.point(2.0) * size + offset;
            let direction = random.direction() * random.magnitude(-20.0, 20.0);
            let ray = Ray::new(origin, direction);
            let (by_tree, tested) = nearest(&primitives, &ray, Some(&tree), &mut walk);
            let (by_force, _) = nearest(&primitives, &ray, None, &mut walk);
            assert_eq!(by_tree.to_bits(), by_force.to_bits(), "{ray:?}");
            let any = |t_max: f64, walk: &mut Traversal| {
                tree.any(&ray, t_max, walk, |item| {
                    let hit = primitives[item as usize].first_hit(&ray, Start::Elsewhere);
                    hit.found && hit.t < t_max
                })
            };
            assert_eq!(any(f64::INFINITY, &mut walk), by_force.is_finite());
            assert!(!any(by_force, &mut walk), "nothing is nearer than the nearest");
            hits += u32::from(by_force.is_finite());
            tests += tested;
        }
        assert!(hits > rays / 5, "{hits} hits");
        assert!(tests < u64::from(rays) * 60, "{tests} tests by the tree");
    }
}

#[test]
fn whatever_rays_of_a_shaft_touch_is_found_by_the_shaft() {
    let mut random = Random::new(77);
    let (mut touched, mut found) = (0, 0);
    for _ in 0..300 {
        let size = random.magnitude(-6.0, 6.0);
        let boxes: Vec<(u32, Aabb)> = (0..60).map(|i| (i, random_box(&mut random, size))).collect();
        let tree = Bvh::build(&boxes, 4);
        let (origin, target) = (random.point(2.0) * size, random.point(1.0) * size);
        let (right, down) = (target - origin).try_normalize().unwrap_or_default().tangents();
        let step = size * random.magnitude(-3.0, 0.0);
        let direction = |x: f64, y: f64| target - origin + right * (x * step) + down * (y * step);
        let model = (target - origin).lift::<Taylor>()
            + right.lift() * Taylor::linear(0.0, step, 0.0)
            + down.lift() * Taylor::linear(0.0, 0.0, step);
        let Some(shaft) = Shaft::around(&origin.lift(), &model, f64::INFINITY) else { continue };
        let mut items = Vec::new();
        assert!(tree.touched_by(&shaft, |item| {
            items.push(item);
            true
        }));
        found += items.len();
        for (x, y) in (-2..=2).flat_map(|x| (-2..=2).map(move |y| (0.5 * f64::from(x), 0.5 * f64::from(y)))) {
            let ray = Ray::new(origin, direction(x, y));
            for (item, bounds) in &boxes {
                let point = bounds.lo + (bounds.hi - bounds.lo) * random.unit();
                let t = (point - origin).dot(ray.direction) / ray.dd;
                let on_ray = ray.at(t);
                let is_inside =
                    |axis: usize| bounds.lo[axis] <= on_ray[axis] && on_ray[axis] <= bounds.hi[axis];
                if t > 0.0 && (0..3).all(is_inside) {
                    touched += 1;
                    assert!(items.contains(item), "{bounds:?} {ray:?}");
                }
            }
        }
    }
    assert!(touched > 1000 && found < 300 * 45, "{touched} {found}");
}
