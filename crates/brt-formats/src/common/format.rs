//! The scene formats and their names. What is read of them and what is written is for [`read`](crate::read) and
//! [`write`](mod@crate::write) to say.

use std::path::Path;

/// Makes the formats: each with what it is, its name, and the extensions of its files, the usual one first.
macro_rules! formats {
    ($($(#[$doc:meta])* $format:ident, $name:literal, $extensions:expr;)*) => {
        /// A scene format.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum Format {
            $($(#[$doc])* $format,)*
        }

        impl Format {
            /// Every format, for listings.
            pub const ALL: [Self; [$(stringify!($format)),*].len()] = [$(Self::$format),*];

            /// Name for people.
            pub fn name(self) -> &'static str {
                match self {
                    $(Self::$format => $name,)*
                }
            }

            /// File name extensions, without the dot, in lower case; the usual one first.
            pub fn extensions(self) -> &'static [&'static str] {
                match self {
                    $(Self::$format => &$extensions,)*
                }
            }
        }
    };
}

formats! {
    /// Our own format, described in `docs/scene-format.md`.
    Toml, "TOML scene", ["toml"];
    /// Neutral File Format (Haines 1987), as the Standard Procedural Databases write it.
    Nff, "Neutral File Format", ["nff"];
    /// Triangles for 3D printing, binary or as text.
    Stl, "STL mesh", ["stl"];
    /// Polygons with attributes (Stanford), binary or as text.
    Ply, "PLY mesh", ["ply"];
    /// Object File Format (Geomview): polygons as text.
    Off, "Object File Format", ["off"];
    /// Wavefront OBJ with its materials (MTL).
    Obj, "Wavefront OBJ", ["obj"];
    /// glTF 2.0, as JSON or binary (GLB).
    Gltf, "glTF 2.0", ["gltf", "glb"];
    /// 3D Manufacturing Format.
    ThreeMf, "3D Manufacturing Format", ["3mf"];
    /// The Virtual Reality Modeling Language of 1997.
    Vrml, "VRML97", ["wrl", "vrml"];
    /// The scene description language of POV-Ray 3.7.
    Pov, "POV-Ray scene", ["pov"];
    /// The model files of the Tachyon ray tracer.
    Dat, "Tachyon scene", ["dat"];
}

impl Format {
    /// Is it for other programs, and no build reads it?
    pub(crate) fn is_only_written(self) -> bool {
        matches!(self, Self::Pov | Self::Dat)
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
}
