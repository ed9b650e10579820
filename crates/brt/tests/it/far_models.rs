//! Models far from the origin, as maps and building sites have them: framed and rendered as they would be at the origin.

use std::fmt::Write as _;
use std::io::Write as _;

use brt::{
    CertifiedSettings, Format, Imported, Light, Limits, Method, Rows, Run, Samples, Settings, Vec3, import,
    render, vec3,
};

/// Corners of two blocks, metres large, one of which casts a shadow on the other.
const BLOCKS: [[[i64; 3]; 2]; 2] = [[[0, 0, 0], [4, 3, 1]], [[1, 1, 1], [2, 2, 4]]];

/// Two triangles for each side, seen from outside.
const SIDES: [[usize; 3]; 12] = [
    [0, 2, 3],
    [0, 3, 1],
    [4, 5, 7],
    [4, 7, 6],
    [0, 1, 5],
    [0, 5, 4],
    [2, 6, 7],
    [2, 7, 3],
    [0, 4, 6],
    [0, 6, 2],
    [1, 3, 7],
    [1, 7, 5],
];

type Point = [i64; 3];

fn points(at: Point) -> Vec<Point> {
    let corner = |[lo, hi]: [Point; 2], i: usize| {
        [0, 1, 2].map(|axis| at[axis] + if i >> axis & 1 == 0 { lo[axis] } else { hi[axis] })
    };
    BLOCKS.iter().flat_map(|&block| (0..8).map(move |i| corner(block, i))).collect()
}

fn triangles() -> Vec<[usize; 3]> {
    (0..BLOCKS.len()).flat_map(|block| SIDES.map(|t| t.map(|i| 8 * block + i))).collect()
}

/// A line of three words for each item.
fn lines<T: ToString>(items: &[[T; 3]], start: &str, end: &str) -> String {
    let line =
        |item: &[T; 3]| format!("{start}{}{end}\n", item.each_ref().map(ToString::to_string).join(" "));
    items.iter().map(line).collect()
}

fn stl_text(at: Point) -> Vec<u8> {
    let points = points(at);
    let facet = |t: [usize; 3]| {
        format!(
            "facet normal 0 0 0\nouter loop\n{}endloop\nendfacet\n",
            lines(&t.map(|i| points[i]), "vertex ", "")
        )
    };
    format!("solid\n{}endsolid\n", triangles().into_iter().map(facet).collect::<String>()).into()
}

