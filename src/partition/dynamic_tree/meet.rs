//! A tree against itself.

use alloc::vec::Vec;

use super::tree::{Child, Node, Tree};

/// Nodes that are still to be looked at; kept for their room.
#[derive(Clone, Debug, Default)]
pub(super) struct Stacks {
    pairs: Vec<[u32; 2]>,
    pub(super) single: Vec<u32>,
}

impl Tree {
    /// Tells of all pairs of leaves whose boxes touch, each once, in any order. The tree must be
    /// just built: every node in use.
    pub(super) fn meet(&self, stacks: &mut Stacks, mut found: impl FnMut(u32, u32)) {
        for node in &self.nodes {
            // Two leaves meet at the one node that has them on different sides.
            self.compare([node, node], [0, 1], stacks, &mut found);
            while let Some(pair) = stacks.pairs.pop() {
                let nodes = pair.map(|index| &self.nodes[index as usize]);
                for sides in [[0, 0], [0, 1], [1, 0], [1, 1]] {
                    self.compare(nodes, sides, stacks, &mut found);
                }
            }
        }
    }

    /// Compares what hangs on a side of one node and on a side of another.
    #[inline]
    fn compare(
        &self,
        nodes: [&Node; 2],
        sides: [usize; 2],
        stacks: &mut Stacks,
        found: &mut impl FnMut(u32, u32),
    ) {
        let [a, b] = [0, 1].map(|k| &nodes[k].boxes[sides[k]]);
        if !a.touches(b) {
            return;
        }
        let [from_a, from_b] = [0, 1].map(|k| nodes[k].links[sides[k]].child());
        match (from_a, from_b) {
            (Child::Node(below_a), Child::Node(below_b)) => stacks.pairs.push([below_a, below_b]),
            (Child::Leaf(leaf_a), Child::Leaf(leaf_b)) => found(leaf_a, leaf_b),
            (Child::Leaf(leaf), Child::Node(below)) => {
                self.query_below(below, a, &mut stacks.single, |other| found(leaf, other));
            }
            (Child::Node(below), Child::Leaf(leaf)) => {
                self.query_below(below, b, &mut stacks.single, |other| found(leaf, other));
            }
            (Child::Nothing, _) | (_, Child::Nothing) => {}
        }
    }
}
