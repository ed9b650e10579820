//! Local ray tracing (Tadamura, Nakamae, Nishita 1985): surfaces are made visible by scan line, and rays are cast only
//! where mirrors, glass or shadows need them. Paper: P1.
//!
//! How this differs: the original report is not to be had. "Shadows need rays" is read as: something that casts shadows
//! reaches into the space between a light and a run of neighbouring samples on one primitive.

use brt_geometry::{Start, Vec3};

use super::worker::{First, TileWorker};
use crate::products::{NOTHING, PreparedScene, StageClock, Tile};
use crate::tracing::{BoundingSpheres, Interaction, LightsSeen, lights_surely_seen};

/// Runs are short so that the spaces between them and the lights are slim.
const LONGEST_RUN: u32 = 16;

/// Traces all samples of a tile whose perspective image is painted.
pub(crate) fn render_scan_line(
    worker: &mut TileWorker,
    tile: &Tile,
    scene: &PreparedScene,
    spheres: &BoundingSpheres,
) {
    let mut clock = StageClock::start();
    for y in 0..tile.height {
        let mut x = 0;
        while x < tile.width {
            let end = end_of_run(worker, tile, x, y);
            let lights = lights_seen_from(worker, tile, scene, spheres, [x, end], y);
            for column in x..end {
                worker.trace_guided(tile, column, y, First::Shown, LightsSeen(lights));
            }
            x = end;
        }
    }
    worker.lap(&mut clock, |c| &mut c.seconds.trace);
}

/// The first column after `x` that shows another primitive or lies too far.
fn end_of_run(worker: &TileWorker, tile: &Tile, x: u32, y: u32) -> u32 {
    let row = &worker.perspective.primitive[tile.index(0, y)..];
    let last = tile.width.min(x + LONGEST_RUN);
    (x + 1..last).find(|&i| row[i as usize] != row[x as usize]).unwrap_or(last)
}

/// Bits of the lights that nothing can hide from the samples of a run.
fn lights_seen_from(
    worker: &TileWorker,
    tile: &Tile,
    scene: &PreparedScene,
    spheres: &BoundingSpheres,
    [start, end]: [u32; 2],
    y: u32,
) -> u64 {
    let primitive = worker.perspective.primitive[tile.index(start, y)];
    if primitive == NOTHING {
        return 0;
    }
    let here = |x: u32| {
        let ray = worker.camera.sample_ray([tile.x + x, tile.y + y]);
        let t = scene.primitives[primitive as usize].first_hit(&ray, Start::Elsewhere).t;
        let Interaction { point, geometric_normal, .. } = Interaction::at(scene, &ray, primitive, t);
        (point, geometric_normal)
    };
    let points: Vec<(Vec3, Vec3)> = (start..end).map(here).collect();
    lights_surely_seen(scene, spheres, primitive, &points)
}