fn stl_binary(at: Point) -> Vec<u8> {
    let points = points(at);
    let mut bytes = vec![b' '; 80];
    bytes.extend((triangles().len() as u32).to_le_bytes());
    for t in triangles() {
        bytes.extend([0; 12]);
        bytes.extend(t.iter().flat_map(|&i| points[i]).flat_map(|c| (c as f32).to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

fn ply_head(kind: &str) -> String {
    format!(
        "ply\nformat {kind} 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\n\
         element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        points([0; 3]).len(),
        triangles().len()
    )
}

fn ply_text(at: Point) -> Vec<u8> {
    (ply_head("ascii") + &lines(&points(at), "", "") + &lines(&triangles(), "3 ", "")).into()
}

fn ply_binary(at: Point) -> Vec<u8> {
    let mut bytes: Vec<u8> = ply_head("binary_little_endian").into();
    bytes.extend(points(at).into_iter().flatten().flat_map(|c| (c as f64).to_le_bytes()));
    for t in triangles() {
        bytes.push(3);
        bytes.extend(t.iter().flat_map(|&i| (i as i32).to_le_bytes()));
    }
    bytes
}

fn off(at: Point) -> Vec<u8> {
    let head = format!("OFF\n{} {} 0\n", points(at).len(), triangles().len());
    (head + &lines(&points(at), "", "") + &lines(&triangles(), "3 ", "")).into()
}

fn obj(at: Point) -> Vec<u8> {
    let triangles: Vec<_> = triangles().into_iter().map(|t| t.map(|i| i + 1)).collect();
    (lines(&points(at), "v ", "") + &lines(&triangles, "f ", "")).into()
}

fn vrml(at: Point) -> Vec<u8> {
    format!(
        "#VRML V2.0 utf8\nShape {{ geometry IndexedFaceSet {{ coord Coordinate {{ point [{}] }} coordIndex [{}] }} }}",
        lines(&points(at), "", ""),
        lines(&triangles(), "", " -1")
    )
    .into()
}

/// The node is moved: its positions are numbers of 32 bits.
fn gltf(at: Point) -> Vec<u8> {
    let points = points([0; 3]);
    let mut data: Vec<u8> = points.iter().flatten().flat_map(|&c| (c as f32).to_le_bytes()).collect();
    let start = data.len();
    data.extend(triangles().iter().flatten().flat_map(|&i| (i as u16).to_le_bytes()));
    let [count, corners, length] = [points.len(), 3 * triangles().len(), data.len()];
    let mut json = format!(
        r#"{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0,"translation":{at:?}}}],
        "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1}}]}}],
        "accessors":[{{"bufferView":0,"componentType":5126,"count":{count},"type":"VEC3","min":[0,0,0],"max":[4,3,4]}},
        {{"bufferView":1,"componentType":5123,"count":{corners},"type":"SCALAR"}}],
        "bufferViews":[{{"buffer":0,"byteLength":{start}}},{{"buffer":0,"byteOffset":{start},"byteLength":{}}}],
        "buffers":[{{"byteLength":{length}}}]}}"#,
        length - start
    );
    json += &" ".repeat(json.len().next_multiple_of(4) - json.len());
    let mut glb = b"glTF\x02\0\0\0".to_vec();
    glb.extend((12 + 8 + json.len() as u32 + 8 + length as u32).to_le_bytes());
    for (kind, chunk) in [(b"JSON", json.as_bytes()), (b"BIN\0", &data)] {
        glb.extend((chunk.len() as u32).to_le_bytes());
        glb.extend(kind);
        glb.extend(chunk);
    }
    glb
}

fn threemf(at: Point) -> Vec<u8> {
    let mut model = String::from("<model><resources><object id=\"1\"><mesh><vertices>");
    for [x, y, z] in points(at) {
        let _ = write!(model, "<vertex x=\"{x}\" y=\"{y}\" z=\"{z}\"/>");
    }
    model += "</vertices><triangles>";
    for [a, b, c] in triangles() {
        let _ = write!(model, "<triangle v1=\"{a}\" v2=\"{b}\" v3=\"{c}\"/>");
    }
    model += "</triangles></mesh></object></resources><build><item objectid=\"1\"/></build></model>";
    let mut zip = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    zip.start_file("3D/a.model", zip::write::SimpleFileOptions::default()).unwrap();
    zip.write_all(model.as_bytes()).unwrap();
    zip.finish().unwrap().into_inner()
}

fn read(format: Format, bytes: &[u8]) -> Imported {
    import(format, bytes, None, &Limits::default()).unwrap_or_else(|error| panic!("{error}"))
}

fn picture(imported: &Imported) -> Vec<[f32; 3]> {
    let method = Method::Certified(CertifiedSettings::default());
    let settings = Settings { method, samples: Samples::Four, ..Settings::new([64, 64]) };
    let mut rows: Vec<Rows> = Vec::new();
    render(&imported.scene, &settings, &Run { threads: 1, ..Run::default() }, &mut rows).unwrap();
    rows.into_iter().flat_map(|rows| rows.colors).collect()
}

fn assert_alike(name: &str, here: &Imported, there: &Imported, at: Vec3) {
    const LEVEL: f32 = 1.0 / 255.0;
    let digits = 8.0 * f64::EPSILON * at.length();
    let close = |p: Vec3, q: Vec3| assert!((p + at - q).length() <= digits, "{name} {at:?}: {p:?} {q:?}");
    let (a, b) = (&here.scene, &there.scene);
    close(a.camera.eye, b.camera.eye);
    close(a.camera.look_at, b.camera.look_at);
    assert_eq!(a.camera.projection, b.camera.projection, "{name}");
    assert_eq!(a.lights.len(), b.lights.len());
    for lights in a.lights.iter().zip(&b.lights) {
        match lights {
            (Light::Point { position: p, .. }, Light::Point { position: q, .. }) => close(*p, *q),
            (Light::Directional { direction: p, .. }, Light::Directional { direction: q, .. }) => {
                assert!((*p - *q).length() <= digits, "{name} {at:?}: {p:?} {q:?}");
            }
            other => panic!("{name}: {other:?}"),
        }
    }
    let (a, b) = (picture(here), picture(there));
    let worst =
        a.iter().zip(&b).flat_map(|(a, b)| [0, 1, 2].map(|i| (a[i] - b[i]).abs())).fold(0.0, f32::max);
    assert!(worst <= LEVEL, "{name} {at:?}: {} levels", worst / LEVEL);
}

#[test]
fn models_look_alike_wherever_they_stand() {
    type Writer = fn(Point) -> Vec<u8>;
    /// Numbers of 32 bits tell metres apart up to here.
    const SINGLE: i64 = 1 << 23;
    const DOUBLE: i64 = 1 << 33;
    let formats: [(&str, Format, Writer, i64); 9] = [
        ("STL text", Format::Stl, stl_text, DOUBLE),
        ("STL", Format::Stl, stl_binary, SINGLE),
        ("PLY text", Format::Ply, ply_text, DOUBLE),
        ("PLY", Format::Ply, ply_binary, DOUBLE),
        ("OFF", Format::Off, off, DOUBLE),
        ("OBJ", Format::Obj, obj, DOUBLE),
        ("glTF", Format::Gltf, gltf, DOUBLE),
        ("3MF", Format::ThreeMf, threemf, DOUBLE),
        ("VRML", Format::Vrml, vrml, DOUBLE),
    ];
    for (name, format, write, farthest) in formats {
        let here = read(format, &write([0; 3]));
        for distance in [1 << 17, 1 << 23, 1 << 33].into_iter().filter(|&d| d <= farthest) {
            let at = [distance, -distance / 2, distance / 4];
            let [x, y, z] = at.map(|c| c as f64);
            assert_alike(name, &here, &read(format, &write(at)), vec3(x, y, z));
        }
    }
}
