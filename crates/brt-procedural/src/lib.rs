//! Scenes made by programs: tests of the methods, standard scenes of the literature, and the show-piece.
//!
//! Every scene is a function of its size alone. The generators use only `+ - * / sqrt`, the pure-Rust `libm` and a
//! seeded generator of their own, so that all machines build the same numbers.

mod adversary;
mod blocks;
mod random;
mod spd;
mod torus;
mod watch;

use brt_scene::Scene;
use thiserror::Error;

/// A scene that a program builds.
#[derive(Clone, Copy, Debug)]
pub struct Procedural {
    /// Name on the command line.
    pub name: &'static str,
    /// What is seen, in a line.
    pub summary: &'static str,
    /// What the size counts.
    pub size_meaning: &'static str,
    /// Size where none is asked for.
    pub default_size: u32,
    /// Smallest size that makes a scene.
    pub least_size: u32,
    /// Greatest size: beyond it the scene would fill the memory.
    pub greatest_size: u32,
    build: fn(u32) -> Scene,
}

/// A size outside of what a procedural scene can be built with.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("size {size} of scene `{name}` ({meaning}): expected a number from {least} to {greatest}")]
pub struct SizeError {
    /// The scene.
    pub name: &'static str,
    /// What was asked for.
    pub size: u32,
    /// What the size counts.
    pub meaning: &'static str,
    /// Smallest size allowed.
    pub least: u32,
    /// Greatest size allowed.
    pub greatest: u32,
}

impl Procedural {
    /// Builds the scene, at its default size if none is given.
    ///
    /// # Errors
    /// If the size is outside `least_size..=greatest_size`.
    pub fn build(&self, size: Option<u32>) -> Result<Scene, SizeError> {
        let size = size.unwrap_or(self.default_size);
        if !(self.least_size..=self.greatest_size).contains(&size) {
            return Err(SizeError {
                name: self.name,
                size,
                meaning: self.size_meaning,
                least: self.least_size,
                greatest: self.greatest_size,
            });
        }
        Ok((self.build)(size))
    }
}

/// The procedural scene of this name.
pub fn find(name: &str) -> Option<&'static Procedural> {
    ALL.iter().find(|scene| scene.name == name)
}

