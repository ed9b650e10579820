//! Importers of models: known geometry, orientation, colours; files beside; what is said about the rest.

use std::path::Path;

use crate::common::errors;

use brt_formats::{Format, Imported, Limits, ParseError, import, load};
use brt_geometry::{Vec3, vec3};
use brt_scene::framing::Up;
use brt_scene::{Projection, Scene, Shape};

fn read(format: Format, bytes: &[u8]) -> Imported {
    import(format, bytes, None, &Limits::default()).unwrap_or_else(|error| panic!("{error}"))
}

fn refused(format: Format, bytes: &[u8]) -> String {
    match import(format, bytes, None, &Limits::default()) {
        Err(error @ (ParseError::Malformed(_) | ParseError::LimitExceeded(_))) => error.to_string(),
        other => panic!("{other:?}"),
    }
}

fn triangles(scene: &Scene) -> Vec<[Vec3; 3]> {
    let of_shape = |shape: &Shape| match shape {
        Shape::Mesh(mesh) => mesh.triangles.iter().map(|t| t.map(|i| mesh.positions[i as usize])).collect(),
        _ => Vec::new(),
    };
    scene.objects.iter().flat_map(|object| of_shape(&object.shape)).collect()
}

fn normal([a, b, c]: [Vec3; 3]) -> Vec3 {
    (b - a).cross(c - a)
}

/// The triangle (0,0,0), (2,0,0), (0,1,0), whose front is +z.
fn assert_is_triangle(scene: &Scene) {
    let all = triangles(scene);
    assert_eq!(all.len(), 1);
    assert_eq!(normal(all[0]), vec3(0.0, 0.0, 2.0));
    assert_eq!(scene.bounds(), Some([vec3(0.0, 0.0, 0.0), vec3(2.0, 1.0, 0.0)]));
}

const STL: &str = "solid a part
facet normal 0 0 0
outer loop
vertex 0 0 0
vertex 2 0 0
vertex 0 1 0
endloop
endfacet
endsolid a part
";

fn binary_stl(head: &[u8]) -> Vec<u8> {
    let mut bytes = head.to_vec();
    bytes.resize(80, b' ');
    bytes.extend(1_u32.to_le_bytes());
    for x in [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 1.0, 0.0_f32] {
        bytes.extend(x.to_le_bytes());
    }
    bytes.extend([0, 0]);
    bytes
}

#[test]
fn stl_as_text_and_binary() {
    for bytes in [STL.as_bytes().to_vec(), binary_stl(b"x"), binary_stl(b"solid with a wrong word")] {
        assert_eq!(Format::from_content(&bytes), Some(Format::Stl));
        let Imported { scene, report, given, .. } = read(Format::Stl, &bytes);
        assert_is_triangle(&scene);
        assert_eq!(report.diagnostics, []);
        assert_eq!((given.camera, given.lights, given.up), (false, false, Up::PlusZ));
        assert!(given.plain.is_some());
        assert_eq!((scene.lights.len(), scene.background), (3, brt_image::Rgb::WHITE));
    }
}

#[test]
fn broken_stl_is_refused_with_a_reason() {
    assert!(refused(Format::Stl, &binary_stl(b"x")[..120]).contains("ends after 0 of 1 triangles"));
    let short = "60 bytes are too few for a binary STL (at least 84), and it does not begin with `solid`";
    assert!(refused(Format::Stl, &[1; 60]).contains(short));
    assert!(refused(Format::Stl, b"solid\nfacet\nvertex 1 2 x").contains("found `x`"));
    assert!(
        refused(Format::Stl, b"solid\nfacet\nvertex 1 2 3 endloop")
            .contains("a facet needs 3 points, found 1")
    );
    assert!(refused(Format::Stl, b"solid empty\nendsolid empty\n").contains("nothing to see"));
}

#[test]
fn off_with_colours_per_face() {
    let Imported { scene, .. } = read(Format::Off, b"OFF\n3 1 0\n0 0 0\n2 0 0\n0 1 0\n3 0 1 2 255 0 0\n");
    assert_is_triangle(&scene);
    assert_eq!(<[f64; 3]>::from(scene.materials[0].color), [1.0, 0.0, 0.0]);
    assert!(
        refused(Format::Off, b"OFF\n3 1 0\n0 0 0\n2 0 0\n0 1 0\n3 0 1 3\n")
            .contains("uses point 3, but the file has 3 points")
    );
    assert!(refused(Format::Off, b"OFF\n4000000000 4000000000 0\n").contains("with 4,000,000,000 points"));
}

