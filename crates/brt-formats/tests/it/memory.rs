//! Small files that ask for much memory or time: they end at once, and say why. Reading ends when nobody waits.

use std::fmt::Write as _;
use std::io::Write as _;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use crate::common::{EVERYTHING, NFF};
use brt_formats::{Format, Limits, ParseError, import};

/// As on a large machine, so that the tests do not depend on that which they run on.
fn limits() -> Limits<'static> {
    Limits { memory: 8 << 30, ..Limits::default() }
}

/// What is said of a file that is refused within a moment.
fn refused(format: Format, bytes: &[u8], limits: &Limits) -> String {
    let start = Instant::now();
    let error = match import(format, bytes, None, limits) {
        Err(error @ (ParseError::LimitExceeded(_) | ParseError::Malformed(_))) => error.to_string(),
        other => panic!("not refused: {:?}", other.map(|imported| imported.scene.objects.len())),
    };
    // What each of them asks for takes minutes, if there is memory for it at all.
    assert!(start.elapsed() < Duration::from_secs(10), "{:?}: {error}", start.elapsed());
    error
}

/// A triangle below `levels` nodes, each of which has the next one ten times.
fn gltf(levels: usize) -> String {
    let mut nodes: Vec<String> = (1..=levels)
        .map(|next| format!(r#"{{"children":[{}]}}"#, vec![next.to_string(); 10].join(",")))
        .collect();
    nodes.push(r#"{"mesh":0}"#.to_owned());
    format!(
        r#"{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{}],
        "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}],
        "accessors":[{{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}}],
        "bufferViews":[{{"buffer":0,"byteLength":36}}],
        "buffers":[{{"byteLength":36,"uri":"data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}}]}}"#,
        nodes.join(",")
    )
}

fn threemf(model: &str, method: zip::CompressionMethod) -> Vec<u8> {
    let mut zip = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    zip.start_file("3D/a.model", zip::write::SimpleFileOptions::default().compression_method(method))
        .unwrap();
    zip.write_all(model.as_bytes()).unwrap();
    zip.finish().unwrap().into_inner()
}

/// A mesh of the given triangles over four points, and what else stands among the resources.
fn model(triangles: &str, resources: &str, item: usize) -> String {
    format!(
        "<model><resources><object id=\"1\"><mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" \
         z=\"0\"/><vertex x=\"0\" y=\"1\" z=\"0\"/></vertices><triangles>{triangles}</triangles></mesh></object>{resources}\
         </resources><build><item objectid=\"{item}\"/></build></model>"
    )
}

const TRIANGLE: &str = "<triangle v1=\"0\" v2=\"1\" v3=\"2\"/>";

#[test]
fn uses_of_uses_are_counted_and_not_made() {
    assert_eq!(
        refused(Format::Gltf, gltf(30).as_bytes(), &limits()),
        "with 1e30 instances it needs 16 EiB or more of memory, but 8.0 GiB are allowed: `--max-memory SIZE` allows more"
    );
    let few = refused(Format::Gltf, gltf(6).as_bytes(), &limits());
    assert!(
        few.starts_with("with 1,000,000 instances it needs") && few.contains("--allow-expansion"),
        "{few}"
    );
    assert_eq!(import(Format::Gltf, gltf(3).as_bytes(), None, &limits()).unwrap().scene.objects.len(), 1000);

    let components = |i: usize| format!("<component objectid=\"{i}\"/>").repeat(10);
    let objects: String = (1..=30)
        .map(|i| format!("<object id=\"{}\"><components>{}</components></object>", i + 1, components(i)))
        .collect();
    let bomb = threemf(&model(TRIANGLE, &objects, 31), zip::CompressionMethod::Deflated);
    assert!(refused(Format::ThreeMf, &bomb, &limits()).starts_with("with 1e30 instances"));

    let mut vrml = String::from("#VRML V2.0 utf8\nDEF A0 Shape { geometry Box { } }\n");
    for i in 0..20 {
        let uses = format!("USE A{i} ").repeat(10);
        let _ = writeln!(vrml, "DEF A{} Transform {{ children [ {uses}] }}", i + 1);
    }
    assert!(refused(Format::Vrml, vrml.as_bytes(), &limits()).contains("e20 instances"));
}

#[test]
fn parts_that_unpack_to_a_multiple_are_refused() {
    let many = model(&TRIANGLE.repeat(600_000), "", 1);
    let bomb = threemf(&many, zip::CompressionMethod::Deflated);
    assert!(many.len() > 100 * bomb.len());
    let error = refused(Format::ThreeMf, &bomb, &limits());
    assert!(error.starts_with("`3D/a.model` unpacks to more than 100 times its "), "{error}");
    assert!(error.ends_with("`--allow-expansion` lets that pass"), "{error}");
    // Allowed, its triangles count.
    let trusted = Limits { any_expansion: true, memory: 256 << 20, ..Limits::default() };
    let error = refused(Format::ThreeMf, &bomb, &trusted);
    assert!(error.contains("triangles it needs 256.0 MiB") && error.contains("--max-memory"), "{error}");
}

#[test]
fn what_a_part_says_of_its_size_does_not_count() {
    let text = model(&TRIANGLE.repeat(600_000), "", 1);
    let mut bomb = threemf(&text, zip::CompressionMethod::Deflated);
    // The sizes in both heads become 1000.
    let size = (text.len() as u32).to_le_bytes();
    for at in 0..bomb.len() - 4 {
        if bomb[at..at + 4] == size {
            bomb[at..at + 4].copy_from_slice(&1000_u32.to_le_bytes());
        }
    }
    refused(Format::ThreeMf, &bomb, &limits());
}

#[test]
fn numbers_of_things_are_believed_before_they_come() {
    let limits = Limits { memory: 1 << 30, any_expansion: true, ..Limits::default() };
    let mut stl = vec![b' '; 84 + 50 * 2_000_000];
    stl[80..84].copy_from_slice(&2_000_000_u32.to_le_bytes());
    let error = refused(Format::Stl, &stl, &limits);
    assert!(error.starts_with("with 2,000,000 triangles"), "{error}");
    let nodes = "{},".repeat(3_000_000);
    let json = gltf(1).replace(r#""nodes":[{"#, &format!(r#""nodes":[{nodes}{{"#));
    let error = refused(Format::Gltf, json.as_bytes(), &limits);
    assert!(error.contains("nodes it needs"), "{error}");
    let vrml = format!("#VRML V2.0 utf8\n{}", "A{}".repeat(3_000_000));
    assert!(refused(Format::Vrml, vrml.as_bytes(), &limits).contains("nodes it needs"));
    let toml = format!("a = [{}]", "0,".repeat(8_000_000));
    assert!(refused(Format::Toml, toml.as_bytes(), &limits).contains("words and marks it needs"));
    let nff = "s 0 0 0 1\n".repeat(2_000_000);
    assert!(refused(Format::Nff, nff.as_bytes(), &limits).contains("shapes it needs"));
}

/// A file of each kind that is read.
fn one_of_each() -> Vec<(Format, Vec<u8>)> {
    let ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
               element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    let off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    let stl = "solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n";
    vec![
        (Format::Toml, EVERYTHING.into()),
        (Format::Nff, NFF.into()),
        (Format::Stl, stl.into()),
        (Format::Ply, ply.into()),
        (Format::Off, off.into()),
        (Format::Obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".into()),
        (Format::Gltf, gltf(1).into()),
        (Format::ThreeMf, threemf(&model(TRIANGLE, "", 1), zip::CompressionMethod::Stored)),
        (Format::Vrml, "#VRML V2.0 utf8\nShape { geometry Sphere { } }".into()),
    ]
}

#[test]
fn nothing_is_read_for_nobody() {
    let cancel = AtomicBool::new(false);
    let limits = Limits { cancel: Some(&cancel), ..Limits::default() };
    for (format, bytes) in one_of_each() {
        cancel.store(false, Ordering::Relaxed);
        assert!(import(format, &bytes, None, &limits).is_ok(), "{format:?}");
        cancel.store(true, Ordering::Relaxed);
        assert!(matches!(import(format, &bytes, None, &limits), Err(ParseError::Cancelled)), "{format:?}");
    }
}

/// An even sheet of `n` × `n` squares.
fn sheet(n: usize) -> Vec<u8> {
    let mut text = String::new();
    for i in 0..=n {
        (0..=n).for_each(|j| text += &format!("v {i} {j} {}\n", i * j % 7));
    }
    for i in 0..n {
        for j in 1..=n {
            let [a, b] = [i, i + 1].map(|i| i * (n + 1) + j);
            let _ = writeln!(text, "f {a} {b} {} {}", b + 1, a + 1);
        }
    }
    text.into()
}

#[test]
fn reading_ends_within_a_second_of_being_cancelled() {
    let bytes = sheet(1000);
    let cancel = AtomicBool::new(false);
    let limits = Limits { cancel: Some(&cancel), memory: 8 << 30, ..Limits::default() };
    let mut were_cancelled = 0;
    for wait in [20, 100, 300, 600] {
        cancel.store(false, Ordering::Relaxed);
        let took = std::thread::scope(|scope| {
            let reader = scope
                .spawn(|| matches!(import(Format::Obj, &bytes, None, &limits), Err(ParseError::Cancelled)));
            std::thread::sleep(Duration::from_millis(wait));
            let asked = Instant::now();
            cancel.store(true, Ordering::Relaxed);
            were_cancelled += u32::from(reader.join().unwrap());
            asked.elapsed()
        });
        assert!(took < Duration::from_secs(1), "{took:?} after {wait} ms");
    }
    assert!(were_cancelled > 0);
}

/// How long reading takes, at best of three.
fn seconds(format: Format, bytes: &[u8]) -> f64 {
    let once = || {
        let start = Instant::now();
        import(format, bytes, None, &limits()).unwrap();
        start.elapsed().as_secs_f64()
    };
    (0..3).map(|_| once()).fold(f64::INFINITY, f64::min)
}

#[test]
fn time_grows_with_the_file_whatever_coincides() {
    let coincident = |n: usize| format!("v 0 0 0\nv 1 0 0\nv 0 1 0\n{}", "f 1 2 3\n".repeat(n));
    let own_points = |n: usize| "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n".repeat(n);
    let wheel = |n: usize| {
        let rim = |i: usize| 2.0 * std::f64::consts::PI * i as f64 / n as f64;
        let points: String =
            (0..n).map(|i| format!("v {} {} {}\n", libm::cos(rim(i)), libm::sin(rim(i)), i % 2)).collect();
        let faces: String = (0..n).map(|i| format!("f 1 {} {}\n", i + 2, (i + 1) % n + 2)).collect();
        format!("v 0 0 0\n{points}{faces}")
    };
    let row = |n: usize| {
        let strip = |i: usize| format!("v {i} 0 0\nv {i} 1 0\n");
        let square = |i: usize| format!("f {} {} {} {}\n", 2 * i + 1, 2 * i + 3, 2 * i + 4, 2 * i + 2);
        (0..=n).map(strip).chain((0..n).map(square)).collect::<String>()
    };
    let groups = |n: usize| {
        (0..n).map(|i| format!("g {i}\nv {i} 0 0\nv {i} 1 0\nv {i} 0 1\nf -3 -2 -1\n")).collect::<String>()
    };
    let writers: [(&str, &dyn Fn(usize) -> String); 5] = [
        ("coincident", &coincident),
        ("coincident with their own points", &own_points),
        ("around one point", &wheel),
        ("in a row", &row),
        ("in groups of their own", &groups),
    ];
    for (name, write) in writers {
        const COUNT: usize = 25_000;
        let [few, many] = [COUNT, 4 * COUNT].map(|n| seconds(Format::Obj, write(n).as_bytes()));
        // A twentieth of a second is noise; the square of four would be 16.
        assert!(many < 8.0 * few.max(0.02), "{name}: {few} s, {many} s for four times as many");
    }
}
