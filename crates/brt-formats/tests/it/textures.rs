//! Pictures on surfaces, in the formats that have them.

use std::fs;
use std::path::Path;
use std::sync::Arc;

use crate::common::{FOUR, png};
use base64::Engine as _;
use brt_formats::{Format, Imported, Limits, import, load};
use brt_scene::{Material, Mesh, Object, Scene, Shape, Texture, TextureAlpha, TextureFilter, Wrap};

fn meshes(scene: &Scene) -> Vec<Arc<Mesh>> {
    let mesh = |object: &Object| match &object.shape {
        Shape::Mesh(mesh) => Some(mesh.clone()),
        _ => None,
    };
    scene.objects.iter().filter_map(mesh).collect()
}

fn messages(imported: &Imported) -> Vec<String> {
    imported.report.diagnostics.iter().map(|d| d.message.clone()).collect()
}

fn texture(material: &Material) -> &Texture {
    material.texture.as_ref().expect("a texture")
}

/// A triangle of points, coordinates as floats and as normalised bytes; then a picture. `{}` is filled in.
fn gltf(image: &str, material: &str, extra: &str) -> Vec<u8> {
    let mut buffer = Vec::new();
    for x in [0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.25, 0.5, 1.0, 0.0, 0.0, 2.0_f32] {
        buffer.extend(x.to_le_bytes());
    }
    buffer.extend([0, 255, 0, 0, 255, 0, 0, 0, 51, 51, 0, 0]);
    let picture = png(2, 2, &FOUR);
    buffer.extend(&picture);
    let data = base64::engine::general_purpose::STANDARD.encode(&buffer);
    format!(
        r#"{{"asset": {{"version": "2.0"}}, "scene": 0, "scenes": [{{"nodes": [0]}}], "nodes": [{{"mesh": 0}}],
        "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0, "TEXCOORD_0": 1, "TEXCOORD_1": 2}}, "material": 0}}]}}],
        "materials": [{{ {material} }}], "textures": [{{"source": 0, "sampler": 0}}],
        "samplers": [{{"magFilter": 9728, "wrapS": 33071, "wrapT": 33648}}], "images": [{{ {image} }}],
        "accessors": [
          {{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [2, 1, 0]}},
          {{"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"}},
          {{"bufferView": 2, "componentType": 5121, "normalized": true, "count": 3, "type": "VEC2"}}],
        "bufferViews": [{{"buffer": 0, "byteLength": 36}}, {{"buffer": 0, "byteOffset": 36, "byteLength": 24}},
          {{"buffer": 0, "byteOffset": 60, "byteLength": 12, "byteStride": 4}},
          {{"buffer": 0, "byteOffset": 72, "byteLength": {}}}],
        "buffers": [{{"byteLength": {}, "uri": "data:;base64,{data}"}}] {extra} }}"#,
        picture.len(),
        buffer.len(),
    )
    .into_bytes()
}

const IN_BUFFER: &str = r#""bufferView": 3, "mimeType": "image/png""#;
const PLAIN: &str = r#""pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}"#;

