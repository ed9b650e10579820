//! Broken and hostile bytes: never a panic, never a hang.

use std::time::{Duration, Instant};

use crate::common::{EVERYTHING, FOUR, NFF, png};
use brt_formats::{Format, Limits, ParseError, parse, write_toml};

/// Small files with much in them.
fn files() -> Vec<(Format, Vec<u8>)> {
    let mut binary = vec![b' '; 80];
    binary.extend(2_u32.to_le_bytes());
    binary.extend([0, 0, 128, 63].repeat(25));
    let json = br#"{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"camera":0}],
        "cameras":[{"type":"perspective","perspective":{"yfov":1,"znear":1}}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
        {"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}],
        "bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6}],
        "buffers":[{"byteLength":42}]}  "#;
    let mut glb = b"glTF\x02\0\0\0\0\0\0\0".to_vec();
    glb.extend((json.len() as u32).to_le_bytes());
    glb.extend(b"JSON");
    glb.extend(json);
    glb.extend(42_u32.to_le_bytes());
    glb.extend(b"BIN\0");
    for x in [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0_f32] {
        glb.extend(x.to_le_bytes());
    }
    glb.extend([0, 0, 1, 0, 2, 0]);
    let length = glb.len() as u32;
    glb[8..12].copy_from_slice(&length.to_le_bytes());
    vec![
        (Format::Toml, EVERYTHING.into()),
        (Format::Toml, textured().into()),
        (Format::Nff, NFF.into()),
        (Format::Stl, b"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a".into()),
        (Format::Stl, binary),
        (Format::Off, b"COFF\n4 2 0\n0 0 0 1 0 0 1\n2 0 0 1 0 0 1\n0 1 0 1 0 0 1\n1 1 1 0 0 1 1\n3 0 1 2 255 0 0\n3 1 3 2\n".into()),
        (Format::Ply, b"ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0 1 2 3\n1 0 0 1 2 3\n1 1 0 1 2 3\n0 1 0 1 2 3\n4 0 1 2 3\n".into()),
        (Format::Obj, b"mtllib x\no a\nv 0 0 0\nv 1 0 0 1 0 0\nv 1 1 0\nv 0 1 1\nvn 0 0 1\ns 1\nf 1//1 2//1 3//1 -1//-1\nusemtl b\ns off\nf 1 2 3\n".into()),
        (Format::Vrml, b"#VRML V2.0 utf8\nDEF A Transform { rotation 0 0 1 1 scale 1 2 1 children [ Shape { appearance Appearance { material Material { diffuseColor 1 0 0 } } geometry IndexedFaceSet { coord Coordinate { point [0 0 0, 1 0 0, 1 1 0, 0 1 0] } coordIndex [0 1 2 3 -1] color Color { color [1 0 0] } colorPerVertex FALSE } } Shape { geometry Sphere { radius 2 } } ] }\nUSE A".into()),
        (Format::Gltf, json.into()),
        (Format::Gltf, glb),
        (Format::ThreeMf, zipped()),
    ]
}

/// A square with a picture that stands in the text.
fn textured() -> String {
    let data = base64::Engine::encode(&base64::engine::general_purpose::STANDARD, png(2, 2, &FOUR));
    format!(
        "[camera]\neye = [0, 0, 5]\nlook_at = [0, 0, 0]\nfov_deg = 45\n[materials.m]\ncolor = [1, 1, 1]\n\
         texture = {{ data = \"{data}\", wrap = [\"clamp\", \"mirror\"], transform = [[2, 0, 0], [0, 1, 0.5]], mask = 0.5 }}\n\
         [[object]]\ntype = \"mesh\"\nmaterial = \"m\"\npositions = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]\n\
         texcoords = [[0, 1], [1, 1], [0, 0]]\ntriangles = [[0, 1, 2]]\n"
    )
}

/// Stored, so that mutations reach the XML.
fn zipped() -> Vec<u8> {
    use std::io::Write as _;
    let model = br##"<model><resources><basematerials id="5"><base displaycolor="#FF0000"/></basematerials><object id="1"><mesh><vertices>
<vertex x="0" y="0" z="0"/><vertex x="2" y="0" z="0"/><vertex x="0" y="1" z="0"/></vertices><triangles><triangle v1="0" v2="1"
 v3="2" pid="5" p1="0"/></triangles></mesh></object></resources><build><item objectid="1"/></build></model>"##;
    let mut zip = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    let stored = zip::write::SimpleFileOptions::default().compression_method(zip::CompressionMethod::Stored);
    zip.start_file("3D/a.model", stored).unwrap();
    zip.write_all(model).unwrap();
    zip.finish().unwrap().into_inner()
}

/// Whatever the bytes are, a scene that is returned is good, and an error says something.
fn survives(format: Format, bytes: &[u8]) {
    match parse(format, bytes, &Limits::default()) {
        Ok((scene, report)) => {
            assert_eq!(scene.check(), []);
            assert!(!report.has_errors());
        }
        Err(ParseError::Malformed(report)) => {
            assert!(report.has_errors());
            for span in report.diagnostics.iter().filter_map(|d| d.span.clone()) {
                assert!(span.start <= span.end && span.end <= bytes.len(), "{span:?} of {}", bytes.len());
            }
        }
        Err(error) => assert!(!error.to_string().is_empty()),
    }
}

#[test]
fn every_beginning_of_a_file() {
    for (format, bytes) in files() {
        for end in 0..bytes.len() {
            survives(format, &bytes[..end]);
        }
    }
}

#[test]
fn two_thousand_mutations() {
    for (format, original) in files() {
        let mut random = Random(0x9E37_79B9_7F4A_7C15);
        for _ in 0..2000 {
            let mut bytes = original.clone();
            for _ in 0..=random.below(3) {
                mutate(&mut bytes, &mut random);
            }
            survives(format, &bytes);
        }
    }
}

/// What fuzzers found, cut down.
#[test]
fn files_that_once_made_us_panic() {
    let files: [(Format, &[u8]); 1] = [
        // The first colour comes after a face of the same mesh.
        (Format::Obj, b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nv 0 0 1 1 0 0\nf 1 2 4\n"),
    ];
    for (format, bytes) in files {
        survives(format, bytes);
    }
}

#[test]
fn nodes_that_use_each_other_do_not_overflow_the_stack() {
    let chain = "DEF A Group { children USE A }\n".repeat(200_000);
    let text =
        format!("#VRML V2.0 utf8\nDEF A Group {{ children Shape {{ geometry Sphere {{ }} }} }}\n{chain}");
    let error = parse(Format::Vrml, text.as_bytes(), &Limits::default()).unwrap_err().to_string();
    assert_eq!(error, "nodes nest deeper than 64");
}

#[test]
fn many_fields_are_looked_up_in_time() {
    let fields = |count: usize| (0..count).map(|i| format!("f{i} 1\n")).collect::<String>();
    let text = format!(
        "#VRML V2.0 utf8\nShape {{ geometry IndexedFaceSet {{ coord Coordinate {{ point [0 0 0 1 0 0 0 1 0] }} \
         coordIndex [{}] {} }} }}",
        "0 1 2 -1 ".repeat(200_000),
        fields(200_000)
    );
    let start = Instant::now();
    survives(Format::Vrml, text.as_bytes());
    assert!(start.elapsed() < Duration::from_secs(20), "{:?}", start.elapsed());
}

#[test]
fn a_few_words_do_not_fill_the_memory() {
    let gltf = br#"{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
        "accessors":[{"componentType":5126,"count":1999999,"type":"VEC3","min":[0,0,0],"max":[1,1,0],
        "sparse":{"count":1,"indices":{"bufferView":0,"componentType":5121},"values":{"bufferView":0}}}],
        "bufferViews":[{"buffer":0,"byteLength":15}],
        "buffers":[{"byteLength":15,"uri":"data:;base64,AAAAAAAAAAAAAAAAAAAA"}]}"#;
    let error = parse(Format::Gltf, gltf, &Limits::default()).unwrap_err().to_string();
    assert_eq!(error, "accessor 0 has 1999999 rows, but no data for most of them");
}

#[test]
fn normals_that_are_no_numbers_are_computed_anew() {
    let head = "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n\
                property float z\nproperty float nx\nproperty float ny\nproperty float nz\nelement face 1\n\
                property list uchar uchar vertex_indices\nend_header\n";
    let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0_f32]];
    let numbers = points.into_iter().flat_map(|[x, y, z]| [x, y, z, f32::NAN, 0.0, 1.0]);
    let mut ply: Vec<u8> = head.bytes().chain(numbers.flat_map(f32::to_le_bytes)).collect();
    ply.extend([3, 0, 1, 2]);
    let (scene, report) = parse(Format::Ply, &ply, &Limits::default()).unwrap();
    let again = parse(Format::Toml, write_toml(&scene).as_bytes(), &Limits::default()).unwrap();
    assert_eq!(again.0, scene);
    assert!(report.diagnostics[0].message.contains("normals of length 0 or not finite"), "{report:?}");
}

