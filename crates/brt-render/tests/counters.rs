//! How much work the seed scenes are, exactly: more rays are a red test on every machine.
//!
//! Tests of primitives and visits of nodes are left out, since they change with every tuning.

use brt_render::{BorderSettings, Method, PixelSelectedSettings, RayCounts, Run, Settings};
use brt_testkit::{render_with_layers, seed_scene};

/// Traced samples, filled ones, and rays at 256 × 256 pixels by each method's default settings.
type Work = (u64, u64, RayCounts);

const fn work(traced: u64, filled: u64, [shadow, mirror, refracted]: [u64; 3]) -> Work {
    (traced, filled, RayCounts { camera: traced, shadow, mirror, refracted })
}

/// The only place to change when the methods choose differently: full, pixel-selected, border.
const RECORDED: [(&str, [Work; 3]); 3] = [
    (
        "a",
        [
            work(65536, 0, [104197, 101724, 0]),
            work(13872, 51664, [26714, 28982, 0]),
            work(9207, 56329, [18255, 20340, 0]),
        ],
    ),
    (
        "b",
        [
            work(65536, 0, [74575, 46472, 0]),
            work(26849, 38687, [35503, 35646, 0]),
            work(20375, 45161, [28731, 31047, 0]),
        ],
    ),
    (
        "c",
        [
            work(65536, 0, [155878, 16264, 0]),
            work(15948, 49588, [49317, 10979, 0]),
            work(8406, 57130, [28158, 7117, 0]),
        ],
    ),
];

#[test]
fn the_seed_scenes_cost_what_they_did() {
    let methods = [
        Method::Full,
        Method::PixelSelected(PixelSelectedSettings::default()),
        Method::Border(BorderSettings::default()),
    ];
    let measure = |name: &str| {
        methods.map(|method| {
            let settings = Settings { method, ..Settings::new([256, 256]) };
            let stats = render_with_layers(&seed_scene(name), &settings, &Run::default()).stats;
            (stats.pixels.traced, stats.pixels.filled, stats.rays)
        })
    };
    let measured = RECORDED.map(|(name, _)| (name, measure(name)));
    assert_eq!(measured, RECORDED, "now:\n{}", table(&measured));
}

/// The table as it stands above.
fn table(measured: &[(&str, [Work; 3])]) -> String {
    let entry = |(traced, filled, rays): &Work| {
        format!("work({traced}, {filled}, [{}, {}, {}])", rays.shadow, rays.mirror, rays.refracted)
    };
    let row = |(name, works): &(&str, [Work; 3])| {
        format!("    (\"{name}\", [{}]),\n", works.each_ref().map(entry).join(", "))
    };
    measured.iter().map(row).collect()
}