#[test]
fn ply_with_colours_per_point() {
    let text = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
                property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\n\
                property list uchar int vertex_indices\nend_header\n0 0 0 255 0 0\n2 0 0 255 0 0\n0 1 0 255 0 0\n3 0 1 2\n";
    let Imported { scene, .. } = read(Format::Ply, text.as_bytes());
    assert_is_triangle(&scene);
    let shown = scene.objects[0].material.0 as usize;
    assert_eq!(<[f64; 3]>::from(scene.materials[shown].color), [1.0, 0.0, 0.0]);
    assert!(refused(Format::Ply, text.replace("3 0 1 2", "3 0 1 7").as_bytes()).contains("uses point 7"));
    assert!(
        refused(Format::Ply, text.replace("vertex 3", "vertex 99999999").as_bytes()).contains("in a file of")
    );
}

#[test]
fn broken_ply_is_refused_in_plain_words() {
    let text = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
                element face 2\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n2 0 0\n0 1 0\n3 0 1 2\n3 0 1 2\n";
    let ascii = |from: &str, to: &str| errors(Format::Ply, &text.replace(from, to)).join("|");
    for (from, to, expected) in [
        ("ply\n", "pie\n", "1: found `pie`, expected `ply`"),
        ("vertex 3", "vertex", "3: found `element vertex`, expected `element NAME COUNT`"),
        ("float x", "real x", "4: found `property real x`, expected `property TYPE NAME` or"),
        ("end_header\n", "end\n", "9: found `end`, expected `format`, `comment`,"),
        ("format ascii 1.0\n", "", "-: the header has no line such as `format ascii 1.0`"),
        ("2 0 0", "2 zero 0", "11: found `2 zero 0`, expected a vertex, `x y z`"),
        ("2 0 0", "2 0", "11: found `2 0`, expected a vertex, `x y z`"),
        ("3 0 1 2\n3 0 1 2\n", "3 0 1 2\n", "-: the file ends after 1 of 2 faces"),
        ("3 0 1 2\n3", "9 0 1 2\n3", "13: found `9 0 1 2`, expected a face, `COUNT vertex_indices...`"),
    ] {
        let found = ascii(from, to);
        assert!(found.starts_with(expected), "{found}");
    }
    let (header, _) = text.split_once("0 0 0").unwrap();
    let header = header.replace("ascii", "binary_little_endian");
    let binary = [header.as_bytes(), &[0; 36]].concat();
    assert_eq!(refused(Format::Ply, &binary), "the file ends after 0 of 2 faces");
    assert!(refused(Format::Ply, b"ply\nformat ascii 1.0\n").starts_with("the file ends within its header"));
    assert_eq!(refused(Format::Ply, b"ply\n\xff\xfe"), "the header is not text");
}

#[test]
fn obj_with_materials_beside_it() {
    let folder = tempfile::tempdir().unwrap();
    let obj = "mtllib my parts.mtl\no part\nv 0 0 0\nv 2 0 0\nv 0 1 0\nusemtl red\ns 1\nf -3//  -2 -1\n";
    std::fs::write(folder.path().join("my parts.mtl"), "newmtl red\nKd 1 0 0\nKs 1 1 1\nNs 30\nd 0.25\n")
        .unwrap();
    let path = folder.path().join("a.obj");
    std::fs::write(&path, obj).unwrap();
    let loaded = load(&path, &Limits::default()).unwrap();
    assert_is_triangle(&loaded.scene);
    let material = &loaded.scene.materials[0];
    assert_eq!((material.name.as_str(), material.specular, material.exponent), ("red", 0.5, 30.0));
    assert_eq!((material.opacity, material.transmission), (0.25, 0.0));
    assert_eq!(loaded.given.up, Up::PlusY);
    assert!(loaded.report.diagnostics.is_empty(), "{:?}", loaded.report);
}

