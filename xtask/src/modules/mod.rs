//! The modules of each crate, and which of them uses which.
//!
//! Between the top-level modules of a crate arrows go one way: whoever opens one can read on downwards and never comes back.
//! A test finds circles; `docs/images/modules.svg` shows what there is.

mod draw;
mod graph;
mod uses;

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, bail, ensure};

use graph::Graph;

/// The picture, from the repository's root.
const PICTURE: &str = "docs/images/modules.svg";

/// Writes the picture.
pub(crate) fn run(root: &Path) -> Result<()> {
    let graphs = all(root)?;
    let circles = circles(&graphs);
    ensure!(circles.is_empty(), "{}", circles.join("\n"));
    let path = root.join(PICTURE);
    fs::write(&path, draw::svg(&graphs)).with_context(|| format!("cannot write {}", path.display()))
}

/// What is wrong with the modules, or with their picture.
pub(crate) fn broken(root: &Path) -> Result<Vec<String>> {
    let graphs = all(root)?;
    let mut broken = circles(&graphs);
    if fs::read_to_string(root.join(PICTURE)).unwrap_or_default() != draw::svg(&graphs) {
        broken.push(format!("{PICTURE}: it is not what there is: `cargo xtask modules` draws it anew"));
    }
    Ok(broken)
}

fn circles(graphs: &[Graph]) -> Vec<String> {
    let circle = |graph: &Graph| {
        graph
            .circle()
            .map(|names| format!("{}: modules use each other in a circle: {}", graph.name, names.join(" → ")))
    };
    graphs.iter().filter_map(circle).collect()
}

/// The crates themselves first, then the modules of each.
fn all(root: &Path) -> Result<Vec<Graph>> {
    let mut folders = Vec::new();
    for entry in fs::read_dir(root.join("crates")).context("cannot read crates")? {
        folders.push(entry?.path());
    }
    folders.sort();
    folders.push(root.join("xtask"));
    let mut graphs = vec![of_crates(&folders)?];
    for folder in &folders {
        graphs.push(uses::of_crate(folder).with_context(|| format!("cannot read {}", folder.display()))?);
    }
    Ok(graphs)
}

/// Which crate names which in its manifest; what only tests need is left out.
fn of_crates(folders: &[impl AsRef<Path>]) -> Result<Graph> {
    let mut graph = Graph::new("crates");
    for folder in folders {
        let folder = folder.as_ref();
        let Some(name) = folder.file_name().and_then(|name| name.to_str()) else {
            bail!("a folder without a name")
        };
        let manifest = fs::read_to_string(folder.join("Cargo.toml"))?;
        let used = manifest.lines().skip_while(|line| *line != "[dependencies]").skip(1);
        graph.add(name);
        for line in used.take_while(|line| !line.starts_with('[')) {
            let used = line.split(['.', ' ', '=']).next().unwrap_or_default();
            if used == "brt" || used.starts_with("brt-") {
                graph.link(name, used);
            }
        }
    }
    Ok(graph)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn modules_use_each_other_one_way_and_their_picture_shows_it() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
        assert_eq!(broken(root).unwrap(), Vec::<String>::new());
    }
}
