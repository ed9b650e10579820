//! Matte boxes on a floor: about two thousand planar faces, no mirrors.

use brt_geometry::{Vec3, vec3};
use brt_image::rgb;
use brt_scene::{Camera, Light, Material, MaterialId, Projection, Scene, Shape};

use super::random::Random;

const COLORS: [(&str, [f64; 3]); 6] = [
    ("brick", [0.75, 0.28, 0.2]),
    ("sand", [0.85, 0.7, 0.45]),
    ("leaf", [0.35, 0.6, 0.3]),
    ("sky", [0.3, 0.5, 0.8]),
    ("plum", [0.5, 0.3, 0.55]),
    ("chalk", [0.85, 0.85, 0.82]),
];

/// `count` boxes on a square grid with turned, jittered footprints that do not touch.
pub(super) fn build(count: u32) -> Scene {
    let side = libm::ceil(libm::sqrt(f64::from(count))) as u32;
    let half = f64::from(side) / 2.0;
    let mut scene = Scene::new(Camera {
        eye: vec3(0.28, 0.5, 0.8) * f64::from(side),
        look_at: vec3(0.0, 0.0, 0.1) * f64::from(side),
        up: vec3(0.0, 1.0, 0.0),
        projection: Projection::Perspective { fov_deg: 46.0 },
    });
    scene.size = Some([1024, 1024]);
    scene.background = rgb(0.05, 0.07, 0.1);
    for (position, color) in
        [(vec3(-0.9, 1.1, 0.6), rgb(0.55, 0.52, 0.45)), (vec3(0.7, 1.5, 0.9), rgb(0.35, 0.4, 0.45))]
    {
        scene.lights.push(Light::Point { position: position * f64::from(side), color });
    }
    let floor = scene.add_material(Material::matte("floor", rgb(0.6, 0.6, 0.58)));
    let used = COLORS.len().min(count as usize);
    let colors: Vec<MaterialId> = COLORS[..used]
        .iter()
        .map(|&(name, [r, g, b])| scene.add_material(Material::matte(name, rgb(r, g, b))))
        .collect();
    let edge = half + 1.0;
    let corner = |x: f64, z: f64| vec3(x * edge, 0.0, z * edge);
    let outline = vec![corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0), corner(-1.0, -1.0)];
    scene.add(Shape::Polygon { outline, holes: Vec::new() }, floor);

    let mut random = Random::new(1987);
    for i in 0..count {
        let cell = vec3(f64::from(i % side) + 0.5 - half, 0.0, f64::from(i / side) + 0.5 - half);
        for outline in block(cell, &mut random) {
            scene.add(Shape::Polygon { outline, holes: Vec::new() }, colors[i as usize % used]);
        }
    }
    scene
}

/// The six faces of a box that stands in the unit cell around `cell`, counter-clockwise seen from outside.
fn block(cell: Vec3, random: &mut Random) -> [Vec<Vec3>; 6] {
    let (wide, deep) = (random.between(0.15, 0.32), random.between(0.15, 0.32));
    let tall = random.between(0.15, 1.6);
    let turn = random.between(0.0, core::f64::consts::FRAC_PI_2);
    // Even when turned, a footprint of half-diagonal 0.46 stays inside its cell after this jitter.
    let shift = vec3(random.between(-0.04, 0.04), 0.0, random.between(-0.04, 0.04));
    let (sin, cos) = (libm::sin(turn), libm::cos(turn));
    let at = |x: f64, up: f64, z: f64| {
        let (x, z) = (x * wide, z * deep);
        cell + shift + vec3(cos * x + sin * z, up * tall, cos * z - sin * x)
    };
    let [a, b, c, d] = [at(-1.0, 0.0, 1.0), at(1.0, 0.0, 1.0), at(1.0, 0.0, -1.0), at(-1.0, 0.0, -1.0)];
    let [e, f, g, h] = [at(-1.0, 1.0, 1.0), at(1.0, 1.0, 1.0), at(1.0, 1.0, -1.0), at(-1.0, 1.0, -1.0)];
    [
        vec![e, f, g, h],
        vec![a, b, f, e],
        vec![b, c, g, f],
        vec![c, d, h, g],
        vec![d, a, e, h],
        vec![d, c, b, a],
    ]
}

#[cfg(test)]
mod tests {
    use brt_geometry::polygon_plane;

    use super::*;

    #[test]
    fn default_has_the_faces_of_333_boxes_and_a_floor() {
        assert_eq!(build(333).objects.len(), 333 * 6 + 1);
    }

    #[test]
    fn faces_look_outwards() {
        let cell = vec3(3.0, 0.0, -2.0);
        let faces = block(cell, &mut Random::new(7));
        let points: Vec<Vec3> = faces.iter().flatten().copied().collect();
        let middle = points.iter().fold(Vec3::ZERO, |sum, &p| sum + p * (1.0 / 24.0));
        for face in &faces {
            let plane = polygon_plane(face).unwrap();
            assert!(plane.normal.dot(plane.center - middle) > 0.0);
        }
        assert!(points.iter().all(|p| (p.x - cell.x).abs() < 0.5 && (p.z - cell.z).abs() < 0.5));
    }
}