#[test]
fn obj_says_what_it_misses_and_where() {
    let text = "mtllib no.mtl\nv 0 0 0\nv 2 0 0\nv 0 1 0\nusemtl x\nf 1 2 3\ncurv 1 2\ncurv 1 2\n";
    let Imported { scene, report, .. } = read(Format::Obj, text.as_bytes());
    assert_is_triangle(&scene);
    let messages: Vec<&str> = report.diagnostics.iter().map(|d| d.message.as_str()).collect();
    assert_eq!(
        messages,
        [
            "cannot read materials `no.mtl`: the scene has no folder",
            "material `x` is not known: the default is used",
            "2 × `curv` ignored",
        ]
    );
    assert!(
        refused(Format::Obj, b"v 0 0 0\nf 1 2 3\n")
            .contains("point 2 does not exist: only 1 is defined before it")
    );
    assert!(
        refused(Format::Obj, b"v 1 2\nv 3 4 5\n").contains("found 2 numbers, expected a point, `v x y z`")
    );
    assert!(refused(Format::Obj, b"v 0 0 0\nf 1 1\n").contains("a face needs at least 3 points, found 2"));
    assert!(
        refused(Format::Obj, b"v 0 0 0\nf 0 1 1\n").contains("point 0 does not exist: indices count from 1")
    );
}

/// A triangle below a node that turns it by 90° around x and shifts it, then is mirrored.
fn gltf(extra: &str) -> String {
    let mut buffer = Vec::new();
    for x in [0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 1.0, 0.0_f32] {
        buffer.extend(x.to_le_bytes());
    }
    let data = base64::Engine::encode(&base64::engine::general_purpose::STANDARD, &buffer);
    format!(
        r#"{{"asset": {{"version": "2.0"}}, "scene": 0, "scenes": [{{"nodes": [0]}}],
        "nodes": [{{"children": [1], "translation": [0, 0, 5]}}, {{"mesh": 0, "scale": [-1, 1, 1]}}],
        "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}, "material": 0}}]}}],
        "materials": [{{"name": "m", "pbrMetallicRoughness": {{"baseColorFactor": [0.5, 0.25, 0, 1], "metallicFactor": 0}}
        {extra} }}],
        "accessors": [{{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
        "min": [0, 0, 0], "max": [2, 1, 0]}}],
        "bufferViews": [{{"buffer": 0, "byteLength": 36}}],
        "buffers": [{{"byteLength": 36, "uri": "data:application/octet-stream;base64,{data}"}}]}}"#
    )
}

#[test]
fn gltf_nodes_put_meshes_in_their_places() {
    let Imported { scene, report, given, .. } = read(Format::Gltf, gltf("").as_bytes());
    let all = triangles(&scene);
    // Mirrored, the front stays the front.
    assert_eq!(normal(all[0]), vec3(0.0, 0.0, 2.0));
    assert_eq!(scene.bounds(), Some([vec3(-2.0, 0.0, 5.0), vec3(0.0, 1.0, 5.0)]));
    assert_eq!(<[f64; 3]>::from(scene.materials[0].color), [0.5, 0.25, 0.0]);
    assert_eq!(given.up, Up::PlusY);
    assert!(report.diagnostics.is_empty(), "{report:?}");
}

