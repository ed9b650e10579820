//! Is everything kept that is promised of scenes at the limits of what can be computed?

use std::collections::BTreeMap;
use std::path::PathBuf;

use anyhow::{Context, Result, ensure};
use brt_formats::write_toml;
use brt_geometry::SimdLevel;
use brt_image::Transfer;
use brt_render::{Accelerator, CertifiedSettings};
use brt_scene::Scene;
use brt_testkit::{Choices, HardKind, Random, Trial, broken_promise, hard_bytes, hard_scene};

/// Tries hard scenes of some kinds until so many pixels were rendered. Each has a seed of its own, from `seed` on.
pub(crate) fn run(kinds: &[HardKind], pixels: u64, seed: u64) -> Result<()> {
    let mut broken: BTreeMap<String, u64> = BTreeMap::new();
    let (mut seen, mut scenes) = (0, 0);
    for seed in seed.. {
        if seen >= pixels {
            break;
        }
        let mut random = Random::new(seed);
        let kind = random.pick(kinds);
        let trial = any_trial(&mut random);
        let Some(scene) = hard_scene(kind, &mut Choices::new(&hard_bytes(&mut random))) else { continue };
        seen += u64::from(trial.size[0] * trial.size[1]);
        scenes += 1;
        // Before it is rendered, in case that does not end.
        let path = keep(scene.clone(), &trial, kind, seed)?;
        if let Some(report) = broken_promise(&scene, &trial) {
            let (what, _) = report.split_once('\n').unwrap_or((&report, ""));
            println!(
                "{} seed {seed} {:?} {}: {what}; {}",
                kind.name(),
                trial.accelerator,
                trial.simd,
                path.display()
            );
            let (method, _) = what.split_once(':').unwrap_or((what, ""));
            *broken.entry(format!("{}, {method}", kind.name())).or_default() += 1;
        } else {
            std::fs::remove_file(&path)?;
        }
    }
    println!("{seen} pixels of {scenes} scenes");
    broken.iter().for_each(|(what, count)| println!("broken: {count} × {what}"));
    ensure!(broken.is_empty(), "the promise is broken");
    Ok(())
}

fn any_trial(random: &mut Random) -> Trial {
    let transfer = random.pick(&[Transfer::Linear, Transfer::Srgb]);
    let tolerance = random.pick(&[1.0, 1.0, 0.25, 3.0]);
    Trial {
        size: [8 + random.below(64), 8 + random.below(48)],
        accelerator: random.pick(&Accelerator::ALL),
        simd: random.pick(&SimdLevel::ALL),
        certified: CertifiedSettings { tolerance },
        transfer,
    }
}

/// Writes the scene into the folder of those that broke, for a closer look.
fn keep(scene: Scene, trial: &Trial, kind: HardKind, seed: u64) -> Result<PathBuf> {
    let folder = std::env::temp_dir().join("certify-failed");
    std::fs::create_dir_all(&folder)?;
    let path = folder.join(format!("{}-{seed}.toml", kind.name()));
    let text = write_toml(&Scene { size: Some(trial.size), ..scene });
    std::fs::write(&path, text).with_context(|| format!("cannot write {}", path.display()))?;
    Ok(path)
}
