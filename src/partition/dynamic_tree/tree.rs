//! A binary tree of boxes around leaves.

use alloc::vec::Vec;

use super::coarse::Coarse;

/// What hangs on one side of a node.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Link(u32);

/// What a link leads to.
pub(super) enum Child {
    /// Nothing: only the root may have empty sides.
    Nothing,
    /// The leaf of this id.
    Leaf(u32),
    /// This node.
    Node(u32),
}

impl Link {
    const LEAF: u32 = 1 << 31;
    pub(super) const NOTHING: Self = Self(u32::MAX);

    pub(super) const fn leaf(id: u32) -> Self {
        Self(id | Self::LEAF)
    }

    pub(super) const fn node(index: u32) -> Self {
        Self(index)
    }

    #[inline]
    pub(super) const fn child(self) -> Child {
        match self.0 {
            u32::MAX => Child::Nothing,
            leaf if leaf & Self::LEAF != 0 => Child::Leaf(leaf ^ Self::LEAF),
            node => Child::Node(node),
        }
    }
}

/// A side of a node: what a leaf or a node hangs on.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Place {
    pub(super) node: u32,
    pub(super) side: u32,
}

impl Place {
    /// Where nothing hangs: the place of the root and of what is not in the tree.
    pub(super) const NOWHERE: Self = Self { node: u32::MAX, side: 0 };
}

/// Two sides, each a box around what hangs on it. 64 bytes with the place it hangs on itself.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    pub(super) boxes: [Coarse; 2],
    pub(super) links: [Link; 2],
    pub(super) parent: Place,
}

impl Node {
    pub(super) const ROOT: Self =
        Self { boxes: [Coarse::NOTHING; 2], links: [Link::NOTHING; 2], parent: Place::NOWHERE };

    #[inline]
    pub(super) fn bounds(&self) -> Coarse {
        self.boxes[0].union(&self.boxes[1])
    }
}

/// The tree. Node 0 is the root and always there.
#[derive(Clone, Debug)]
pub(super) struct Tree {
    pub(super) nodes: Vec<Node>,
    /// Indices of nodes that are not in use.
    pub(super) free: Vec<u32>,
    /// Where each leaf hangs, by id.
    pub(super) places: Vec<Place>,
}

impl Default for Tree {
    fn default() -> Self {
        Self { nodes: [Node::ROOT].into(), free: Vec::new(), places: Vec::new() }
    }
}

impl Tree {
    /// Hangs up a leaf where it lengthens boxes least; returns how deep. O(depth).
    pub(super) fn insert(&mut self, id: u32, bounds: &Coarse) -> u32 {
        let mut index = 0;
        let mut depth = 0;
        loop {
            let node = &mut self.nodes[index as usize];
            let unions = node.boxes.map(|side| side.union(bounds));
            let growth = |side: usize| unions[side].girth() - node.boxes[side].girth();
            let empty = node.links.iter().position(|link| *link == Link::NOTHING);
            let side = empty.unwrap_or_else(|| usize::from(growth(1) < growth(0)));
            let (old, link) = (node.boxes[side], node.links[side]);
            node.boxes[side] = unions[side];
            let place = Place { node: index, side: u32::from(side == 1) };
            match link.child() {
                Child::Node(child) => (index, depth) = (child, depth + 1),
                Child::Nothing => {
                    self.hang(Link::leaf(id), place);
                    return depth;
                }
                Child::Leaf(_) => {
                    let fork = self.fork(place);
                    self.nodes[fork as usize].boxes = [old, *bounds];
                    self.hang(link, Place { node: fork, side: 0 });
                    self.hang(Link::leaf(id), Place { node: fork, side: 1 });
                    return depth + 1;
                }
            }
        }
    }

    /// Hangs a new node there.
    pub(super) fn fork(&mut self, place: Place) -> u32 {
        let index = self.free.pop().unwrap_or_else(|| {
            self.nodes.push(Node::ROOT);
            // There are fewer nodes than ids.
            u32::try_from(self.nodes.len() - 1).unwrap_or(u32::MAX)
        });
        self.hang(Link::node(index), place);
        index
    }

