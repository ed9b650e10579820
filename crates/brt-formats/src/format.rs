//! The scene formats and how they are told apart.

use std::path::Path;

/// A scene format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// Our own format, described in `docs/scene-format.md`.
    Toml,
    /// Neutral File Format (Haines 1987), as the Standard Procedural Databases write it.
    Nff,
    /// Triangles for 3D printing, binary or as text.
    Stl,
    /// Polygons with attributes (Stanford), binary or as text.
    Ply,
    /// Object File Format (Geomview): polygons as text.
    Off,
    /// Wavefront OBJ with its materials (MTL).
    Obj,
    /// glTF 2.0, as JSON or binary (GLB).
    Gltf,
    /// 3D Manufacturing Format.
    ThreeMf,
    /// The Virtual Reality Modeling Language of 1997.
    Vrml,
    /// The scene description language of POV-Ray 3.7.
    Pov,
    /// The model files of the Tachyon ray tracer.
    Dat,
}

/// How a format is listed.
struct Entry {
    name: &'static str,
    /// The usual one first.
    extensions: &'static [&'static str],
    reads: bool,
    writes: bool,
}

impl Format {
    /// Every format, for listings.
    pub const ALL: [Self; 11] = [
        Self::Toml,
        Self::Nff,
        Self::Stl,
        Self::Ply,
        Self::Off,
        Self::Obj,
        Self::Gltf,
        Self::ThreeMf,
        Self::Vrml,
        Self::Pov,
        Self::Dat,
    ];

    fn entry(self) -> Entry {
        let read = |name, extensions| Entry { name, extensions, reads: true, writes: false };
        let write = |name, extensions| Entry { name, extensions, reads: false, writes: true };
        match self {
            Self::Toml => Entry { writes: true, ..read("TOML scene", &["toml"]) },
            Self::Nff => read("Neutral File Format", &["nff"]),
            Self::Stl => read("STL mesh", &["stl"]),
            Self::Ply => read("PLY mesh", &["ply"]),
            Self::Off => read("Object File Format", &["off"]),
            Self::Obj => read("Wavefront OBJ", &["obj"]),
            Self::Gltf => read("glTF 2.0", &["gltf", "glb"]),
            Self::ThreeMf => read("3D Manufacturing Format", &["3mf"]),
            Self::Vrml => read("VRML97", &["wrl", "vrml"]),
            Self::Pov => write("POV-Ray scene", &["pov"]),
            Self::Dat => write("Tachyon scene", &["dat"]),
        }
    }

    /// Name for people.
    pub fn name(self) -> &'static str {
        self.entry().name
    }

    /// File name extensions, without the dot, in lower case; the usual one first.
    pub fn extensions(self) -> &'static [&'static str] {
        self.entry().extensions
    }

    /// Can it be read?
    pub fn reads(self) -> bool {
        self.entry().reads
    }

    /// Can it be written?
    pub fn writes(self) -> bool {
        self.entry().writes
    }

    /// The format of this name, which is one of its extensions.
    pub fn from_name(name: &str) -> Option<Self> {
        let name = name.to_ascii_lowercase();
        Self::ALL.into_iter().find(|f| f.extensions().contains(&name.as_str()))
    }

    /// The format that a path's extension names, whatever its case.
    pub fn from_path(path: &Path) -> Option<Self> {
        Self::from_name(path.extension()?.to_str()?)
    }

    /// The format that content looks like: by what the format demands at its start, else by the first line that is
    /// neither blank nor a comment.
    pub fn from_content(bytes: &[u8]) -> Option<Self> {
        const COMMANDS: [&[u8]; 9] = [b"v", b"b", b"l", b"f", b"s", b"c", b"p", b"pp", b"from"];
        const OBJ: [&[u8]; 6] = [b"vn", b"vt", b"o", b"g", b"mtllib", b"usemtl"];
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        if let Some(format) = Self::from_start(bytes) {
            return Some(format);
        }
        let mut lines = bytes.split(|&b| b == b'\n' || b == b'\r').map(<[u8]>::trim_ascii);
        let line = lines.find(|line| !line.is_empty() && !line.starts_with(b"#"))?;
        if line.starts_with(b"[") || line.contains(&b'=') {
            return Some(Self::Toml);
        }
        let mut words = line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
        let first = words.next()?;
        // A view stands alone in NFF; a vertex has three numbers in OBJ.
        if OBJ.contains(&first) || (first == b"v" && words.next().is_some()) {
            return Some(Self::Obj);
        }
        COMMANDS.contains(&first).then_some(Self::Nff)
    }

    fn from_start(bytes: &[u8]) -> Option<Self> {
        let text = bytes.trim_ascii_start();
        let starts = |start: &[u8]| text.starts_with(start);
        if bytes.starts_with(b"glTF") || (starts(b"{") && names_asset(text)) {
            Some(Self::Gltf)
        } else if bytes.starts_with(b"PK\x03\x04") {
            Some(Self::ThreeMf)
        } else if starts(b"ply\n") || starts(b"ply\r") {
            Some(Self::Ply)
        } else if starts(b"#VRML") {
            Some(Self::Vrml)
        } else if starts(b"OFF") || starts(b"COFF") || starts(b"NOFF") {
            Some(Self::Off)
        } else if starts(b"solid") || crate::stl::is_binary(bytes) {
            Some(Self::Stl)
        } else {
            None
        }
    }
}

/// Any program may write JSON; that of glTF must have this property.
fn names_asset(json: &[u8]) -> bool {
    const ASSET: &[u8] = b"\"asset\"";
    json.windows(ASSET.len()).any(|window| window == ASSET)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn extension_decides_whatever_its_case() {
        assert_eq!(Format::from_path(Path::new("a/b.TOML")), Some(Format::Toml));
        assert_eq!(Format::from_path(Path::new("b.nff")), Some(Format::Nff));
        assert_eq!(Format::from_path(Path::new("b.GLB")), Some(Format::Gltf));
        assert_eq!(Format::from_path(Path::new("b.pov")), Some(Format::Pov));
        assert_eq!(Format::from_path(Path::new("toml")), None);
    }

    #[test]
    fn content_is_told_by_its_first_line() {
        assert_eq!(Format::from_content(b"# x\n\n size = [1, 2]"), Some(Format::Toml));
        assert_eq!(Format::from_content(b"# x\r\n[camera]"), Some(Format::Toml));
        assert_eq!(Format::from_content(b"#x\nb 1 2 3"), Some(Format::Nff));
        assert_eq!(Format::from_content(b"v\nfrom 1 2 3"), Some(Format::Nff));
        assert_eq!(Format::from_content(b"# x\nv 1 2 3"), Some(Format::Obj));
        assert_eq!(Format::from_content(b"mtllib a.mtl"), Some(Format::Obj));
        assert_eq!(Format::from_content(b"solid cube"), Some(Format::Stl));
        assert_eq!(Format::from_content(b"#VRML V2.0 utf8"), Some(Format::Vrml));
        assert_eq!(Format::from_content(b"{ \"asset\": {} }"), Some(Format::Gltf));
        assert_eq!(Format::from_content(b"{ \"chemicalJson\": 1 }"), None);
        assert_eq!(Format::from_content(b"ply\nformat ascii 1.0"), Some(Format::Ply));
        assert_eq!(Format::from_content(b""), None);
        assert_eq!(Format::from_content(b"hello"), None);
        assert_eq!(Format::from_content(&[0; 100]), None);
    }
}
