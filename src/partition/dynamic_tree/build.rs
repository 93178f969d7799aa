//! A tree from scratch: each node halves the longest edge of the middles below it.

use super::coarse::Coarse;
use super::tree::{Link, Node, Place, Tree};

/// A leaf that is not yet hung up.
#[derive(Clone, Copy, Debug)]
pub(super) struct Leaf {
    pub(super) bounds: Coarse,
    pub(super) id: u32,
}

impl Tree {
    /// Forgets everything and hangs up these leaves, which are reordered; O(n log n). Nodes come
    /// after their parents.
    ///
    /// An edge has 31 bits, and where it cannot be halved the leaves are: the tree is at most
    /// 3 * 31 + 20 deep.
    pub(super) fn build(&mut self, slots: usize, leaves: &mut [Leaf]) {
        self.nodes.clear();
        self.nodes.push(Node::ROOT);
        self.free.clear();
        self.places.clear();
        self.places.resize(slots, Place::NOWHERE);
        if let [leaf] = leaves {
            self.nodes[0].boxes[0] = leaf.bounds;
            self.hang(Link::leaf(leaf.id), Place { node: 0, side: 0 });
        } else if !leaves.is_empty() {
            self.split(leaves, 0);
        }
    }

    /// Hangs at least two leaves below a node.
    fn split(&mut self, leaves: &mut [Leaf], index: u32) -> Coarse {
        let lower = partition(leaves);
        let (low, high) = leaves.split_at_mut(lower);
        for (side, half) in (0..).zip([low, high]) {
            let place = Place { node: index, side };
            let bounds = if let [leaf] = half {
                self.hang(Link::leaf(leaf.id), place);
                leaf.bounds
            } else {
                let child = self.fork(place);
                self.split(half, child)
            };
            self.nodes[index as usize].boxes[side as usize] = bounds;
        }
        self.nodes[index as usize].bounds()
    }
}

/// Puts the leaves on the lower side of the middle first; returns how many there are, never none
/// and never all.
fn partition(leaves: &mut [Leaf]) -> usize {
    let half = leaves.len() / 2;
    if leaves.len() == 2 {
        return half;
    }
    let mut low = [i32::MAX; 3];
    let mut high = [i32::MIN; 3];
    for leaf in &*leaves {
        let middle = leaf.bounds.middle();
        low = [0, 1, 2].map(|k| low[k].min(middle[k]));
        high = [0, 1, 2].map(|k| high[k].max(middle[k]));
    }
    // Middles are less than 2^30.
    let edges = [0, 1, 2].map(|k| high[k] - low[k]);
    let longest = edges[0].max(edges[1]).max(edges[2]);
    let axis = edges.iter().position(|&edge| edge == longest).unwrap_or(0);
    let border = low[axis] + longest / 2;
    let mut lower = 0;
    for at in 0..leaves.len() {
        let is_lower = leaves[at].bounds.middle()[axis] <= border;
        leaves.swap(at, lower);
        lower += usize::from(is_lower);
    }
    if lower == leaves.len() { half } else { lower }
}
