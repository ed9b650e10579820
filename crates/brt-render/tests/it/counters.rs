//! How much work scenes are, exactly: more rays, or less that is proven, are a red test on every machine.
//!
//! The counts stand in `golden/work.txt` and `golden/certificates.txt`, which `UPDATE_GOLDEN=1` writes anew. Tests of
//! primitives and visits of nodes are left out, since they change with every tuning.

use std::fmt::Write as _;
use std::path::Path;

use brt_procedural as procedural;
use brt_render::{
    BorderSettings, Certificate, CertifiedSettings, Method, PixelSelectedSettings, Run, Settings, Stats,
    Tries,
};
use brt_scene::Scene;
use brt_testkit::{Golden, render_to_image, seed_scene};

fn golden() -> Golden {
    Golden::new(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden"))
}

fn scene(name: &str) -> Scene {
    procedural::find(name).map_or_else(|| seed_scene(name), |scene| scene.build(None).unwrap())
}

fn stats(scene: &Scene, method: Method) -> Stats {
    render_to_image(scene, &Settings { method, ..Settings::new([256, 256]) }, &Run::default()).1
}

/// Samples by how they got their colours, and rays, each searching the scene.
fn work(table: &mut String, name: &str, method: &Method, stats: &Stats) {
    let (pixels, rays) = (stats.pixels, stats.rays);
    assert_eq!(pixels.traced + pixels.shaded + pixels.filled, 256 * 256);
    let counts =
        [pixels.traced, pixels.shaded, pixels.filled, rays.camera, rays.shadow, rays.mirror, rays.refracted];
    let counts = counts.map(|count| format!("{count:>10}")).concat();
    writeln!(table, "{name:10} {:14}{counts}", method.name()).unwrap();
}

/// Each method's default settings on the seed scenes, `certified` on others, too.
#[test]
fn scenes_cost_what_they_did() {
    let certified = Method::Certified(CertifiedSettings::default());
    let methods = [
        Method::Full,
        Method::PixelSelected(PixelSelectedSettings::default()),
        Method::Border(BorderSettings::default()),
    ];
    let mut table = format!(
        "{:10} {:14}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}\n",
        "scene", "method", "traced", "shaded", "filled", "camera", "shadow", "mirror", "refracted"
    );
    for name in ["a", "b", "c"] {
        let scene = scene(name);
        methods.iter().for_each(|method| work(&mut table, name, method, &stats(&scene, *method)));
    }
    let mut proofs = format!("{:10} {:12}{:>9}{:>9}\n", "scene", "certificate", "tried", "proven");
    for name in ["a", "b", "c", "blocks", "torus", "adversary"] {
        let stats = stats(&scene(name), certified);
        work(&mut table, name, &certified, &stats);
        for certificate in Certificate::ALL {
            let Tries { proven, failed } = stats.certificates[certificate];
            if proven + failed > 0 {
                let (tried, kind) = (proven + failed, certificate.name());
                writeln!(proofs, "{name:10} {kind:12}{tried:>9}{proven:>9}").unwrap();
            }
        }
    }
    for (name, table) in [("work", &table), ("certificates", &proofs)] {
        golden().check_table(name, table).unwrap_or_else(|error| panic!("{error}"));
    }
}
