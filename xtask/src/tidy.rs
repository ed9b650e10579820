//! Laws of the code that neither compiler nor clippy knows.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};

use crate::modules;

/// What must not be said, and where it may be.
struct Law {
    words: &'static [&'static str],
    /// Paths that begin with this obey the law; empty: all.
    under: &'static str,
    /// Paths that begin with this need not.
    but_for: &'static str,
    /// Tests and what stands below `#[cfg(test)]` need not.
    spares_tests: bool,
    why: &'static str,
}

/// Numbers that look like a margin.
const MARGINS: &[&str] = &["EPSILON", "1e-", "2e-", "3e-", "4e-", "5e-", "6e-", "7e-", "8e-", "9e-", "0e-"];

const LAWS: [Law; 5] = [
    Law {
        words: &["target_arch", "target_feature", "core::arch", "std::arch", "fearless_simd", "brt_hide_x86"],
        under: "",
        but_for: "crates/brt-geometry/src/lanes.rs",
        spares_tests: false,
        why: "what differs between architectures stands in lanes.rs alone: elsewhere no build would notice",
    },
    Law {
        words: &["SimdLevel::default()", "SimdLevel::Widest", "SimdLevel::Avx2", "SimdLevel::Baseline"],
        under: "crates/brt-render/src",
        but_for: "crates/brt-render/src/run.rs",
        spares_tests: true,
        why: "the level comes from `Run`: tests could not choose another one",
    },
    Law {
        words: MARGINS,
        under: "crates/brt-geometry/src",
        but_for: "crates/brt-geometry/src/margins",
        spares_tests: true,
        why: "what a proof rests on stands in margins.rs, with its inequality and a test that measures how much of it is needed",
    },
    Law {
        words: MARGINS,
        under: "crates/brt-render/src",
        but_for: "crates/brt-render/src/margins",
        spares_tests: true,
        why: "what a proof rests on stands in margins.rs, with its inequality and a test that measures how much of it is needed",
    },
    Law {
        words: &["clippy::disallowed_methods"],
        under: "",
        but_for: "crates/brt-lab",
        spares_tests: false,
        why: "what reaches a picture uses `libm`: the platform's mathematics give other bytes on other machines",
    },
];

/// Checks all source files below the repository's root.
pub(crate) fn run(root: &Path) -> Result<()> {
    let mut broken = broken_laws(root)?;
    broken.extend(modules::broken(root)?);
    broken.extend(dead_paths(root)?);
    ensure!(broken.is_empty(), "{}", broken.join("\n"));
    Ok(())
}

fn broken_laws(root: &Path) -> Result<Vec<String>> {
    let mut files = Vec::new();
    for folder in ["crates", "fuzz", "xtask"] {
        collect(&root.join(folder), &mut files)?;
    }
    files.sort();
    ensure!(files.len() > 100, "{} has hardly any source files: is it the repository?", root.display());
    let mut broken = Vec::new();
    for file in files {
        let text = fs::read_to_string(&file).with_context(|| format!("cannot read {}", file.display()))?;
        let path = file.strip_prefix(root).unwrap_or(&file).to_string_lossy().replace('\\', "/");
        // This file has to name what it forbids.
        if path != "xtask/src/tidy.rs" {
            broken.extend(LAWS.iter().flat_map(|law| law.broken_in(&path, &text)));
        }
    }
    Ok(broken)
}

/// What documents say lies in the repository, and does not.
fn dead_paths(root: &Path) -> Result<Vec<String>> {
    const FOLDERS: [&str; 6] = ["crates/", "xtask/", "fuzz/", "docs/", "scenes/", "bench/"];
    let mut documents: Vec<PathBuf> =
        ["README.md", "ARCHITECTURE.md", "CONTRIBUTING.md"].iter().map(|name| root.join(name)).collect();
    for folder in ["docs", "docs/notes", "docs/howto", "docs/paper"] {
        for entry in fs::read_dir(root.join(folder)).with_context(|| format!("cannot read {folder}"))? {
            documents.push(entry?.path());
        }
    }
    let mut dead = Vec::new();
    for document in documents.iter().filter(|path| path.extension().is_some_and(|e| e == "md")) {
        let text = fs::read_to_string(document)?;
        // What stands between backticks and has neither gaps nor wildcards.
        let quoted = text.split('`').skip(1).step_by(2);
        let is_path = |word: &&str| {
            FOLDERS.iter().any(|folder| word.starts_with(folder))
                && !word.contains([' ', '*', '<', '{', '\n'])
        };
        for path in quoted.filter(is_path).filter(|path| !root.join(path).exists()) {
            dead.push(format!("{}: there is no `{path}`", document.display()));
        }
    }
    Ok(dead)
}