#[test]
fn the_wrong_reader() {
    for (_, bytes) in files() {
        Format::ALL.into_iter().for_each(|format| survives(format, &bytes));
    }
    for format in Format::ALL {
        for bytes in [&b""[..], &[0; 1000], &[0xFF; 1000], b"\xef\xbb\xbf", b"\n\n\n", b"#", b"\r"] {
            survives(format, bytes);
        }
    }
}

#[test]
fn deep_nesting_is_an_error_and_no_overflow_of_the_stack() {
    const DEEP: usize = 100_000;
    for (open, close) in [("[", "]"), ("{a=", "}"), ("[{a=", "}]"), ("a.", ""), ("[[", "]]")] {
        for text in [
            format!("a = {}", open.repeat(DEEP)),
            format!("a = {}1{}", open.repeat(DEEP), close.repeat(DEEP)),
            format!("[{}b]\n", open.repeat(DEEP)),
            format!("{}b = 1\n", open.repeat(DEEP)),
        ] {
            let parsed = parse(Format::Toml, text.as_bytes(), &Limits::default());
            assert!(matches!(parsed, Err(ParseError::Malformed(_))));
        }
    }
}

#[test]
fn large_nonsense_is_read_in_time() {
    const COUNT: usize = 100_000;
    let camera = "[camera]\neye = [0, 0, 5]\nlook_at = [0, 0, 0]\nfov_deg = 45\n";
    let keys = |line: &dyn Fn(usize) -> String| (0..COUNT).map(line).collect::<String>();
    let texts = [
        format!("background = [{}0]\n{camera}", "0,".repeat(20 * COUNT)),
        format!("a = \"{}\"", "x".repeat(100 * COUNT)),
        keys(&|i| format!("key{i} = {i}\n")),
        keys(&|i| format!("[materials.m{i}]\nsize = 1\n")),
        keys(&|i| format!("[materials.m{i}.checker.a.b]\nsize = 1\n")),
        format!("{camera}{}", "[[object]]\ntype = \"sphere\"\nmaterial = \"m\"\n".repeat(COUNT)),
        format!("{camera}[[object]]\n{}", keys(&|i| format!("k{i} = 1\n"))),
        "?\n".repeat(COUNT),
        "s 0 0 0 x ".repeat(COUNT),
        "tess ".repeat(COUNT),
        "1 ".repeat(COUNT),
        format!("p {COUNT}\n{}", "0 1 2 ".repeat(COUNT)),
        format!("p {COUNT}\n{}", keys(&|i| format!("{} {} {}\n", i % 317, i % 211, i % 97))),
        format!("pp {COUNT}\n{}", keys(&|i| format!("{} {} {} 0 0 1\n", i % 317, i % 211, i % 97))),
        keys(&|i| format!("f {i} 0 0 1 0 1 0 1\ns 0 0 0 1\n")),
    ];
    for text in &texts {
        for format in Format::ALL {
            let start = Instant::now();
            survives(format, text.as_bytes());
            let took = start.elapsed();
            // Generous for slow machines; what it guards against takes hours.
            assert!(took < Duration::from_secs(20), "{took:?} for {format:?}: {}", &text[..60]);
        }
    }
}

