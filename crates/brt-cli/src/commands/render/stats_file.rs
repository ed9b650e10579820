//! The file of `--stats`. Its keys are a promise.

use std::collections::BTreeMap;

use brt::image::Sink;
use brt::{Certificate, CertificateCounts, Rendered, Settings, Stats, Tries};
use serde::Serialize;

use crate::commands::text_file;
use crate::exit::Failure;
use crate::json;

/// Times in seconds: `load`, `prepare`, `render` and `total` by the clock, the others summed over threads. Threads encode while
/// others render: `encode` is a part of what all of them did in the time of `render`, and what was left after it.
#[derive(Debug, Serialize)]
pub(super) struct Seconds {
    load: f64,
    prepare: f64,
    perspective: f64,
    select: f64,
    trace: f64,
    fill: f64,
    render: f64,
    encode: f64,
    total: f64,
}

impl Seconds {
    pub(super) fn new(load: f64, total: f64, rendered: &Rendered) -> Self {
        let brt::rendering::Seconds { prepare, perspective, select, trace, fill, render } =
            rendered.stats.seconds;
        let encode = rendered.encode_seconds;
        Self { load, prepare, perspective, select, trace, fill, render, encode, total }
    }
}

#[derive(Debug, Serialize)]
struct StatsJson<'a> {
    method: &'static str,
    width: u64,
    height: u64,
    samples: u32,
    threads: usize,
    seconds: &'a Seconds,
    pixels: Pixels,
    rays: Rays,
    primitive_tests: u64,
    nodes_visited: u64,
    blocks: Blocks,
    /// By name; empty unless the method is `certified`.
    certificates: BTreeMap<&'static str, TriesJson>,
}

/// Counts of samples where there are several in a pixel.
#[derive(Debug, Serialize)]
struct Pixels {
    total: u64,
    traced: u64,
    shaded: u64,
    filled: u64,
}

#[derive(Debug, Serialize)]
struct Rays {
    camera: u64,
    shadow: u64,
    mirror: u64,
    refracted: u64,
}

#[derive(Debug, Serialize)]
struct TriesJson {
    tried: u64,
    proven: u64,
    failed: u64,
}

#[derive(Debug, Serialize)]
struct Blocks {
    judged: u64,
    filled: u64,
    divided: u64,
}

fn tries(counts: &CertificateCounts) -> BTreeMap<&'static str, TriesJson> {
    let json = |certificate| {
        let Tries { proven, failed } = counts[certificate];
        (certificate.name(), TriesJson { tried: proven + failed, proven, failed })
    };
    Certificate::ALL.map(json).into_iter().filter(|(_, tries)| tries.tried > 0).collect()
}

/// Writes and completes the file.
pub(super) fn write(
    file: Box<dyn Sink>,
    settings: &Settings,
    threads: usize,
    rendered: &Rendered,
    seconds: &Seconds,
) -> Result<(), Failure> {
    let Stats { pixels, rays, primitive_tests, nodes_visited, blocks, certificates, .. } = rendered.stats;
    let json = StatsJson {
        method: settings.method.name(),
        width: settings.size[0],
        height: settings.size[1],
        samples: settings.samples.per_pixel(),
        threads,
        seconds,
        pixels: Pixels {
            total: pixels.total,
            traced: pixels.traced,
            shaded: pixels.shaded,
            filled: pixels.filled,
        },
        rays: Rays {
            camera: rays.camera,
            shadow: rays.shadow,
            mirror: rays.mirror,
            refracted: rays.refracted,
        },
        primitive_tests,
        nodes_visited,
        blocks: Blocks { judged: blocks.judged, filled: blocks.filled, divided: blocks.divided },
        certificates: tries(&certificates),
    };
    text_file::write(file, &(json::text(&json)? + "\n"))
}
