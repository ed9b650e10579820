//! Our own format with files beside it: pictures and meshes, read and written.

use std::fs;
use std::path::Path;
use std::sync::Arc;

use crate::common::{EVERYTHING, FOUR, good, png};
use brt_formats::{Format, Limits, ParseError, Written, import, load, write_beside, write_toml};
use brt_geometry::{Affine, vec3};
use brt_image::rgb;
use brt_scene::{MaterialId, Mesh, Object, Scene, Shape, Texels, Texture, TextureAlpha, TextureFilter, Wrap};

const CAMERA: &str = "[camera]\neye = [0, 0, 5]\nlook_at = [0, 0, 0]\nfov_deg = 45\n";
const CORNER: &str = "OFF\n3 1 0\n0 0 0\n2 0 0\n0 1 0\n3 0 1 2\n";

/// A folder with a picture, a mesh, and a secret outside.
fn folder() -> (tempfile::TempDir, std::path::PathBuf) {
    let root = tempfile::tempdir().unwrap();
    let folder = root.path().join("scene");
    fs::create_dir(&folder).unwrap();
    fs::write(folder.join("four.png"), png(2, 2, &FOUR)).unwrap();
    fs::write(folder.join("corner.off"), CORNER).unwrap();
    fs::write(folder.join("scene.toml"), CAMERA).unwrap();
    fs::write(root.path().join("secret.png"), png(2, 2, &FOUR)).unwrap();
    (root, folder)
}

fn read(folder: &Path, text: &str) -> Result<Scene, Vec<String>> {
    let text = format!("{CAMERA}{text}");
    match import(Format::Toml, text.as_bytes(), Some(folder), &Limits::default()) {
        Ok(imported) => Ok(imported.scene.into_inner()),
        Err(ParseError::Malformed(report)) => Err(report
            .diagnostics
            .iter()
            .map(|d| {
                let line = d.span.as_ref().map_or(0, |span| text[..span.start].matches('\n').count() + 1);
                let expected = d.expected.as_ref().map(|e| format!(", expected {e}")).unwrap_or_default();
                format!("{line}: {}{expected}", d.message)
            })
            .collect()),
        Err(error) => panic!("{error}"),
    }
}

fn material(texture: &str) -> String {
    format!("[materials.m]\ncolor = [1, 1, 1]\ntexture = {{ {texture} }}\n")
}

#[test]
fn textures_are_read() {
    let (_root, folder) = folder();
    let scene = read(&folder, &material("file = \"four.png\"")).unwrap();
    let texture = scene.materials[0].texture.clone().unwrap();
    assert_eq!(texture, Texture::new(texture.picture.clone()));
    assert_eq!(texture.picture.rgba, FOUR);
    let all = "file = \"four.png\", wrap = [\"mirror\", \"clamp\"], filter = \"nearest\", mask = 0.25, \
               transform = [[1, 2, 3], [4, 5, 6]]";
    let texture = read(&folder, &material(all)).unwrap().materials[0].texture.clone().unwrap();
    assert_eq!((texture.wrap, texture.filter), ([Wrap::Mirror, Wrap::Clamp], TextureFilter::Nearest));
    assert_eq!(texture.alpha, TextureAlpha::Mask(0.25));
    assert_eq!(texture.transform, [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]);
}