/// xorshift64 (Marsaglia 2003): the same bytes on every machine.
struct Random(u64);

impl Random {
    fn below(&mut self, end: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % end.max(1) as u64) as usize
    }
}

fn mutate(bytes: &mut Vec<u8>, random: &mut Random) {
    let at = random.below(bytes.len());
    match random.below(5) {
        0 => bytes.iter_mut().skip(at).take(1).for_each(|b| *b ^= 1 << random.below(8)),
        1 => bytes.insert(at, random.below(256) as u8),
        2 => drop(bytes.drain(at..(at + 1 + random.below(20)).min(bytes.len()))),
        3 => {
            let end = (at + 1 + random.below(80)).min(bytes.len());
            let piece = bytes[at..end].to_vec();
            let target = random.below(bytes.len());
            bytes.splice(target..target, piece);
        }
        _ => replace_number(bytes, at, random),
    }
}

/// Replaces the first number from `at` on.
fn replace_number(bytes: &mut Vec<u8>, at: usize, random: &mut Random) {
    const NUMBERS: [&str; 14] = [
        "1e400",
        "1e308",
        "-1e308",
        "1e31",
        "1e-320",
        "nan",
        "inf",
        "-1",
        "0",
        "-0.0",
        "",
        "4294967295",
        "99999999999999999999",
        "0.5",
    ];
    let Some(start) = (at..bytes.len()).find(|&i| bytes[i].is_ascii_digit()) else { return };
    let length = bytes[start..].iter().take_while(|b| b.is_ascii_digit() || **b == b'.').count();
    let number = NUMBERS[random.below(NUMBERS.len())];
    bytes.splice(start..start + length, number.bytes());
}
