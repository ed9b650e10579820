//! Tasks of the repository: measurements that are too long or need files of others, so that tests do not make them.
#![allow(clippy::print_stdout, reason = "a task prints what it measured")]

mod agree;
mod borders;
mod certify;
mod hard;
mod modules;
mod mutate;
mod povray;
mod scenes;
mod tidy;
mod triangles;

use std::path::{Path, PathBuf};

use brt_testkit::HardKind;
use clap::Parser;

/// Measurements of the repository.
#[derive(Parser)]
enum Task {
    /// Compares the perspective image with first hits by search, on every sample.
    Agree {
        /// Width and height.
        #[arg(long, default_value_t = 1024)]
        size: u32,
        /// Scene files or names; none: the seed scenes and all procedural ones.
        scenes: Vec<String>,
    },
    /// Prints rays per pixel of `full` and the share of pixels whose ray history differs from a neighbour's.
    Borders {
        /// Width and height.
        #[arg(long, default_value_t = 1024)]
        size: u32,
        /// Scene files or names; none: the seed scenes.
        scenes: Vec<String>,
    },
    /// Compares certified pictures with full ray tracing, pixel by pixel, in many sizes and tolerances.
    Certify {
        /// Sizes wider than this are left out.
        #[arg(long, default_value_t = 2048)]
        most_side: u32,
        /// Scene files or names; none: the seed scenes and all procedural ones.
        scenes: Vec<String>,
    },
    /// The same for random views at random scales, or for random scenes that are hard to compute.
    CertifyViews {
        /// Instead of views of scenes: tiny, mirrored, shadow, coincident, offset, long, mixed or gaps scenes; all: each of these.
        #[arg(long, conflicts_with = "scenes", value_parser = kinds)]
        kind: Option<Kinds>,
        /// How many pixels to check.
        #[arg(long, default_value_t = 20_000_000)]
        pixels: u64,
        /// Where the random numbers start.
        #[arg(long, default_value_t = 1987)]
        seed: u64,
        /// Scene files or names; none: the seed scenes and all procedural ones.
        scenes: Vec<String>,
    },
    /// Compares our pictures of the seed scenes with POV-Ray's (`povray-{a,b,c}-512-linear.ppm`).
    Povray {
        /// The folder with these pictures.
        pictures: PathBuf,
    },
    /// Writes the triangles, rays and lights of a scene for `bench/embree`.
    Triangles {
        /// How large the scene is built.
        #[arg(long)]
        triangles: Option<u32>,
        /// Width and height.
        #[arg(long, default_value_t = 1024)]
        size: u32,
        /// A scene of meshes and horizontal planes.
        scene: String,
        /// The file to write.
        output: PathBuf,
    },
    /// Draws which modules use which: `docs/images/modules.svg`.
    Modules,
    /// Checks laws of the code that neither compiler nor clippy knows; `cargo test` does, too.
    Tidy,
    /// Renders broken variants of scene files; none may crash, hang, or end with another code than 0 or 1.
    Mutate {
        /// Number of variants.
        #[arg(long, default_value_t = 10_000)]
        count: u32,
        /// The command to test.
        #[arg(long, default_value = "target/release/brt")]
        brt: PathBuf,
        /// Scene files to start from.
        #[arg(required = true)]
        files: Vec<PathBuf>,
    },
}

/// Some kinds of hard scenes.
#[derive(Clone)]
struct Kinds(Vec<HardKind>);

fn kinds(name: &str) -> Result<Kinds, String> {
    if name == "all" {
        return Ok(Kinds(HardKind::ALL.to_vec()));
    }
    HardKind::from_name(name).map(|kind| Kinds(vec![kind])).ok_or_else(|| {
        let names = HardKind::ALL.map(HardKind::name).join(", ");
        format!("expected one of {names}, all")
    })
}

fn main() -> anyhow::Result<()> {
    match Task::parse() {
        Task::Agree { size, scenes } => agree::run(size, &scenes),
        Task::Borders { size, scenes } => borders::run(size, &scenes),
        Task::Certify { most_side, scenes } => certify::matrix(&scenes, most_side),
        Task::CertifyViews { kind: Some(Kinds(kinds)), pixels, seed, .. } => hard::run(&kinds, pixels, seed),
        Task::CertifyViews { kind: None, pixels, seed, scenes } => certify::views(&scenes, pixels, seed),
        Task::Povray { pictures } => povray::run(&pictures),
        Task::Triangles { triangles, size, scene, output } => {
            triangles::run(&scene, triangles, size, &output)
        }
        Task::Modules => modules::run(Path::new(".")),
        Task::Tidy => tidy::run(Path::new(".")),
        Task::Mutate { count, brt, files } => mutate::run(count, &brt, &files),
    }
}