/// Adds all Rust files of a folder and of those inside, but for what is built there.
fn collect(folder: &Path, files: &mut Vec<PathBuf>) -> Result<()> {
    let entries = fs::read_dir(folder).with_context(|| format!("cannot read {}", folder.display()))?;
    for entry in entries {
        let path = entry?.path();
        if path.is_dir() && !path.ends_with("target") {
            collect(&path, files)?;
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    Ok(())
}

impl Law {
    fn broken_in(&self, path: &str, text: &str) -> Vec<String> {
        let is_test = path.contains("/tests/") || path.contains("/benches/") || path.ends_with("/tests.rs");
        if !path.starts_with(self.under) || path.starts_with(self.but_for) || (self.spares_tests && is_test) {
            return Vec::new();
        }
        let lines = text.lines().take_while(|line| !(self.spares_tests && line.trim() == "#[cfg(test)]"));
        (1..)
            .zip(lines)
            .filter_map(|(number, line)| {
                let word = self.words.iter().find(|word| line.contains(**word))?;
                Some(format!("{path}:{number}: `{word}`: {}", self.why))
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use brt_formats::Format;

    use super::*;

    #[test]
    fn the_repository_is_tidy() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
        assert_eq!(broken_laws(root).unwrap(), Vec::<String>::new());
    }

    #[test]
    fn documents_name_what_is_there() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
        assert_eq!(dead_paths(root).unwrap(), Vec::<String>::new());
    }

    /// A format that is read is fuzzed, and named to those who read the guide.
    #[test]
    fn formats_are_fuzzed_and_in_the_guide() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
        let guide = fs::read_to_string(root.join("docs/guide.md")).unwrap().to_lowercase();
        let first_column = |line: &str| line.split('|').nth(1).unwrap_or_default().to_owned();
        let named: Vec<String> =
            guide.lines().filter(|line| line.starts_with('|')).map(first_column).collect();
        for format in Format::ALL.into_iter().filter(|format| format.reads()) {
            let folder = format!("{format:?}").to_lowercase();
            assert!(root.join(format!("crates/brt-formats/src/read/{folder}/mod.rs")).exists(), "{folder}");
            assert!(
                root.join(format!("fuzz/fuzz_targets/{folder}.rs")).exists(),
                "{folder} has no fuzz target"
            );
            let is_named = |extension: &str| named.iter().any(|cell| cell.contains(extension));
            assert!(
                format.extensions().iter().any(|e| is_named(e)),
                "the guide's table does not name {folder}"
            );
        }
    }

    #[test]
    fn laws_are_broken_where_they_hold_and_nowhere_else() {
        let broken = |path: &str, text: &str| LAWS.iter().flat_map(|law| law.broken_in(path, text)).count();
        let intrinsics = "use std::arch::x86_64::*;\n#[cfg(target_arch = \"x86\")]";
        assert_eq!(broken("crates/brt-render/src/render.rs", intrinsics), 2);
        assert_eq!(broken("crates/brt-render/tests/certified.rs", intrinsics), 2);
        assert_eq!(broken("crates/brt-geometry/src/lanes.rs", intrinsics), 0);
        let level = "let level = SimdLevel::default();\n";
        assert_eq!(broken("crates/brt-render/src/render.rs", level), 1);
        assert_eq!(broken("crates/brt-render/src/render.rs", &format!("#[cfg(test)]\n{level}")), 0);
        assert_eq!(broken("crates/brt-render/src/run.rs", level), 0);
        assert_eq!(broken("crates/brt-render/tests/certified.rs", level), 0);
        let exempt = "#![expect(clippy::disallowed_methods, reason = \"\")]";
        assert_eq!(broken("crates/brt-image/src/transfer.rs", exempt), 1);
        assert_eq!(broken("crates/brt-lab/src/plot/axis.rs", exempt), 0);
    }
}