#[test]
fn faults_of_textures_are_said() {
    let (_root, folder) = folder();
    let fault = |texture: &str| read(&folder, &material(texture)).unwrap_err();
    const FILE: &str = "expected a PNG or JPEG file in the scene's folder";
    for (texture, message) in [
        ("file = \"none.png\"", format!("7: `none.png` cannot be read: no such file, {FILE}")),
        ("file = \"corner.off\"", format!("7: `corner.off` cannot be read: it is neither PNG nor JPEG, {FILE}")),
        ("wrap = \"clamp\"", "7: the texture has no `file`, expected `file = ...`".into()),
        (
            "file = \"four.png\", wrap = \"clam\"",
            "7: unknown wrap \"clam\", did you mean `clamp`?, expected one of \"repeat\", \"mirror\", \"clamp\"".into(),
        ),
        (
            "file = \"four.png\", wrap = [\"clamp\"]",
            "7: found a list of 1 value, expected a word, or one for u and one for v".into(),
        ),
        (
            "file = \"four.png\", transform = [[1, 0], [0, 1]]",
            "7: found a list of 2 values, expected a row of three numbers".into(),
        ),
        ("file = \"four.png\", alpha = \"blend\", mask = 0.5", "7: the texture has both `alpha` and `mask`, expected one of them".into()),
        ("file = \"four.png\", mask = 2", "7: the mask's cutoff is 2, expected a number from 0 to 1".into()),
        ("data = \"AAAA\"", "7: the picture cannot be read: it is neither PNG nor JPEG, expected a PNG or JPEG file in base64".into()),
        ("file = \"four.png\", name = \"x\"", "7: only `data` has a name, expected `file` alone".into()),
    ] {
        assert_eq!(fault(texture), [message], "{texture}");
    }
    assert!(fault("file = \"../secret.png\"")[0].contains("--allow-outside"));
    assert!(fault("file = \"four.png\", fiter = 1")[0].contains("did you mean `filter`?"));
    fs::write(folder.join("cut.png"), &png(2, 2, &FOUR)[..50]).unwrap();
    assert!(fault("file = \"cut.png\"")[0].starts_with("7: `cut.png` cannot be read: "));
}

#[test]
fn wrong_counts_of_coordinates_are_said() {
    let (_root, folder) = folder();
    let mesh = "[materials.m]\ncolor = [1, 1, 1]\n[[object]]\ntype = \"mesh\"\nmaterial = \"m\"\n\
                positions = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]\ntriangles = [[0, 1, 2]]\n";
    let with = |coordinates: &str| read(&folder, &format!("{mesh}texcoords = {coordinates}\n"));
    assert_eq!(
        with("[[0, 0], [1, 1]]").unwrap_err(),
        ["12: 2 texture coordinates for 3 positions, expected a pair per position, or none"]
    );
    assert_eq!(
        with("[[0, 0, 0]]").unwrap_err(),
        ["12: found a list of 3 values, expected two numbers, [u, v]"]
    );
    assert!(with("[[0, 0], [1, 1], [0.5, -2]]").is_ok());
}

fn imported(file: &str) -> String {
    format!(
        "[materials.m]\ncolor = [1, 1, 1]\n[[object]]\ntype = \"mesh\"\nmaterial = \"m\"\nimport = \"{file}\"\n"
    )
}

#[test]
fn meshes_are_imported() {
    let (_root, folder) = folder();
    let text = imported("corner.off") + "transform = [[1, 0, 0, 5], [0, 1, 0, 0], [0, 0, 1, 0]]\n";
    let scene = read(&folder, &text).unwrap();
    assert_eq!((scene.objects.len(), scene.materials.len()), (1, 1));
    assert_eq!(scene.bounds().unwrap()[1], vec3(7.0, 1.0, 0.0));
    let one = imported("corner.off");
    let object = &one[one.find("[[object]]").unwrap()..];
    let twice = read(&folder, &format!("{one}{object}")).unwrap();
    let [a, b] = &twice.objects[..] else { panic!("two objects") };
    assert!(matches!((&a.shape, &b.shape), (Shape::Mesh(a), Shape::Mesh(b)) if Arc::ptr_eq(a, b)));
    fs::write(
        folder.join("a.obj"),
        "mtllib no.mtl\nusemtl x\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0.25\nf 1/1 2/1 3/1\n",
    )
    .unwrap();
    let scene = read(&folder, &imported("a.obj")).unwrap();
    assert!(matches!(&scene.objects[0].shape, Shape::Mesh(mesh) if mesh.texcoords == [[0.0, 0.75]; 3]));
}

