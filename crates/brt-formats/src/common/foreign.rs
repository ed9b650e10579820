//! Formats that people try and that are not read, with a word on what to do instead.

use std::fmt;
use std::path::Path;

/// A format that is known but not read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Foreign {
    /// Name for people.
    pub name: &'static str,
    /// What to do instead.
    pub advice: &'static str,
    extensions: &'static [&'static str],
    /// What its files begin with, if that is sure.
    start: Option<&'static [u8]>,
}

const EXPORT_PART: &str = "export STL, 3MF or GLB";
const EXPORT_SCENE: &str = "export GLB or OBJ";
const EXPORT_MOLECULE: &str = "save VRML from PyMOL (`save x.wrl`)";

const fn foreign(
    name: &'static str,
    advice: &'static str,
    extensions: &'static [&'static str],
    start: Option<&'static [u8]>,
) -> Foreign {
    Foreign { name, advice, extensions, start }
}

impl Foreign {
    /// Scenes, parts and molecules.
    pub const ALL: [Self; 16] = [
        foreign("STEP", EXPORT_PART, &["step", "stp", "p21"], Some(b"ISO-10303-21;")),
        foreign("IGES", EXPORT_PART, &["iges", "igs"], None),
        foreign("OpenCASCADE BREP", EXPORT_PART, &["brep", "brp"], Some(b"DBRep_DrawableShape")),
        foreign("FreeCAD", EXPORT_PART, &["fcstd"], None),
        foreign("OpenSCAD", "`openscad -o part.3mf part.scad` writes what can be read", &["scad"], None),
        foreign("SolidWorks", EXPORT_PART, &["sldprt", "sldasm"], None),
        foreign("AMF", EXPORT_PART, &["amf"], None),
        foreign("G-code", EXPORT_PART, &["gcode"], None),
        foreign("KiCad board", "`kicad-cli pcb export glb` writes what can be read", &["kicad_pcb"], None),
        foreign("Blender", EXPORT_SCENE, &["blend"], Some(b"BLENDER")),
        foreign("FBX", EXPORT_SCENE, &["fbx"], Some(b"Kaydara FBX Binary")),
        foreign("COLLADA", EXPORT_SCENE, &["dae"], None),
        foreign("3D Studio", EXPORT_SCENE, &["3ds", "max"], None),
        foreign("USD", EXPORT_SCENE, &["usd", "usda", "usdc", "usdz"], Some(b"PXR-USDC")),
        foreign("X3D", "export VRML97, GLB or OBJ", &["x3d"], None),
        foreign("molecule", EXPORT_MOLECULE, &["pdb", "cif", "xyz", "sdf", "mol", "mol2", "gro"], None),
    ];
    /// What shows no scene to a reader of scenes.
    const PICTURE: Self =
        foreign("picture", "not a scene", &["png", "jpg", "jpeg", "exr", "ppm"], Some(b"\x89PNG"));

    /// The format that a file's name or else its beginning tells.
    pub fn of(path: &Path, bytes: &[u8]) -> Option<Self> {
        let extension = path.extension().and_then(|e| e.to_str()).unwrap_or_default().to_ascii_lowercase();
        let all = || Self::ALL.into_iter().chain([Self::PICTURE]);
        let by_name = all().find(|f| f.extensions.contains(&extension.as_str()));
        by_name.or_else(|| all().find(|f| f.start.is_some_and(|start| bytes.starts_with(start))))
    }
}

/// Fits behind the file's name.
impl fmt::Display for Foreign {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { name, advice, .. } = self;
        if *self == Self::PICTURE {
            return write!(f, "a {name}, {advice}");
        }
        write!(f, "{name} files are not read; {advice}")
    }
}
