//! A cube of meshing gears over a reflecting floor; some are of glass.

use core::f64::consts::PI;

use brt_geometry::{Vec3, vec3};
use brt_scene::{Material, Scene};

use super::{NO_SHINE, fill, glass, polygon, start};

const TEETH: u32 = 36;
/// Radius of the tips, a little less than 1 so that meshing gears do not touch, and of the roots.
const TIP: f64 = 0.995;
const ROOT: f64 = 0.9;

/// `size`³ gears in `size` layers.
pub(crate) fn build(size: u32) -> Scene {
    let lights = [
        vec3(2.0, 4.0, 4.0),
        vec3(-2.0, 4.0, 3.0),
        vec3(2.0, -2.5, 2.5),
        vec3(-1.0, -4.0, 2.0),
        // Just behind the eye.
        vec3(-1.111, -2.121, 2.626),
    ];
    let mut scene = start(vec3(-1.1, -2.1, 2.6), Vec3::ZERO, vec3(0.0, 0.0, 1.0), &lights);
    let floor = scene.add_material(fill("floor", [1.0, 0.85, 0.7], 0.3, 0.6, 3.0827));
    let corner = |x: f64, y: f64| vec3(2.0 * x, 2.0 * y, 0.0);
    scene.add(polygon([corner(1.0, 1.0), corner(-1.0, 1.0), corner(-1.0, -1.0), corner(1.0, -1.0)]), floor);
    let n = f64::from(size);
    // Neighbours stand a tip's and a root's radius apart; a row of them is 2 wide.
    let radius = 1.0 / (n - (n - 1.0) * (1.0 - ROOT) / 2.0);
    let step = radius * (1.0 + ROOT);
    let thickness = (0.5 / n).min(0.1);
    for (z, y, x) in places(size) {
        let [i, j] = [x, y].map(|k| radius - 1.0 + step * f64::from(k));
        let center = vec3(i, j, 1.0 - f64::from(z) / n);
        let half_tooth = f64::from((x + y + z) % 2) * PI / f64::from(TEETH);
        let material = scene.add_material(material(x, y, z));
        for face in gear(center, half_tooth, radius, thickness) {
            scene.add(polygon(face), material);
        }
    }
    scene
}

fn places(size: u32) -> impl Iterator<Item = (u32, u32, u32)> {
    (0..size.pow(3)).map(move |i| (i / (size * size), i / size % size, i % size))
}

/// Colours run through sevenths so that neighbours differ; the strongest channel is 1. Every fifth gear is of glass.
fn material(x: u32, y: u32, z: u32) -> Material {
    let sevenths =
        |a: u32, b: u32, c: u32, factor: u32| 0.01 + f64::from((3 * a + 2 * b + c + 1) * factor % 7) / 7.0;
    let channels = [sevenths(x, y, z, 5), sevenths(y, z, x, 3), sevenths(z, x, y, 2)];
    let strongest = channels.into_iter().fold(0.0, f64::max);
    let color = channels.map(|channel| channel / strongest);
    let name = format!("gear {x} {y} {z}");
    if (4 * x + 2 * y + z).is_multiple_of(5) {
        glass(fill(name, color, 0.2, 0.0, NO_SHINE), 0.8, 1.1)
    } else {
        fill(name, color, 1.0, 0.0, NO_SHINE)
    }
}

/// The upper face at `center`, the sides, the lower face.
fn gear(center: Vec3, turned: f64, radius: f64, thickness: f64) -> Vec<Vec<Vec3>> {
    let tooth = 2.0 * PI / f64::from(TEETH);
    let upper: Vec<Vec3> = (0..TEETH)
        .flat_map(|i| {
            [(-0.19, TIP), (0.19, TIP), (0.3, ROOT), (0.7, ROOT)].map(|(at, r)| (f64::from(i) + at, r))
        })
        .map(|(at, r)| {
            let angle = turned + tooth * at;
            center + vec3(libm::cos(angle), libm::sin(angle), 0.0) * (r * radius)
        })
        .collect();
    let down = vec3(0.0, 0.0, -thickness);
    let sides = (0..upper.len()).map(|i| {
        let (a, b) = (upper[i], upper[(i + 1) % upper.len()]);
        vec![a, a + down, b + down, b]
    });
    let lower = upper.iter().rev().map(|&p| p + down).collect();
    std::iter::once(upper.clone()).chain(sides).chain([lower]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use brt_scene::Shape;

    #[test]
    fn single_gear_is_that_of_the_database() {
        let scene = build(1);
        assert_eq!(scene.objects.len(), 1 + 2 + 144);
        let Shape::Polygon { outline, .. } = &scene.objects[1].shape else { panic!() };
        assert_eq!(outline.len(), 144);
        // Printed with six digits by the original.
        assert!((outline[3] - vec3(0.893292, 0.109682, 1.0)).length() < 2e-6);
        let color = scene.materials[1].color;
        assert!((color.g - 0.605523).abs() < 1e-6 && (color.b - 0.408284).abs() < 1e-6);
    }

    #[test]
    fn gears_fill_the_cube_over_the_floor() {
        let scene = build(2);
        assert!(scene.objects[1..].iter().all(|o| {
            let [lo, hi] = o.shape.bounds().unwrap();
            lo.x >= -1.0 && hi.x <= 1.0 && lo.y >= -1.0 && hi.y <= 1.0 && lo.z > 0.0
        }));
    }
}
