//! Does every certified pixel keep its promise?

use anyhow::{Result, ensure};
use brt_formats::write_toml;
use brt_image::Transfer;
use brt_procedural as procedural;
use brt_render::{CertifiedSettings, Method, Settings};
use brt_scene::{Camera, Projection, Scene};
use brt_testkit::{Random, scaled};

use crate::scenes::{SEED, open, render_stored, render_whole};

/// Sizes of the matrix.
const SIZES: [[u32; 2]; 3] = [[512, 512], [1000, 777], [2048, 2048]];

/// Checked in each size, besides tolerance 0.
const TOLERANCES: [f64; 2] = [1.0, 0.25];

/// What was found wrong, and how much was looked at.
#[derive(Default)]
struct Tally {
    pixels: u64,
    above: u64,
}

/// Scenes by name: the seed scenes and all procedural ones, or those given.
fn names(given: &[String]) -> Vec<String> {
    let all = SEED.into_iter().chain(procedural::ALL.iter().map(|p| p.name)).map(String::from);
    if given.is_empty() { all.collect() } else { given.to_vec() }
}

/// Every scene in all sizes, tolerances and transfer functions.
pub(crate) fn matrix(given: &[String], most_side: u32) -> Result<()> {
    let mut tally = Tally::default();
    for name in names(given) {
        let scene = open(&name)?;
        for size in SIZES.into_iter().filter(|size| size[0] <= most_side) {
            let mut check = Check::of(&scene, size)?;
            for transfer in [Transfer::Linear, Transfer::Srgb] {
                for tolerance in TOLERANCES {
                    check.keeps(tolerance, transfer, &name, &mut tally)?;
                }
            }
            check.keeps(0.0, Transfer::Srgb, &name, &mut tally)?;
        }
    }
    end(&tally)
}

/// Random views of the scenes until so many pixels are checked.
pub(crate) fn views(given: &[String], pixels: u64, seed: u64) -> Result<()> {
    let scenes: Vec<(String, Scene)> =
        names(given).into_iter().map(|name| Ok((name.clone(), open(&name)?))).collect::<Result<_>>()?;
    let mut random = Random::new(seed);
    let mut tally = Tally::default();
    while tally.pixels < pixels {
        let (name, scene) = &scenes[random.below(scenes.len() as u32) as usize];
        let mut scene = scaled(scene, random.magnitude(-6.0, 6.0));
        scene.camera = any_camera(&scene, &mut random);
        if !scene.check().is_empty() {
            continue;
        }
        let size = [64 + random.below(448), 64 + random.below(448)];
        let transfer = random.pick(&[Transfer::Linear, Transfer::Srgb]);
        let tolerance = random.pick(&[0.0, 0.1, 0.25, 1.0, 1.0, 3.0]);
        let view = format!("{name}, {:?}", scene.camera);
        let before = tally.above;
        Check::of(&scene, size)?.keeps(tolerance, transfer, &view, &mut tally)?;
        if tally.above > before {
            let path = std::env::temp_dir().join("certify-failed.toml");
            std::fs::write(&path, write_toml(&Scene { size: Some(size), ..scene }))?;
            println!("that scene is now {}", path.display());
        }
    }
    end(&tally)
}

/// From anywhere in and around a scene to any point in it.
fn any_camera(scene: &Scene, random: &mut Random) -> Camera {
    let [lo, hi] = scene.bounds().unwrap_or([scene.camera.eye, scene.camera.look_at]);
    let (middle, half) = ((lo + hi) * 0.5, (hi - lo).length() * 0.5);
    let far = random.magnitude(-0.5, 0.7);
    Camera {
        eye: middle + random.point(half * far),
        look_at: middle + random.point(half),
        up: random.direction(),
        projection: if random.one_in(8) {
            Projection::Orthographic { extent: half * random.between(0.1, 2.0) }
        } else {
            Projection::Perspective { fov_deg: random.between(5.0, 120.0) }
        },
    }
}

fn end(tally: &Tally) -> Result<()> {
    println!("{} pixels checked, {} above the tolerance", tally.pixels, tally.above);
    ensure!(tally.above == 0, "the promise is broken");
    Ok(())
}

/// A picture by full ray tracing to hold certified ones against.
struct Check<'a> {
    scene: &'a Scene,
    size: [u32; 2],
    full: Vec<[f32; 3]>,
}

impl<'a> Check<'a> {
    fn of(scene: &'a Scene, size: [u32; 2]) -> Result<Self> {
        let (full, ..) = render_whole(scene, &Settings::new(size))?;
        Ok(Self { scene, size, full })
    }

    fn keeps(&mut self, tolerance: f64, transfer: Transfer, name: &str, tally: &mut Tally) -> Result<()> {
        let method = Method::Certified(CertifiedSettings { tolerance });
        let settings = Settings { method, ..Settings::new(self.size) };
        let (colors, _, stats) = render_stored(self.scene, &settings, transfer)?;
        let errors = || colors.iter().zip(&self.full).map(|(a, b)| error(transfer, *a, *b));
        let above = if tolerance == 0.0 {
            colors.iter().zip(&self.full).filter(|(a, b)| a != b).count()
        } else {
            errors().filter(|error| *error > tolerance).count()
        };
        tally.pixels += colors.len() as u64;
        tally.above += above as u64;
        let share = |count: u64| 100.0 * count as f64 / stats.pixels.total as f64;
        println!(
            "{name} {}x{} {transfer:?} tolerance {tolerance}: greatest error {:.3}, {above} above; \
             filled {:.1} %, shaded {:.1} %",
            self.size[0],
            self.size[1],
            errors().fold(0.0, f64::max),
            share(stats.pixels.filled),
            share(stats.pixels.shaded),
        );
        Ok(())
    }
}

/// The greatest difference of any channel in levels of 255 of the stored values.
fn error(transfer: Transfer, a: [f32; 3], b: [f32; 3]) -> f64 {
    if a == b {
        return 0.0;
    }
    let stored = |x: f32| 255.0 * transfer.encode(f64::from(x));
    (0..3).map(|i| (stored(a[i]) - stored(b[i])).abs()).fold(0.0, f64::max)
}
