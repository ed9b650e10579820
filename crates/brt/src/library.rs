//! Scenes by name: the reconstructed seed scenes of the paper, and the procedural ones.

use brt_formats::{Format, Limits, parse};
use brt_procedural::{self as procedural, Procedural, SizeError};
use brt_scene::Scene;
use thiserror::Error;

/// A scene that can be had by name.
#[derive(Clone, Copy, Debug)]
pub struct NamedScene {
    /// Name on the command line.
    pub name: &'static str,
    /// What is seen, in a line.
    pub summary: &'static str,
    source: Source,
}

#[derive(Clone, Copy, Debug)]
enum Source {
    Text(&'static str),
    Program(&'static Procedural),
}

/// Why a named scene could not be had.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum NamedSceneError {
    /// The scene comes in one size only.
    #[error("scene `{name}` has no size to choose")]
    NoSize {
        /// The scene.
        name: &'static str,
    },
    /// The size is out of range.
    #[error(transparent)]
    Size(#[from] SizeError),
}

const SEEDS: [NamedScene; 3] = [
    NamedScene {
        name: "seed-a",
        summary: "two mirror planes, a mirror ball and a matte ball (scene A of the paper)",
        source: Source::Text(include_str!("../../../scenes/seed/a.toml")),
    },
    NamedScene {
        name: "seed-b",
        summary: "49 mirror balls over a matte plane (scene B of the paper)",
        source: Source::Text(include_str!("../../../scenes/seed/b.toml")),
    },
    NamedScene {
        name: "seed-c",
        summary: "71 polygons, 57 of them mirrors (scene C of the paper)",
        source: Source::Text(include_str!("../../../scenes/seed/c.toml")),
    },
];

/// All named scenes, in the order in which they are listed.
pub fn all() -> impl Iterator<Item = NamedScene> {
    let program =
        |p: &'static Procedural| NamedScene { name: p.name, summary: p.summary, source: Source::Program(p) };
    SEEDS.into_iter().chain(procedural::ALL.iter().map(program))
}

/// The scene with this name.
pub fn find(name: &str) -> Option<NamedScene> {
    all().find(|scene| scene.name == name)
}

impl NamedScene {
    /// What its size counts and which one it has by default; `None` where it comes in one size only.
    pub fn size(&self) -> Option<(&'static str, u32)> {
        match self.source {
            Source::Text(_) => None,
            Source::Program(p) => Some((p.size_meaning, p.default_size)),
        }
    }

    /// Builds the scene, at its default size if none is given.
    ///
    /// # Errors
    /// If the size is out of range, or the scene has none to choose.
    pub fn build(&self, size: Option<u32>) -> Result<Scene, NamedSceneError> {
        match (self.source, size) {
            (Source::Program(p), size) => Ok(p.build(size)?),
            (Source::Text(_), Some(_)) => Err(NamedSceneError::NoSize { name: self.name }),
            (Source::Text(text), None) => {
                let parsed = parse(Format::Toml, text.as_bytes(), &Limits::default());
                Ok(parsed.expect("a test parses every scene of the library").0.into_inner())
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seed_scenes_parse_and_have_the_papers_number_of_objects() {
        for (name, count) in [("seed-a", 4), ("seed-b", 50), ("seed-c", 71)] {
            assert_eq!(find(name).unwrap().build(None).unwrap().objects.len(), count, "{name}");
        }
    }

    #[test]
    fn names_are_unique() {
        let mut names: Vec<_> = all().map(|scene| scene.name).collect();
        names.sort_unstable();
        assert!(names.windows(2).all(|pair| pair[0] != pair[1]));
        assert!(find("teapot").is_none());
    }

    #[test]
    fn sizes_are_checked() {
        assert!(find("seed-a").unwrap().build(Some(3)).is_err());
        assert!(find("balls").unwrap().build(Some(99)).is_err());
        assert_eq!(find("balls").unwrap().build(Some(1)).unwrap().objects.len(), 11);
    }
}
