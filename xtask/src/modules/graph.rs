//! A graph of names.

use std::collections::{BTreeMap, BTreeSet};

/// Which of some things uses which.
pub(super) struct Graph {
    pub(super) name: String,
    uses: BTreeMap<String, BTreeSet<String>>,
}

impl Graph {
    pub(super) fn new(name: &str) -> Self {
        Self { name: name.to_owned(), uses: BTreeMap::new() }
    }

    /// Something, whatever it uses.
    pub(super) fn add(&mut self, name: &str) {
        self.uses.entry(name.to_owned()).or_default();
    }

    /// One uses the other; itself it may use.
    pub(super) fn link(&mut self, user: &str, used: &str) {
        if user != used {
            self.add(used);
            self.uses.entry(user.to_owned()).or_default().insert(used.to_owned());
        }
    }

    /// What one uses.
    pub(super) fn used_by(&self, name: &str) -> impl Iterator<Item = &str> {
        self.uses.get(name).into_iter().flatten().map(String::as_str)
    }

    /// A circle, if there is one; its first name is its last, too.
    pub(super) fn circle(&self) -> Option<Vec<&str>> {
        let left = self.rows().err()?;
        // Each of those left uses another of them, so a walk comes back.
        let mut walk = vec![*left.first()?];
        loop {
            let next = self.used_by(walk[walk.len() - 1]).find(|name| left.contains(name))?;
            if let Some(start) = walk.iter().position(|name| *name == next) {
                walk.push(next);
                return Some(walk.split_off(start));
            }
            walk.push(next);
        }
    }

    /// The names in rows: each uses only what is in rows before its own. If there are circles, what uses them or is in them.
    pub(super) fn rows(&self) -> Result<Vec<Vec<&str>>, Vec<&str>> {
        let mut rows: Vec<Vec<&str>> = Vec::new();
        let mut left: Vec<&str> = self.uses.keys().map(String::as_str).collect();
        while !left.is_empty() {
            let (row, rest): (Vec<&str>, Vec<&str>) =
                left.iter().partition(|name| !self.used_by(name).any(|used| left.contains(&used)));
            if row.is_empty() {
                return Err(left);
            }
            rows.push(row);
            left = rest;
        }
        Ok(rows)
    }

    /// Those that one uses and that nothing else that it uses leads to.
    pub(super) fn nearest(&self, name: &str) -> Vec<&str> {
        let used: Vec<&str> = self.used_by(name).collect();
        let leads = |from: &str, to: &str| from != to && self.reaches(from, to);
        used.iter().copied().filter(|to| !used.iter().any(|from| leads(from, to))).collect()
    }

    fn reaches(&self, from: &str, to: &str) -> bool {
        let (mut open, mut seen) = (vec![from], BTreeSet::new());
        while let Some(name) = open.pop() {
            if name == to {
                return true;
            }
            if seen.insert(name) {
                open.extend(self.used_by(name));
            }
        }
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn graph(links: &[(&str, &str)]) -> Graph {
        let mut graph = Graph::new("");
        links.iter().for_each(|(user, used)| graph.link(user, used));
        graph
    }

    #[test]
    fn circles_are_found_and_named() {
        assert_eq!(graph(&[("a", "b"), ("b", "c"), ("a", "c")]).circle(), None);
        let around = graph(&[("a", "b"), ("b", "c"), ("c", "b"), ("c", "d")]);
        assert_eq!(around.circle(), Some(vec!["b", "c", "b"]));
    }

    #[test]
    fn rows_stand_on_what_they_use_and_arrows_take_no_short_cut() {
        let graph = graph(&[("top", "middle"), ("middle", "low"), ("top", "low")]);
        assert_eq!(graph.rows().unwrap(), [["low"], ["middle"], ["top"]]);
        assert_eq!(graph.nearest("top"), ["middle"]);
    }
}