/// All procedural scenes, in the order in which they are listed.
pub const ALL: &[Procedural] = &[
    Procedural {
        name: "watch",
        summary: "an opened watch movement on a dark mirror",
        size_meaning: "segments of a full turn in rounded outlines",
        default_size: 96,
        least_size: 24,
        greatest_size: 1_000,
        build: watch::build,
    },
    Procedural {
        name: "blocks",
        summary: "matte boxes on a floor: planar faces and their shadows, no mirrors",
        size_meaning: "number of boxes",
        default_size: 333,
        least_size: 1,
        greatest_size: 100_000,
        build: blocks::build,
    },
    Procedural {
        name: "torus",
        summary: "a bent torus, one smooth mesh over a floor",
        size_meaning: "number of triangles, about",
        default_size: 100_000,
        least_size: 100,
        greatest_size: 4_000_000,
        build: torus::matte,
    },
    Procedural {
        name: "mirror-torus",
        summary: "the bent torus as a mirror",
        size_meaning: "number of triangles, about",
        default_size: 100_000,
        least_size: 100,
        greatest_size: 4_000_000,
        build: torus::mirror,
    },
    Procedural {
        name: "adversary",
        summary: "tiny highlights, tiny mirrors, things seen only in a mirror or only as shadows",
        size_meaning: "number of tiny shiny balls; the others in proportion",
        default_size: 250,
        least_size: 1,
        greatest_size: 100_000,
        build: adversary::build,
    },
    Procedural {
        name: "balls",
        summary: "Haines' sphereflake (SPD 1987)",
        size_meaning: "depth of recursion; 4 gives 7381 spheres",
        default_size: 4,
        least_size: 1,
        greatest_size: 6,
        build: spd::balls,
    },
    Procedural {
        name: "gears",
        summary: "Haines' meshing gears, some of glass (SPD 1987)",
        size_meaning: "gears along each axis; 4 gives 9345 polygons",
        default_size: 4,
        least_size: 1,
        greatest_size: 16,
        build: spd::gears,
    },
    Procedural {
        name: "mount",
        summary: "Haines' fractal mountain with four glass balls (SPD 1987)",
        size_meaning: "depth of subdivision; 6 gives 8192 triangles",
        default_size: 6,
        least_size: 1,
        greatest_size: 10,
        build: spd::mount,
    },
    Procedural {
        name: "rings",
        summary: "Haines' pyramid of interlocking rings (SPD 1987)",
        size_meaning: "layers of the pyramid; 7 gives 8400 spheres and cylinders",
        default_size: 7,
        least_size: 1,
        greatest_size: 40,
        build: spd::rings,
    },
    Procedural {
        name: "tetra",
        summary: "Haines' Sierpiński tetrahedron (SPD 1987)",
        size_meaning: "depth of recursion; 6 gives 4096 triangles",
        default_size: 6,
        least_size: 1,
        greatest_size: 10,
        build: spd::tetra,
    },
    Procedural {
        name: "tree",
        summary: "Haines' recursive tree (SPD 1987)",
        size_meaning: "depth of branching; 11 gives 8190 cones and spheres",
        default_size: 11,
        least_size: 1,
        greatest_size: 18,
        build: spd::tree,
    },
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_scene_can_be_rendered_at_its_default_and_at_its_least_size() {
        for scene in ALL {
            for size in [None, Some(scene.least_size), Some(scene.least_size + 1)] {
                let problems = scene.build(size).unwrap().check();
                assert_eq!(problems, [], "{} at {size:?}", scene.name);
            }
        }
    }

    #[test]
    fn scenes_are_the_same_every_time() {
        for scene in ALL {
            assert!(scene.build(None) == scene.build(None), "{}", scene.name);
        }
    }

    #[test]
    fn material_names_are_unique_and_all_materials_are_used() {
        for scene in ALL {
            let built = scene.build(None).unwrap();
            let mut names: Vec<_> = built.materials.iter().map(|m| m.name.as_str()).collect();
            names.sort_unstable();
            names.dedup();
            assert_eq!(names.len(), built.materials.len(), "{}", scene.name);
            for (i, material) in built.materials.iter().enumerate() {
                assert!(
                    built.objects.iter().any(|o| o.material.0 as usize == i),
                    "{}: {} is not used",
                    scene.name,
                    material.name
                );
            }
        }
    }

    #[test]
    fn sizes_beyond_the_limits_are_refused() {
        for scene in ALL {
            for size in [scene.least_size - 1, scene.greatest_size + 1, u32::MAX] {
                let error = scene.build(Some(size)).unwrap_err();
                assert_eq!((error.name, error.size), (scene.name, size));
            }
        }
        let error = find("balls").unwrap().build(Some(30)).unwrap_err();
        assert_eq!(
            error.to_string(),
            "size 30 of scene `balls` (depth of recursion; 4 gives 7381 spheres): expected a number from 1 to 6"
        );
    }

    #[test]
    fn names_are_unique_and_found() {
        for scene in ALL {
            assert_eq!(find(scene.name).unwrap().summary, scene.summary);
        }
        assert!(find("teapot").is_none());
    }

    #[test]
    fn object_counts_are_the_published_ones() {
        // Haines 1987: the counts of the table of the standard procedural databases, floors and walls included.
        let published = [
            ("balls", 1 + 7381),
            ("gears", 1 + 9344),
            ("mount", 8192 + 4),
            ("rings", 1 + 8400),
            ("tetra", 4096),
            ("tree", 1 + 8190),
        ];
        for (name, count) in published {
            assert_eq!(find(name).unwrap().build(None).unwrap().objects.len(), count, "{name}");
        }
    }
}