    /// Hangs something there, whatever hung there.
    pub(super) fn hang(&mut self, link: Link, place: Place) {
        self.nodes[place.node as usize].links[place.side as usize] = link;
        match link.child() {
            Child::Nothing => {}
            Child::Leaf(id) => self.places[id as usize] = place,
            Child::Node(index) => self.nodes[index as usize].parent = place,
        }
    }

    /// Takes down a leaf, if it hangs somewhere. O(depth).
    pub(super) fn remove(&mut self, id: u32) {
        let place = core::mem::replace(&mut self.places[id as usize], Place::NOWHERE);
        if place == Place::NOWHERE {
            return;
        }
        let node = &mut self.nodes[place.node as usize];
        if node.parent == Place::NOWHERE {
            node.boxes[place.side as usize] = Coarse::NOTHING;
            node.links[place.side as usize] = Link::NOTHING;
            return;
        }
        // The other side takes the place of the node.
        let other = 1 - place.side as usize;
        let (bounds, link, above) = (node.boxes[other], node.links[other], node.parent);
        self.free.push(place.node);
        self.hang(link, above);
        self.set(above, bounds);
    }

    /// Changes the box of a side, and those around it.
    fn set(&mut self, mut place: Place, mut bounds: Coarse) {
        while place != Place::NOWHERE {
            let node = &mut self.nodes[place.node as usize];
            let slot = &mut node.boxes[place.side as usize];
            if *slot == bounds {
                return;
            }
            *slot = bounds;
            (place, bounds) = (node.parent, node.bounds());
        }
    }

    /// Tells of all leaves whose boxes touch the region. `stack` may hold anything.
    pub(super) fn query(&self, region: &Coarse, stack: &mut Vec<u32>, found: impl FnMut(u32)) {
        self.query_below(0, region, stack, found);
    }

    /// Those of them that hang below a node.
    pub(super) fn query_below(
        &self,
        node: u32,
        region: &Coarse,
        stack: &mut Vec<u32>,
        mut found: impl FnMut(u32),
    ) {
        stack.clear();
        stack.push(node);
        while let Some(index) = stack.pop() {
            let node = &self.nodes[index as usize];
            for side in 0..2 {
                if !node.boxes[side].touches(region) {
                    continue;
                }
                match node.links[side].child() {
                    Child::Nothing => {}
                    Child::Leaf(id) => found(id),
                    Child::Node(child) => stack.push(child),
                }
            }
        }
    }

    /// Checks links and boxes, given the box of each leaf; returns the number of leaves.
    pub(super) fn validate(&self, leaf: impl Fn(u32) -> Coarse) -> Result<usize, &'static str> {
        let mut leaves = 0;
        let mut reached = 0;
        let mut stack = Vec::from([0]);
        while let Some(index) = stack.pop() {
            reached += 1;
            if reached > self.nodes.len() {
                return Err("tree: nodes in a circle");
            }
            let node = &self.nodes[index as usize];
            for side in 0..2 {
                let place = Place { node: index, side };
                let bounds = match node.links[side as usize].child() {
                    Child::Nothing if index == 0 => Coarse::NOTHING,
                    Child::Nothing => return Err("tree: an empty side below the root"),
                    Child::Leaf(id) if self.places[id as usize] == place => {
                        leaves += 1;
                        leaf(id)
                    }
                    Child::Node(child) if self.nodes[child as usize].parent == place => {
                        stack.push(child);
                        self.nodes[child as usize].bounds()
                    }
                    _ => return Err("tree: a link that is not mutual"),
                };
                if bounds != node.boxes[side as usize] {
                    return Err("tree: a box that is not the one around what it holds");
                }
            }
        }
        if reached + self.free.len() != self.nodes.len() {
            return Err("tree: a lost node");
        }
        let hung = self.places.iter().filter(|&&place| place != Place::NOWHERE).count();
        if hung == leaves { Ok(leaves) } else { Err("tree: a lost leaf") }
    }
}
