//! What a graph of nodes that are used many times comes to, counted before anything is copied: each node once.

use std::collections::HashMap;
use std::hash::Hash;

use super::Stop;
use crate::common::{Budget, Limits, counted};

/// Nodes that show something, and others below them.
pub(crate) trait Graph {
    /// A name of a node.
    type Node: Copy + Eq + Hash;

    /// The bytes that a node costs by itself wherever it is used, `None` if it shows nothing.
    fn shown(&self, node: Self::Node) -> Result<Option<u64>, Stop>;

    /// The nodes right below, as often as they are there.
    fn below(&self, node: Self::Node) -> Vec<Self::Node>;

    /// An error about a node.
    fn fault(&self, node: Self::Node, what: &str) -> Stop;
}

/// What there is of a node and everything below it.
#[derive(Clone, Copy, Default)]
struct Total {
    uses: u128,
    bytes: u128,
    height: usize,
}

/// What is known of the nodes of a graph; `None` while what is below is being counted.
pub(crate) struct Instances<N>(HashMap<N, Option<Total>>);

impl<N: Copy + Eq + Hash> Instances<N> {
    /// Counts all that is below some nodes. It must not nest too deep, and fit into the budget.
    pub(crate) fn count<G: Graph<Node = N>>(
        graph: &G,
        roots: impl IntoIterator<Item = N>,
        budget: &Budget,
    ) -> Result<Self, Stop> {
        let mut known = Self(HashMap::new());
        let mut all = Total::default();
        for root in roots {
            all.add(known.total(graph, root, 0)?);
        }
        budget.has(all.bytes, || match all.uses {
            1 => "1 instance".to_owned(),
            uses => format!("{} instances", counted(uses)),
        })?;
        Ok(known)
    }

    /// Is anything to be seen at or below a node?
    pub(crate) fn shows(&self, node: N) -> bool {
        matches!(self.0.get(&node), Some(Some(total)) if total.uses > 0)
    }

    fn total<G: Graph<Node = N>>(&mut self, graph: &G, node: N, depth: usize) -> Result<Total, Stop> {
        let too_deep = || graph.fault(node, &format!("nests deeper than {}", Limits::NESTING));
        match self.0.get(&node) {
            Some(Some(total)) if depth + total.height > Limits::NESTING => return Err(too_deep()),
            Some(Some(total)) => return Ok(*total),
            Some(None) => return Err(graph.fault(node, "contains itself")),
            None if depth > Limits::NESTING => return Err(too_deep()),
            None => {}
        }
        self.0.insert(node, None);
        let mut total = Total::default();
        if let Some(bytes) = graph.shown(node)? {
            total = Total { uses: 1, bytes: bytes.into(), height: 0 };
        }
        for below in graph.below(node) {
            let below = self.total(graph, below, depth + 1)?;
            total.add(Total { height: below.height + 1, ..below });
        }
        self.0.insert(node, Some(total));
        Ok(total)
    }
}

impl Total {
    fn add(&mut self, other: Self) {
        self.uses = self.uses.saturating_add(other.uses);
        self.bytes = self.bytes.saturating_add(other.bytes);
        self.height = self.height.max(other.height);
    }
}
