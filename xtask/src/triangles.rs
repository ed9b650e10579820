//! Triangles, rays and lights of a scene as a file that `bench/embree` reads.

use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::Path;

use anyhow::{Context, Result, bail, ensure};
use brt_geometry::Vec3;
use brt_render::{PreparedCamera, SampleGrid, Samples};
use brt_scene::{Light, Projection, Scene, Shape};

use crate::scenes::open_sized;

type Point = [f64; 3];

/// Half the side of the square that stands for an endless horizontal plane, in scene units.
const PLANE: f64 = 100.0;

/// Little endian: side of the picture, number of lights, number of triangles (`u32`); then `f32`: the eye, the direction of
/// the ray of the upper left pixel, what a column and what a row adds to it, lights, corners.
pub(crate) fn run(name: &str, size: Option<u32>, side: u32, path: &Path) -> Result<()> {
    let scene = open_sized(name, size)?;
    let lights = lights(&scene)?;
    let triangles = triangles(&scene)?;
    let write = || -> std::io::Result<()> {
        let mut file = BufWriter::new(File::create(path)?);
        for count in [side, lights.len() as u32, triangles.len() as u32] {
            file.write_all(&count.to_le_bytes())?;
        }
        let points = rays(&scene, side).into_iter().chain(lights).chain(triangles.iter().flatten().copied());
        for value in points.flatten() {
            file.write_all(&(value as f32).to_le_bytes())?;
        }
        file.flush()
    };
    ensure!(matches!(scene.camera.projection, Projection::Perspective { .. }), "{name} has no eye");
    write().with_context(|| format!("cannot write {}", path.display()))?;
    println!("{name}: {} triangles", triangles.len());
    Ok(())
}

fn rays(scene: &Scene, side: u32) -> [Point; 4] {
    let grid = SampleGrid::new([side; 2], Samples::One);
    let camera = PreparedCamera::new(&scene.camera, Vec3::ZERO, &grid);
    let direction = |x: f64, y: f64| camera.ray(x, y).direction;
    let first = direction(0.0, 0.0);
    [scene.camera.eye, first, direction(1.0, 0.0) - first, direction(0.0, 1.0) - first]
        .map(|v| [v.x, v.y, v.z])
}

fn lights(scene: &Scene) -> Result<Vec<Point>> {
    let position = |light: &Light| match light {
        Light::Point { position: p, .. } => Ok([p.x, p.y, p.z]),
        _ => bail!("only points of light can be written"),
    };
    scene.lights.iter().map(position).collect()
}

fn triangles(scene: &Scene) -> Result<Vec<[Point; 3]>> {
    let mut triangles = Vec::new();
    for object in &scene.objects {
        match &object.shape {
            Shape::Mesh(mesh) => {
                let mesh = mesh.placed(&object.transform);
                let corner = |i: u32| mesh.positions[i as usize];
                triangles.extend(
                    mesh.triangles.iter().map(|t| t.map(|i| [corner(i).x, corner(i).y, corner(i).z])),
                );
            }
            Shape::Plane { normal, distance } if normal.x == 0.0 && normal.z == 0.0 => {
                let at = |x: f64, z: f64| [x * PLANE, distance / normal.y, z * PLANE];
                let [a, b, c, d] = [at(-1.0, -1.0), at(-1.0, 1.0), at(1.0, 1.0), at(1.0, -1.0)];
                triangles.extend([[a, b, c], [a, c, d]]);
            }
            other => bail!("a {} is not made of triangles", other.kind()),
        }
    }
    Ok(triangles)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_has_what_its_numbers_say() {
        let folder = std::env::temp_dir().join(format!("triangles-{}", std::process::id()));
        run("torus", Some(100), 64, &folder).unwrap();
        let bytes = std::fs::read(&folder).unwrap();
        std::fs::remove_file(&folder).unwrap();
        let number = |i: usize| u32::from_le_bytes(bytes[4 * i..4 * i + 4].try_into().unwrap()) as usize;
        assert_eq!((number(0), number(1)), (64, 2));
        assert_eq!(bytes.len(), 4 * (3 + 3 * (4 + number(1) + 3 * number(2))));
        assert!(run("blocks", None, 64, &folder).is_err());
    }
}