#[test]
fn faults_of_imports_are_said() {
    let (_root, folder) = folder();
    const FILE: &str = "expected a PLY, STL, OBJ or OFF file in the scene's folder";
    fs::write(folder.join("bad.off"), CORNER.replace("3 0 1 2", "3 0 1 9")).unwrap();
    for (file, why) in [
        ("scene.toml", "it is a TOML scene"),
        ("none.ply", "no such file"),
        ("four.png", "its format is not known"),
    ] {
        let found = read(&folder, &imported(file)).unwrap_err();
        assert_eq!(found, [format!("10: `{file}` cannot be read: {why}, {FILE}")]);
    }
    assert!(read(&folder, &imported("bad.off")).unwrap_err()[0].contains("uses point 9"));
    assert!(read(&folder, &imported("../corner.off")).unwrap_err()[0].contains("--allow-outside"));
    let both = imported("corner.off") + "positions = []\n";
    assert!(read(&folder, &both).unwrap_err()[0].contains("a field of its own beside `import`"));
}

/// Scene with everything, a picture on a material, and a large mesh that is there twice.
fn rich() -> Scene {
    let (mut scene, _) = good(Format::Toml, EVERYTHING);
    let picture = Texels { name: "a/fo ur.png".into(), width: 2, height: 2, rgba: FOUR.to_vec() };
    scene.materials[0].texture = Some(Texture { wrap: [Wrap::Clamp; 2], ..Texture::new(Arc::new(picture)) });
    scene.materials[1].texture = scene.materials[0].texture.clone();
    let i = |i: u32| f64::from(i);
    let mesh = Mesh {
        positions: (0..100).map(|p| vec3(i(p) / 3.0, libm::sin(i(p) * 0.7), -0.0)).collect(),
        normals: (0..100).map(|p| vec3(0.1, i(p), 1e-9)).collect(),
        colors: (0..100).map(|p| rgb(-i(p) / 7.0, 1.0, 5e-324)).collect(),
        texcoords: (0..100).map(|p| [i(p) / 9.0, -1e6 / (1.0 + i(p))]).collect(),
        // Some without an area.
        triangles: (0..1200).map(|t| [t % 100, (t * 7) % 100, (t * 13 + 1) % 100]).collect(),
    };
    let flat = Mesh { normals: Vec::new(), colors: Vec::new(), texcoords: Vec::new(), ..mesh.clone() };
    let object = Object::new(mesh.into(), MaterialId(0));
    let moved = Affine::from_rows([[1.0, 0.0, 0.0, 3.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, -1.0, 0.0]]);
    scene.objects.push(Object { name: Some("big one".into()), ..object.clone() });
    scene.objects.push(Object { transform: moved, ..object });
    scene.objects.push(Object { name: Some("Big-One".into()), ..Object::new(flat.into(), MaterialId(1)) });
    scene
}

#[test]
fn a_scene_with_files_beside_it_comes_back() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("out.toml");
    let mut scene = rich();
    let Written { text, files, report } = write_beside(Format::Toml, &scene, &path).unwrap();
    assert!(report.diagnostics.is_empty());
    let names: Vec<&str> = files.iter().map(|file| file.name.as_str()).collect();
    assert_eq!(names, ["out.fo-ur.png", "out.big-one.ply", "out.Big-One-2.ply"]);
    fs::write(&path, &text).unwrap();
    files.iter().for_each(|file| fs::write(folder.path().join(&file.name), &file.bytes).unwrap());
    let again = load(&path, &Limits::default()).unwrap();
    // All materials have the picture, and most objects cannot show it.
    let unseen = again.report.diagnostics.iter().all(|d| d.message.contains("texture not seen"));
    assert!(unseen, "{:?}", again.report);
    // The picture is now called what its file is.
    for material in &mut scene.materials {
        let texture = material.texture.as_mut().unwrap();
        Arc::make_mut(&mut texture.picture).name = "out.fo-ur.png".into();
    }
    assert_eq!(again.scene, scene);
    // It lies there now and is named as it is; the meshes are written again, bit by bit.
    let once_more = write_beside(Format::Toml, &again.scene, &path).unwrap();
    assert_eq!((&once_more.text, &once_more.files[..]), (&text, &files[1..]));
}

#[test]
fn a_scene_in_one_text_comes_back() {
    let scene = rich();
    let text = write_toml(&scene);
    assert_eq!(text.matches("data = ").count(), 1);
    assert_eq!(good(Format::Toml, &text).0, scene);
}
