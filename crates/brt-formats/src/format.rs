//! The scene formats and how they are told apart.

use std::path::Path;

/// A scene format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// Our own format, described in `docs/scene-format.md`.
    Toml,
    /// Neutral File Format (Haines 1987), as the Standard Procedural Databases write it.
    Nff,
    /// The scene description language of POV-Ray 3.7.
    Pov,
    /// The model files of the Tachyon ray tracer.
    Dat,
}

impl Format {
    /// Every format, for listings.
    pub const ALL: [Self; 4] = [Self::Toml, Self::Nff, Self::Pov, Self::Dat];

    /// Name for people.
    pub fn name(self) -> &'static str {
        match self {
            Self::Toml => "TOML scene",
            Self::Nff => "Neutral File Format",
            Self::Pov => "POV-Ray scene",
            Self::Dat => "Tachyon scene",
        }
    }

    /// File name extensions, without the dot, in lower case; the usual one first.
    pub fn extensions(self) -> &'static [&'static str] {
        match self {
            Self::Toml => &["toml"],
            Self::Nff => &["nff"],
            Self::Pov => &["pov"],
            Self::Dat => &["dat"],
        }
    }

    /// Can it be read?
    pub fn reads(self) -> bool {
        matches!(self, Self::Toml | Self::Nff)
    }

    /// Can it be written?
    pub fn writes(self) -> bool {
        matches!(self, Self::Toml | Self::Pov | Self::Dat)
    }

    /// The format that a path's extension names, whatever its case.
    pub fn from_path(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_str()?.to_ascii_lowercase();
        Self::ALL.into_iter().find(|f| f.extensions().contains(&extension.as_str()))
    }

    /// The format that content looks like, by its first line that is neither blank nor a comment (both formats
    /// that are read comment with `#`).
    pub fn from_content(bytes: &[u8]) -> Option<Self> {
        const COMMANDS: [&[u8]; 9] = [b"v", b"b", b"l", b"f", b"s", b"c", b"p", b"pp", b"from"];
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        let mut lines = bytes.split(|&b| b == b'\n' || b == b'\r').map(<[u8]>::trim_ascii);
        let line = lines.find(|line| !line.is_empty() && !line.starts_with(b"#"))?;
        if line.starts_with(b"[") || line.contains(&b'=') {
            return Some(Self::Toml);
        }
        let first = line.split(u8::is_ascii_whitespace).next()?;
        COMMANDS.contains(&first).then_some(Self::Nff)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn extension_decides_whatever_its_case() {
        assert_eq!(Format::from_path(Path::new("a/b.TOML")), Some(Format::Toml));
        assert_eq!(Format::from_path(Path::new("b.nff")), Some(Format::Nff));
        assert_eq!(Format::from_path(Path::new("b.pov")), Some(Format::Pov));
        assert_eq!(Format::from_path(Path::new("toml")), None);
    }

    #[test]
    fn content_is_told_by_its_first_line() {
        assert_eq!(Format::from_content(b"# x\n\n size = [1, 2]"), Some(Format::Toml));
        assert_eq!(Format::from_content(b"# x\r\n[camera]"), Some(Format::Toml));
        assert_eq!(Format::from_content(b"#x\nb 1 2 3"), Some(Format::Nff));
        assert_eq!(Format::from_content(b"solid cube"), None);
        assert_eq!(Format::from_content(b""), None);
        assert_eq!(Format::from_content(&[0; 100]), None);
    }
}