#[test]
fn gltf_extensions_are_read_or_reported() {
    let glass = r#", "extensions": {"KHR_materials_transmission": {"transmissionFactor": 0.5},
        "KHR_materials_ior": {"ior": 1.25}, "KHR_materials_clearcoat": {"clearcoatFactor": 1}}"#;
    let Imported { scene, report, .. } = read(Format::Gltf, gltf(glass).as_bytes());
    // Thin, as nothing says that it is solid.
    assert_eq!((scene.materials[0].transmission, scene.materials[0].index_of_refraction), (0.5, 1.0));
    assert_eq!(report.diagnostics[0].message, "KHR_materials_clearcoat ignored, at material 0");
    let solid = glass.replace(
        "\"KHR_materials_clearcoat\": {\"clearcoatFactor\": 1}",
        "\"KHR_materials_volume\": {\"thicknessFactor\": 2, \"attenuationDistance\": 3}",
    );
    let Imported { scene, report, .. } = read(Format::Gltf, gltf(&solid).as_bytes());
    assert_eq!(scene.materials[0].index_of_refraction, 1.25);
    assert_eq!(report.diagnostics[0].message, "attenuation of KHR_materials_volume ignored, at material 0");
    let Imported { scene, .. } =
        read(Format::Gltf, gltf(r#", "extensions": {"KHR_materials_unlit": {}}"#).as_bytes());
    assert_eq!((scene.materials[0].ambient, scene.materials[0].diffuse), (1.0, 0.0));
}

#[test]
fn gltf_that_lies_is_refused() {
    for (from, to, why) in [
        (r#""count": 3"#, r#""count": 300000"#, "reaches beyond"),
        (r#""byteLength": 36}]"#, r#""byteLength": 36, "byteOffset": 9}]"#, "reaches beyond"),
        (r#""mesh": 0"#, r#""mesh": 7"#, "`nodes[1].mesh` refers to 7, which does not exist"),
        (r#""children": [1]"#, r#""children": [0]"#, "contains itself"),
        (r#""version": "2.0""#, r#""version": "1.0""#, "glTF 1.0, expected 2.0"),
        (r#""version": "2.0""#, r#""version": "2.1", "minVersion": "2.1""#, "glTF 2.1, expected 2.0"),
        (r#""byteLength": 36, "uri""#, r#""byteLength": 99, "uri""#, "instead of 99"),
    ] {
        let text = gltf("");
        assert!(text.contains(from), "{from}");
        let error = refused(Format::Gltf, text.replace(from, to).as_bytes());
        assert!(error.to_lowercase().contains(&why.to_lowercase()), "{error}");
    }
}

#[test]
fn broken_json_is_refused_in_plain_words_at_its_place() {
    let text = "{\"asset\": {\"version\": \"2.0\"},\n\"nodes\": [\n{\"mesh\": 0}\n]}";
    let with = |from: &str, to: &str| errors(Format::Gltf, &text.replace(from, to)).join("|");
    let mut wrong = Vec::new();
    for (from, to, expected) in [
        ("\"mesh\": 0", "\"mesh\": -1", "3: found the number -1, expected a whole number, at least 0"),
        ("\"mesh\": 0", "\"name\": [1]", "3: found a list, expected a text in quotes"),
        ("\"mesh\": 0", "\"scale\": [1]", "3: found a list of length 1, expected a list of length 3"),
        ("\"mesh\": 0", "mesh: 0", "3: found `mesh`, expected a name in quotes"),
        ("\"mesh\": 0", "\"mesh\" 0", "3: found `0`, expected `:`"),
        ("[\n{", "7[\n{", "2: found the number 7, expected a list"),
        ("]}", "", "3: the text ends too early"),
        ("]}", "]}}", "4: something follows the end of the JSON"),
        ("\"version\": \"2.0\"", "", "1: the property `version` is missing"),
        ("\"2.0\"", "2", "1: found the number 2, expected a text in quotes"),
        ("\"nodes\": [\n{\"mesh\": 0}\n]", "\"nodes\": {}", "2: found an object, expected a list"),
    ] {
        let found = with(from, to);
        if found != expected {
            wrong.push((to, found));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(refused(Format::Gltf, &[0; 99]).contains("does not begin with `glTF`"));
}

/// A zip file without compression.
fn zipped(name: &str, content: &[u8]) -> Vec<u8> {
    use std::io::Write as _;
    let mut zip = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    zip.start_file(name, zip::write::SimpleFileOptions::default()).unwrap();
    zip.write_all(content).unwrap();
    zip.finish().unwrap().into_inner()
}

const MODEL: &str = r##"<?xml version="1.0"?><model unit="millimeter"><resources>
<basematerials id="5"><base name="red" displaycolor="#FF0000FF"/></basematerials>
<object id="1" type="model"><mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="2" y="0" z="0"/><vertex x="0" y="1" z="0"/>
</vertices><triangles><triangle v1="0" v2="1" v3="2" pid="5" p1="0"/></triangles></mesh></object>
<object id="2"><components><component objectid="1" transform="1 0 0 0 1 0 0 0 1 0 0 7"/></components></object>
</resources><build><item objectid="2" transform="0 1 0 -1 0 0 0 0 1 0 0 0"/></build></model>"##;

#[test]
fn threemf_components_and_colours() {
    let Imported { scene, .. } = read(Format::ThreeMf, &zipped("3D/model.model", MODEL.as_bytes()));
    // Turned by 90° around z: x becomes y, y becomes −x; and lifted by 7.
    assert_eq!(scene.bounds(), Some([vec3(-1.0, 0.0, 7.0), vec3(0.0, 2.0, 7.0)]));
    assert_eq!(normal(triangles(&scene)[0]), vec3(0.0, 0.0, 2.0));
    assert_eq!(<[f64; 3]>::from(scene.materials[0].color), [1.0, 0.0, 0.0]);
}

#[test]
fn threemf_colours_of_corners_are_kept() {
    let group = r##"<m:colorgroup id="5"><m:color color="#FF0000"/><m:color color="#00FF00"/><m:color color="#0000FF"/></m:colorgroup>"##;
    let model = MODEL
        .replace(
            r##"<basematerials id="5"><base name="red" displaycolor="#FF0000FF"/></basematerials>"##,
            group,
        )
        .replace(r#"p1="0""#, r#"p1="0" p2="1" p3="2""#);
    let Imported { scene, .. } = read(Format::ThreeMf, &zipped("3D/model.model", model.as_bytes()));
    let Shape::Mesh(mesh) = &scene.objects[0].shape else { panic!("a mesh") };
    let colors: Vec<[f64; 3]> = mesh.triangles[0].map(|i| mesh.colors[i as usize].into()).into();
    assert_eq!(colors, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    let white = scene.materials[scene.objects[0].material.0 as usize].color;
    assert_eq!(<[f64; 3]>::from(white), [1.0; 3]);
    let even = model.replace(r#"p2="1" p3="2""#, r#"p2="0" p3="0""#);
    let Imported { scene, .. } = read(Format::ThreeMf, &zipped("3D/model.model", even.as_bytes()));
    assert!(matches!(&scene.objects[0].shape, Shape::Mesh(mesh) if mesh.colors.is_empty()));
}

#[test]
fn threemf_that_lies_is_refused() {
    for (from, to, why) in [
        (r#"v3="2""#, r#"v3="9""#, "uses point 9"),
        (r#"component objectid="1""#, r#"component objectid="2""#, "contains itself"),
        (r#"item objectid="2""#, r#"item objectid="3""#, "no object 3"),
        (r#"p1="0""#, r#"p1="4""#, "no member 4"),
        (r##"displaycolor="#FF0000FF""##, "", "has no colour"),
        ("</build>", "</bild>", "XML is broken"),
    ] {
        assert!(MODEL.contains(from), "{from}");
        let error = refused(Format::ThreeMf, &zipped("a.model", MODEL.replace(from, to).as_bytes()));
        assert!(error.contains(why), "{error}");
    }
    assert!(refused(Format::ThreeMf, &zipped("a.txt", b"")).contains("no model"));
    assert!(refused(Format::ThreeMf, b"PK\x03\x04").contains("not a complete zip file: is it truncated?"));
    let limits = Limits { memory: 16_000, ..Limits::default() };
    let bomb = zipped("a.model", &[b' '; 1_000_000]);
    assert!(bomb.len() < 2000);
    let stopped = import(Format::ThreeMf, &bomb, None, &limits);
    assert!(matches!(stopped, Err(ParseError::LimitExceeded(_))));
}

const VRML: &str = "#VRML V2.0 utf8
Transform { translation 0 0 3 scale -1 1 1 children [
  DEF S Shape { appearance Appearance { material DEF M Material { diffuseColor 1 0 0 transparency 0.25 } }
    geometry IndexedFaceSet { coord Coordinate { point [0 0 0, 2 0 0, 0 1 0] } coordIndex [0, 1, 2, -1] } } ] }
";

#[test]
fn vrml_transforms_and_materials() {
    let Imported { scene, report, .. } = read(Format::Vrml, VRML.as_bytes());
    assert_eq!(scene.bounds(), Some([vec3(-2.0, 0.0, 3.0), vec3(0.0, 1.0, 3.0)]));
    assert_eq!(normal(triangles(&scene)[0]), vec3(0.0, 0.0, 2.0));
    assert_eq!(<[f64; 3]>::from(scene.materials[0].color), [1.0, 0.0, 0.0]);
    assert_eq!(scene.materials[0].transmission, 0.25);
    assert!(report.diagnostics.is_empty(), "{report:?}");
}

#[test]
fn vrml_shapes_uses_and_viewpoints() {
    let text = "#VRML V2.0 utf8
        Viewpoint { position 0 0 9 fieldOfView 0.5 }
        DEF B Shape { geometry Sphere { radius 2 } }
        Transform { translation 5 0 0 children USE B }
        Shape { geometry Cylinder { height 4 top FALSE } }
        Shape { geometry Cone { } } Shape { geometry Box { size 1 2 3 } }
        PROTO Odd [ field SFInt32 a 1 ] { Group { } } PointLight { } PointLight { }";
    let Imported { scene, report, given, .. } = read(Format::Vrml, text.as_bytes());
    let kinds: Vec<&str> = scene.objects.iter().map(|object| object.shape.kind()).collect();
    assert_eq!(kinds, ["sphere", "sphere", "cylinder", "cone", "mesh"]);
    assert_eq!(scene.objects[1].shape, Shape::Sphere { center: vec3(5.0, 0.0, 0.0), radius: 2.0 });
    assert!(given.camera);
    assert_eq!(scene.camera.eye, vec3(0.0, 0.0, 9.0));
    assert!(
        matches!(scene.camera.projection, Projection::Perspective { fov_deg } if (fov_deg - 28.648).abs() < 0.001)
    );
    let messages: Vec<&str> = report.diagnostics.iter().map(|d| d.message.as_str()).collect();
    assert_eq!(messages, ["PROTO ignored", "2 × PointLight ignored"]);
}

#[test]
fn vrml_that_lies_is_refused() {
    assert!(refused(Format::Vrml, VRML.replace("0, 1, 2", "0, 1, 5").as_bytes()).contains("uses point 5"));
    assert!(refused(Format::Vrml, b"#VRML V1.0 ascii\nSeparator { }").contains("VRML 1.0"));
    let deep = format!("#VRML V2.0 utf8\n{}", "Group { children ".repeat(100_000));
    assert!(refused(Format::Vrml, deep.as_bytes()).contains("nest deeper"));
    let mut uses = String::from("#VRML V2.0 utf8\nDEF A0 Shape { geometry Sphere { } }\n");
    for i in 0..60 {
        uses += &format!("DEF A{} Group {{ children [ USE A{i} USE A{i} ] }}\n", i + 1);
    }
    assert!(refused(Format::Vrml, uses.as_bytes()).contains("e18 instances"));
    // Nothing, however often, is nothing.
    let empty = uses.replace("Shape { geometry Sphere { } }", "Group { }");
    assert!(refused(Format::Vrml, empty.as_bytes()).contains("nothing to see"));
}

#[test]
fn a_file_without_content_is_empty_in_every_format() {
    for format in Format::ALL {
        for bytes in [&b""[..], b" \r\n\t", b"\xef\xbb\xbf\n"] {
            assert_eq!(refused(format, bytes), "the file is empty", "{format:?}");
        }
    }
}

#[test]
fn content_tells_formats_of_the_wrong_name() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("really-a-ply.stl");
    std::fs::write(&path, VRML).unwrap();
    assert!(load(&path, &Limits::default()).is_ok());
    for (name, word) in [
        ("a.step", "STEP files are not read; export STL, 3MF or GLB"),
        ("a.blend", "export GLB"),
        ("a.png", "a.png: a picture, not a scene"),
        ("a.pdb", "a.pdb: molecule files are not read; save VRML from PyMOL (`save x.wrl`)"),
    ] {
        let path = folder.path().join(name);
        std::fs::write(&path, "x").unwrap();
        let error = load(Path::new(&path), &Limits::default()).unwrap_err().to_string();
        assert!(error.contains(word), "{error}");
    }
    for name in ["stl.obj", "stl.step"] {
        let path = folder.path().join(name);
        std::fs::write(&path, binary_stl(b"x")).unwrap();
        assert!(load(&path, &Limits::default()).is_ok(), "{name}");
    }
    let path = folder.path().join("stl.toml");
    std::fs::write(&path, binary_stl(b"x")).unwrap();
    let error = load(&path, &Limits::default()).unwrap_err().to_string();
    assert!(error.ends_with(
        "the name says TOML scene, the content STL mesh; `--input-format stl` believes the content"
    ));
}
