//! Which modules a source file uses: by its `use` declarations and its paths, tests left out.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use syn::visit::Visit;
use syn::{Item, ItemMod, ItemUse, UseTree};

use super::graph::Graph;

/// The top-level modules of a crate, and which of them uses which.
pub(super) fn of_crate(folder: &Path) -> Result<Graph> {
    let name = folder.file_name().and_then(|name| name.to_str()).context("a folder without a name")?;
    let sources = folder.join("src");
    let root = ["lib.rs", "main.rs"].map(|file| sources.join(file)).into_iter().find(|file| file.exists());
    let root = parsed(&root.context("neither lib.rs nor main.rs")?)?;
    let mut graph = Graph::new(name);
    let mut found = Found { names: names_of(&root), ..Found::default() };
    for module in root.items.iter().filter_map(module_of) {
        graph.add(&module);
    }
    for module in root.items.iter().filter_map(module_of) {
        for (path, file) in files_of(&sources, &module)? {
            (found.module, found.used) = (path, Vec::new());
            found.visit_file(&parsed(&file)?);
            found.used.iter().for_each(|used| graph.link(&module, used));
        }
    }
    Ok(graph)
}

fn parsed(path: &Path) -> Result<syn::File> {
    let text = fs::read_to_string(path).with_context(|| format!("cannot read {}", path.display()))?;
    syn::parse_file(&text).with_context(|| format!("cannot parse {}", path.display()))
}

/// A module that is declared and not for tests alone.
fn module_of(item: &Item) -> Option<String> {
    match item {
        Item::Mod(module) if !is_test(&module.attrs) => Some(module.ident.to_string()),
        _ => None,
    }
}

fn is_test(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        let list = attribute.meta.require_list();
        attribute.path().is_ident("cfg") && list.is_ok_and(|list| list.tokens.to_string() == "test")
    })
}

/// For each name that the root re-exports, the module that it comes from; modules name themselves.
fn names_of(root: &syn::File) -> BTreeMap<String, String> {
    let mut names = BTreeMap::new();
    for item in &root.items {
        if let Item::Use(declaration) = item {
            each_leaf(&declaration.tree, &mut Vec::new(), &mut |path, name| {
                let first = path.iter().find(|part| *part != "crate" && *part != "self");
                if let Some(first) = first {
                    names.insert(name.to_owned(), first.clone());
                }
            });
        }
    }
    names.extend(root.items.iter().filter_map(module_of).map(|module| (module.clone(), module)));
    names
}

/// Calls for each name that a tree declares, with the path that it stands for.
fn each_leaf(tree: &UseTree, path: &mut Vec<String>, act: &mut impl FnMut(&[String], &str)) {
    let depth = path.len();
    match tree {
        UseTree::Path(tree) => {
            path.push(tree.ident.to_string());
            each_leaf(&tree.tree, path, act);
        }
        UseTree::Name(tree) => {
            path.push(tree.ident.to_string());
            act(path, &tree.ident.to_string());
        }
        UseTree::Rename(tree) => {
            path.push(tree.ident.to_string());
            act(path, &tree.rename.to_string());
        }
        UseTree::Glob(_) => act(path, "*"),
        UseTree::Group(group) => group.items.iter().for_each(|tree| each_leaf(tree, path, act)),
    }
    path.truncate(depth);
}

/// The files of a top-level module with the path of the module that each is; those of tests left out.
fn files_of(sources: &Path, module: &str) -> Result<Vec<(Vec<String>, PathBuf)>> {
    let mut files = Vec::new();
    let mut open = vec![(vec![module.to_owned()], sources.join(module))];
    let single = sources.join(format!("{module}.rs"));
    if single.exists() {
        files.push((vec![module.to_owned()], single));
    }
    while let Some((path, folder)) = open.pop() {
        let Ok(entries) = fs::read_dir(&folder) else { continue };
        for entry in entries {
            let file = entry?.path();
            let name = file.file_stem().and_then(|name| name.to_str()).unwrap_or_default().to_owned();
            let mut inner = path.clone();
            if name != "mod" {
                inner.push(name.clone());
            }
            if file.is_dir() {
                open.push((inner, file));
            } else if file.extension().is_some_and(|e| e == "rs") && !is_declared_for_tests(&folder, &name)? {
                files.push((inner, file));
            }
        }
    }
    Ok(files)
}

/// Is a module declared below `#[cfg(test)]`, in the folder's `mod.rs` or the file of the folder's name?
fn is_declared_for_tests(folder: &Path, name: &str) -> Result<bool> {
    let owners = [folder.join("mod.rs"), folder.with_extension("rs")];
    for owner in owners.iter().filter(|owner| owner.exists()) {
        let declares = |item: &Item| matches!(item, Item::Mod(m) if m.ident == name && is_test(&m.attrs));
        if parsed(owner)?.items.iter().any(declares) {
            return Ok(true);
        }
    }
    Ok(false)
}

/// What a file uses of its crate.
#[derive(Default)]
struct Found {
    /// Of the crate's root.
    names: BTreeMap<String, String>,
    /// The module that is looked at.
    module: Vec<String>,
    /// Top-level modules.
    used: Vec<String>,
}

impl Found {
    fn note(&mut self, path: &[String]) {
        let (above, rest) = match path.first().map(String::as_str) {
            Some("crate") => (self.module.len(), &path[1..]),
            Some("super") => {
                let above = path.iter().take_while(|part| *part == "super").count();
                (above, &path[above..])
            }
            _ => return,
        };
        // Inside of its own module it uses nothing else.
        if above >= self.module.len()
            && let Some(name) = rest.first().and_then(|name| self.names.get(name))
        {
            self.used.push(name.clone());
        }
    }
}

impl Visit<'_> for Found {
    fn visit_item_mod(&mut self, module: &ItemMod) {
        if !is_test(&module.attrs) {
            self.module.push(module.ident.to_string());
            syn::visit::visit_item_mod(self, module);
            self.module.pop();
        }
    }

    fn visit_item_use(&mut self, declaration: &ItemUse) {
        let mut paths = Vec::new();
        each_leaf(&declaration.tree, &mut Vec::new(), &mut |path, _| paths.push(path.to_vec()));
        paths.iter().for_each(|path| self.note(path));
    }

    fn visit_path(&mut self, path: &syn::Path) {
        let parts: Vec<String> = path.segments.iter().map(|segment| segment.ident.to_string()).collect();
        self.note(&parts);
        syn::visit::visit_path(self, path);
    }
}
