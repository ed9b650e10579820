//! Times of the renderer's stages, of whole pictures, and of what comes before and after them.
//!
//! `cargo bench -p brt -- certified/c` measures what has that in its name. One thread: stages are to be compared, not
//! machines.

use std::hint::black_box;
use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;

use brt::geometry::{Aabb, Bvh};
use brt::image::{PlainSink, encoder};
use brt::rendering::{PreparedScene, Seconds};
use brt::*;
use criterion::Criterion;

/// Side of the pictures.
const SIDE: u32 = 128;
/// Triangles of the torus.
const TRIANGLES: u32 = 20_000;
const SEEDS: [(&str, &str); 3] = [("a", "seed-a"), ("b", "seed-b"), ("c", "seed-c")];

type Stage = (&'static str, fn(&Seconds) -> f64);

/// What is measured inside of a rendering, named as in [`Seconds`]; in `certified`, `select` is to certify.
const STAGES: [Stage; 4] = [
    ("perspective", |s| s.perspective),
    ("select", |s| s.select),
    ("trace", |s| s.trace),
    ("fill", |s| s.fill),
];

fn main() {
    let mut criterion = Criterion::default()
        .sample_size(20)
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1))
        .configure_from_args();
    before_rendering(&mut criterion);
    stages(&mut criterion);
    whole_pictures(&mut criterion);
    encoding(&mut criterion);
    criterion.final_summary();
}

fn methods() -> [Method; 3] {
    [Method::Full, Method::Border(BorderSettings::default()), Method::Certified(CertifiedSettings::default())]
}

fn scene(name: &str, size: Option<u32>) -> CheckedScene {
    let named = library::find(name).expect("a scene of the library");
    named.build(size).expect("a size in its range").checked().expect("a scene without faults")
}

fn seed_file(letter: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../scenes/seed/{letter}.toml"))
}

/// Renders with one thread; rows go to memory.
fn picture(scene: &CheckedScene, method: &Method) -> (Vec<Rows>, Seconds) {
    let settings = Settings { method: *method, ..Settings::new([SIDE; 2]) };
    let mut rows = Vec::new();
    let run = Run { threads: 1, ..Run::default() };
    let stats = render(scene, &settings, &run, &mut rows).expect("a picture");
    (rows, stats.seconds)
}

fn before_rendering(c: &mut Criterion) {
    let file = seed_file("c");
    c.bench_function("load/c", |b| b.iter(|| load(&file, &Limits::default()).expect("a scene")));
    let torus = scene("torus", Some(TRIANGLES));
    let text = write_toml(&torus);
    c.bench_function("load/torus", |b| {
        b.iter(|| parse(Format::Toml, text.as_bytes(), &Limits::default()).expect("a scene"));
    });
    for (name, scene) in [("c", scene("seed-c", None)), ("torus", torus)] {
        c.bench_function(&format!("prepare/{name}"), |b| {
            b.iter(|| {
                let renderer = Renderer::new(scene.clone());
                renderer.prepared(Accelerator::Bvh, &Run::default()).map(PreparedScene::primitive_count).ok()
            });
        });
        let boxes = boxes(&scene);
        c.bench_function(&format!("bvh/{name}"), |b| b.iter(|| Bvh::build(&boxes, 4)));
    }
}

/// Those of triangles and polygons.
fn boxes(scene: &Scene) -> Vec<(u32, Aabb)> {
    let of_object = |object: &Object| match &object.shape {
        Shape::Mesh(mesh) => {
            mesh.triangles.iter().map(|t| Aabb::of_points(&t.map(|i| mesh.positions[i as usize]))).collect()
        }
        Shape::Polygon { outline, .. } => vec![Aabb::of_points(outline)],
        _ => Vec::new(),
    };
    (0..).zip(scene.objects.iter().flat_map(of_object)).collect()
}

fn whole_pictures(c: &mut Criterion) {
    for (letter, name) in SEEDS {
        let scene = scene(name, None);
        for method in methods() {
            let id = format!("{}/{letter}", method.name());
            c.bench_function(&id, |b| b.iter(|| picture(black_box(&scene), &method)));
        }
    }
}

/// The renderer's own clocks; stages are private, and depend on each other.
fn stages(c: &mut Criterion) {
    let scenes = SEEDS.map(|(letter, name)| (letter, scene(name, None)));
    for method in &methods()[1..] {
        for (stage, seconds) in STAGES {
            for (letter, scene) in &scenes {
                let id = format!("{}-{stage}/{letter}", method.name());
                c.bench_function(&id, |b| b.iter_custom(|n| stage_time(n, scene, method, seconds)));
            }
        }
    }
}

fn stage_time(count: u64, scene: &CheckedScene, method: &Method, seconds: fn(&Seconds) -> f64) -> Duration {
    let total: f64 = (0..count).map(|_| seconds(&picture(scene, method).1)).sum();
    // A stage that was not needed took no time, which is no time to divide by.
    Duration::from_secs_f64(total).max(Duration::from_nanos(1))
}

fn encoding(c: &mut Criterion) {
    let (rows, _) = picture(&scene("seed-a", None), &Method::Full);
    for format in [PictureFormat::Png, PictureFormat::Ppm, PictureFormat::Exr] {
        let encoding = Encoding { format, ..Encoding::default() };
        c.bench_function(&format!("encode/{}", format.extension()), |b| b.iter(|| encode(&rows, encoding)));
    }
}

fn encode(rows: &[Rows], encoding: Encoding) {
    let size = PictureSize::new(SIDE, SIDE);
    let mut file = encoder(Box::new(PlainSink(io::sink())), size, encoding).expect("an encoder");
    for rows in rows {
        file.write(&rows.colors).expect("written");
    }
    file.finish().expect("complete");
}
