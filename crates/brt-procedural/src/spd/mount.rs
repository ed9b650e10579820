//! A fractal mountain with a pyramid of four glass balls before it.

use brt_geometry::{Vec3, vec3};
use brt_scene::{Scene, Shape};

use super::{NO_SHINE, fill, glass, polygon, start};
use crate::random::Random;

/// The generator's seed; another one makes another mountain.
const MOUNTAIN: u64 = 21;
/// Fractal dimension of the surface, between 2 and 3.
const DIMENSION: f64 = 2.2;

/// 2^`depth` squares along each side, two triangles each.
pub(crate) fn build(depth: u32) -> Scene {
    let mut scene =
        start(vec3(-1.6, 1.6, 1.7), Vec3::ZERO, vec3(0.0, 0.0, 1.0), &[vec3(-100.0, -100.0, 100.0)]);
    let crystal = fill("crystal", [1.0, 1.0, 1.0], 0.1, 0.1, 101.148);
    let crystal = scene.add_material(glass(crystal, 0.9, 1.5));
    for center in pyramid(vec3(-0.8, 0.8, 1.0), BALL) {
        scene.add(Shape::Sphere { center, radius: BALL }, crystal);
    }
    let rock = scene.add_material(fill("rock", [0.5, 0.45, 0.35], 1.0, 0.0, NO_SHINE));
    let width = 1usize << depth;
    let heights = heights(width);
    let at = |x: usize, y: usize| {
        let place = |i: usize| 2.0 * i as f64 / width as f64 - 1.0;
        vec3(place(x), place(y), heights[y * (width + 1) + x])
    };
    for y in 0..width {
        for x in 0..width {
            let [a, b, c, d] = [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)];
            scene.add(polygon([a, b, c]), rock);
            scene.add(polygon([c, d, a]), rock);
        }
    }
    scene
}

const BALL: f64 = 0.17;

/// Centres of four touching balls: one above three, their tetrahedron around `center`.
fn pyramid(center: Vec3, radius: f64) -> [Vec3; 4] {
    let reach = radius * libm::sqrt(1.5);
    let below = |degrees: f64| {
        let angle = degrees.to_radians();
        // Corners of a regular tetrahedron: a third of the reach below its centre.
        let across = reach * libm::sqrt(8.0) / 3.0;
        center + vec3(libm::cos(angle) * across, libm::sin(angle) * across, -reach / 3.0)
    };
    [center + vec3(0.0, 0.0, reach), below(-45.0), below(75.0), below(195.0)]
}

/// Heights of the grid's corners by random displacement of midpoints (Fournier, Fussell, Carpenter 1982), finer and
/// finer: each displacement is proportional to the side of the square that it halves.
fn heights(width: usize) -> Vec<f64> {
    let row = width + 1;
    let mut heights = vec![0.0; row * row];
    // A step that halves the side changes the area by the factor that the dimension asks for.
    let ratio = libm::pow(2.0, 1.0 - 1.0 / (DIMENSION - 1.0));
    let roughness = libm::sqrt(ratio * ratio - 1.0);
    let mut half = width / 2;
    while half > 0 {
        let rise = 2.0 * half as f64 / width as f64 * roughness;
        let corners = |heights: &[f64], points: &[(usize, usize)]| {
            points.iter().map(|&(x, y)| heights[y * row + x]).sum::<f64>() / points.len() as f64
        };
        for y in (0..row).step_by(half) {
            for x in (0..row).step_by(half) {
                let (odd_x, odd_y) = (x / half % 2 == 1, y / half % 2 == 1);
                let (mean, rise) = match (odd_x, odd_y) {
                    (false, false) => continue,
                    (true, false) => (corners(&heights, &[(x - half, y), (x + half, y)]), rise),
                    (false, true) => (corners(&heights, &[(x, y - half), (x, y + half)]), rise),
                    (true, true) => {
                        let (l, r, b, t) = (x - half, x + half, y - half, y + half);
                        (corners(&heights, &[(l, b), (r, b), (r, t), (l, t)]), rise * libm::sqrt(2.0))
                    }
                };
                heights[y * row + x] = mean + rise * displacement(x, y, width);
            }
        }
        half /= 2;
    }
    heights
}

/// Depends only on the place as a share of the mountain, so that finer mountains refine coarser ones.
fn displacement(x: usize, y: usize, width: usize) -> f64 {
    let fine = (1u64 << 32) / width as u64;
    let mut random = Random::new(MOUNTAIN + x as u64 * fine + (y as u64 * fine).rotate_left(31));
    // The first number of neighbouring seeds is already well mixed; a normal one takes the first twelve.
    random.normal()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn balls_stand_where_the_database_has_them() {
        // Printed with six digits by the original.
        let printed = [
            vec3(-0.8, 0.8, 1.20821),
            vec3(-0.661196, 0.661196, 0.930598),
            vec3(-0.749194, 0.98961, 0.930598),
            vec3(-0.98961, 0.749194, 0.930598),
        ];
        for (ball, printed) in pyramid(vec3(-0.8, 0.8, 1.0), BALL).into_iter().zip(printed) {
            assert!((ball - printed).length() < 1e-5, "{ball:?}");
        }
    }

    #[test]
    fn finer_mountains_refine_coarser_ones() {
        let (coarse, fine) = (heights(8), heights(16));
        for y in 0..9 {
            for x in 0..9 {
                assert_eq!(coarse[y * 9 + x], fine[2 * y * 17 + 2 * x]);
            }
        }
    }

    #[test]
    fn counts_are_those_of_the_database() {
        assert_eq!(build(4).objects.len(), 4 + 512);
    }
}