fn read(bytes: &[u8]) -> Imported {
    import(Format::Gltf, bytes, None, &Limits::default()).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn gltf_pictures_lie_as_their_samplers_say() {
    let imported = read(&gltf(IN_BUFFER, PLAIN, ""));
    assert_eq!(messages(&imported), [""; 0]);
    let texture = texture(&imported.scene.materials[0]);
    assert_eq!(texture.picture.rgba, FOUR);
    assert_eq!((texture.filter, texture.wrap), (TextureFilter::Nearest, [Wrap::Clamp, Wrap::Mirror]));
    assert_eq!((texture.alpha, texture.transform), (TextureAlpha::Ignored, Texture::PLAIN));
    assert_eq!(meshes(&imported.scene)[0].texcoords, [[0.25, 0.5], [1.0, 0.0], [0.0, 2.0]]);
}

#[test]
fn gltf_pictures_in_the_json_and_beside_it() {
    let data = base64::engine::general_purpose::STANDARD.encode(png(2, 2, &FOUR));
    let inline = read(&gltf(&format!(r#""uri": "data:image/png;base64,{data}""#), PLAIN, ""));
    assert_eq!(texture(&inline.scene.materials[0]).picture.rgba, FOUR);
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a b.png"), png(2, 2, &FOUR)).unwrap();
    let file = gltf(r#""uri": "a%20b.png""#, PLAIN, "");
    let beside = import(Format::Gltf, &file, Some(folder.path()), &Limits::default()).unwrap();
    let picture = &texture(&beside.scene.materials[0]).picture;
    assert_eq!((picture.rgba.as_slice(), picture.name.as_str()), (&FOUR[..], "a b.png"));
}

#[test]
fn gltf_transforms_choose_place_and_coordinates() {
    let material = r#""pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "extensions": {"KHR_texture_transform":
        {"offset": [0, 1], "rotation": 1.57079632679, "scale": [0.5, 0.5], "texCoord": 1}}}}"#;
    let imported = read(&gltf(IN_BUFFER, material, r#", "extensionsUsed": ["KHR_texture_transform"]"#));
    let rows = texture(&imported.scene.materials[0]).transform;
    // The extension's own example: the lower left quarter of the picture.
    let expected = [[0.0, 0.5, 0.0], [-0.5, 0.0, 1.0]];
    for (a, b) in rows.iter().flatten().zip(expected.iter().flatten()) {
        assert!((a - b).abs() < 1e-6, "{rows:?}");
    }
    assert_eq!(meshes(&imported.scene)[0].texcoords, [[0.0, 1.0], [1.0, 0.0], [0.2, 0.2]]);
}

#[test]
fn gltf_alpha_is_opacity_or_a_mask() {
    let with = |mode: &str, alpha: f64, picture: bool| {
        let picture = if picture { r#""baseColorTexture": {"index": 0},"# } else { "" };
        let material = format!(
            r#""alphaMode": "{mode}", "pbrMetallicRoughness": {{ {picture} "baseColorFactor": [1, 1, 1, {alpha}]}}"#
        );
        let material = read(&gltf(IN_BUFFER, &material, "")).scene.materials[0].clone();
        (material.opacity, material.texture.map(|texture| texture.alpha))
    };
    assert_eq!(with("OPAQUE", 0.5, true), (1.0, Some(TextureAlpha::Ignored)));
    assert_eq!(with("BLEND", 0.5, true), (0.5, Some(TextureAlpha::Blend)));
    assert_eq!(with("MASK", 1.0, true), (1.0, Some(TextureAlpha::Mask(0.5))));
    assert_eq!(with("MASK", 0.25, true), (0.0, Some(TextureAlpha::Ignored)));
    assert_eq!(with("BLEND", 0.25, false), (0.25, None));
    assert_eq!(with("MASK", 0.25, false), (0.0, None));
    assert_eq!(with("MASK", 0.75, false), (1.0, None));
}

#[test]
fn gltf_emission_is_the_factor_times_its_strength() {
    let glow = r#""emissiveFactor": [1, 0.5, 0], "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 3}}"#;
    let material = &read(&gltf(IN_BUFFER, glow, "")).scene.materials[0];
    assert_eq!(<[f64; 3]>::from(material.emission), [3.0, 1.5, 0.0]);
    assert_eq!(material.ambient, 0.1);
    let pictured = format!(r#"{glow}, "emissiveTexture": {{"index": 0}}"#);
    let imported = read(&gltf(IN_BUFFER, &pictured, ""));
    assert_eq!(<[f64; 3]>::from(imported.scene.materials[0].emission), [0.0; 3]);
    assert_eq!(messages(&imported), ["emission textures ignored, at material 0"]);
}

#[test]
fn gltf_pictures_that_cannot_be_had_are_said() {
    for (image, why) in [
        (r#""uri": "none.png""#, "the scene has no folder"),
        (r#""uri": "data:image/png;base64,AAAA""#, "neither PNG nor JPEG"),
        (r#""bufferView": 0, "mimeType": "image/png""#, "neither PNG nor JPEG"),
    ] {
        let imported = read(&gltf(image, PLAIN, ""));
        assert_eq!(imported.scene.materials[0].texture, None);
        assert!(meshes(&imported.scene)[0].texcoords.is_empty());
        let said = messages(&imported);
        assert!(said.len() == 1 && said[0].contains(why) && said[0].ends_with("at material 0"), "{said:?}");
    }
    // No kind of image at all, and one without the type that the format demands.
    for image in ["", r#""bufferView": 3"#, r#""bufferView": 99, "mimeType": "image/png""#] {
        let _ = import(Format::Gltf, &gltf(image, PLAIN, ""), None, &Limits::default());
    }
}

#[test]
fn gltf_meshes_without_coordinates_are_said() {
    let material = r#""pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "texCoord": 5}}"#;
    let imported = read(&gltf(IN_BUFFER, material, ""));
    assert_eq!(
        messages(&imported),
        ["mesh without the coordinates of its texture, at primitive 0 of mesh 0"]
    );
}

#[test]
fn gltf_nodes_share_their_mesh() {
    let file = String::from_utf8(gltf(IN_BUFFER, PLAIN, "")).unwrap();
    let file = file.replace(r#""nodes": [0]"#, r#""nodes": [0, 1, 2]"#).replace(
        r#""nodes": [{"mesh": 0}]"#,
        r#""nodes": [{"mesh": 0}, {"mesh": 0, "translation": [5, 0, 0]}, {"mesh": 0, "scale": [1, 0, 1]}, {"mesh": 0, "scale": [-1, 1, 1]}]"#,
    );
    let imported = read(file.replace("[0, 1, 2]", "[0, 1, 2, 3]").as_bytes());
    let meshes = meshes(&imported.scene);
    // The flat one has nothing to show.
    assert_eq!(meshes.len(), 3, "{:?}", messages(&imported));
    assert!(meshes.iter().all(|mesh| Arc::ptr_eq(mesh, &meshes[0])));
    let bounds = imported.scene.bounds().unwrap();
    assert_eq!((bounds[0].x, bounds[1].x), (-2.0, 7.0));
    // What just suffices for one of them does not for three.
    let once = file.replace("[0, 1, 2]", "[0]");
    let limits = |memory: u64| Limits { memory, ..Limits::default() };
    let suffices = |memory: &u64| import(Format::Gltf, once.as_bytes(), None, &limits(*memory)).is_ok();
    let memory = (0..1 << 20).step_by(64).find(suffices).unwrap();
    let error = import(Format::Gltf, file.as_bytes(), None, &limits(memory)).unwrap_err().to_string();
    assert!(error.starts_with("with 3 instances it needs"), "{error}");
}

const OBJ: &str = "mtllib sub/a.mtl\nv 0 0 0\nv 2 0 0\nv 0 1 0\nv 2 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvt 1 1 0\nvt 0.5 0.5\n\
                   usemtl wood\nf 1/1 2/2 3/3\nf 2/5 4/4 3/3\n";

fn obj(folder: &Path, mtl: &str) -> Imported {
    fs::create_dir_all(folder.join("sub")).unwrap();
    fs::write(folder.join("sub/a.mtl"), mtl).unwrap();
    fs::write(folder.join("sub/my wood.png"), png(2, 2, &FOUR)).unwrap();
    fs::write(folder.join("secret.png"), png(2, 2, &FOUR)).unwrap();
    import(Format::Obj, OBJ.as_bytes(), Some(folder), &Limits::default()).unwrap()
}

#[test]
fn obj_pictures_are_beside_their_library() {
    let folder = tempfile::tempdir().unwrap();
    let imported =
        obj(folder.path(), "newmtl wood\nKd 0 0 0\nKe 1 1 2\nmap_Kd -s 2 2 -clamp on .\\my wood.png\n");
    assert_eq!(messages(&imported), [""; 0]);
    let material = &imported.scene.materials[0];
    assert_eq!(<[f64; 3]>::from(material.color), [1.0; 3]);
    assert_eq!(material.emission.b, 2.0);
    let texture = texture(material);
    assert_eq!((texture.wrap, texture.picture.rgba.as_slice()), ([Wrap::Clamp; 2], &FOUR[..]));
    assert_eq!(texture.transform, [[2.0, 0.0, 0.0], [0.0, 2.0, -1.0]]);
    // v points up in OBJ. Point 2 has two places in the picture.
    let mesh = &meshes(&imported.scene)[0];
    assert_eq!((mesh.positions.len(), mesh.triangles.len()), (5, 2));
    let corners: Vec<[f64; 2]> =
        mesh.triangles.iter().flatten().map(|&i| mesh.texcoords[i as usize]).collect();
    assert_eq!(corners, [[0.0, 1.0], [1.0, 1.0], [0.0, 0.0], [0.5, 0.5], [1.0, 0.0], [0.0, 0.0]]);
}

#[test]
fn obj_pictures_that_cannot_be_had_are_said() {
    let folder = tempfile::tempdir().unwrap();
    for (map, why) in [
        ("none.png", "no such file"),
        ("..\\..\\secret.png", "outside the scene's folder"),
        ("C:\\x\\none.png", "no such file"),
        ("a.mtl", "neither PNG nor JPEG"),
    ] {
        let imported = obj(folder.path(), &format!("newmtl wood\nmap_Kd {map}\n"));
        let said = messages(&imported);
        assert!(said.len() == 1 && said[0].contains(why), "{map}: {said:?}");
        let mesh = &meshes(&imported.scene)[0];
        assert_eq!((mesh.positions.len(), mesh.texcoords.len()), (4, 0));
    }
    // A path of another machine: the file of that name beside the library is meant.
    let imported = obj(
        folder.path(),
        "newmtl wood\nmap_Kd C:\\them\\my wood.png\nmap_d x.png\nmap_Ke y.png\nKe 1 1 1\n",
    );
    assert!(imported.scene.materials[0].texture.is_some());
    assert_eq!(imported.scene.materials[0].emission.r, 0.0);
    assert_eq!(
        messages(&imported),
        ["`map_d` of materials ignored, at `wood`", "`map_Ke` of materials ignored, at `wood`"]
    );
}

#[test]
fn a_file_with_a_picture_is_loaded_from_its_folder() {
    let folder = tempfile::tempdir().unwrap();
    obj(folder.path(), "newmtl wood\nmap_Kd my wood.png\n");
    let path = folder.path().join("a.obj");
    fs::write(&path, OBJ).unwrap();
    assert!(load(&path, &Limits::default()).unwrap().scene.materials[0].texture.is_some());
}

const PLY: &str = "ply\nformat ascii 1.0\ncomment TextureFile four.png\nelement vertex 3\nproperty float x\nproperty float y\n\
                   property float z\nproperty float s\nproperty float t\nelement face 1\n\
                   property list uchar int vertex_indices\nend_header\n0 0 0 0 0\n2 0 0 1 0\n0 1 0 0 0.75\n3 0 1 2\n";

#[test]
fn ply_names_its_picture_in_a_comment() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("four.png"), png(2, 2, &FOUR)).unwrap();
    let imported = import(Format::Ply, PLY.as_bytes(), Some(folder.path()), &Limits::default()).unwrap();
    assert_eq!(messages(&imported), [""; 0]);
    let object = &imported.scene.objects[0];
    assert_eq!(texture(&imported.scene.materials[object.material.0 as usize]).picture.rgba, FOUR);
    assert_eq!(meshes(&imported.scene)[0].texcoords, [[0.0, 1.0], [1.0, 1.0], [0.0, 0.25]]);
    let alone = import(Format::Ply, PLY.as_bytes(), None, &Limits::default()).unwrap();
    assert_eq!(messages(&alone), ["the picture `four.png` cannot be read: the scene has no folder"]);
    assert!(meshes(&alone.scene)[0].texcoords.is_empty());
    let other = PLY.replace("float s\n", "float texture_u\n").replace("float t\n", "float texture_v\n");
    let imported = import(Format::Ply, other.as_bytes(), Some(folder.path()), &Limits::default()).unwrap();
    assert_eq!(meshes(&imported.scene)[0].texcoords.len(), 3);
}

#[test]
fn pictures_are_lost_on_other_ray_tracers() {
    let scene = read(&gltf(IN_BUFFER, PLAIN, "")).scene;
    for format in [Format::Pov, Format::Dat] {
        let report = brt_formats::write(format, &scene).unwrap().report;
        let said =
            report.diagnostics.iter().any(|d| d.message.starts_with("pictures on surfaces are left out"));
        assert!(said, "{report:?}");
    }
}
