//! Things that belong together.

use alloc::vec::Vec;

/// A forest over numbers: each tree is a group, and its lowest number the root.
#[derive(Debug)]
pub(super) struct Groups {
    parents: Vec<u32>,
}

impl Groups {
    /// As many groups of one as there are numbers.
    pub(super) fn new(count: usize) -> Self {
        Self { parents: (0..).take(count).collect() }
    }

    /// Adds a number, a group by itself.
    pub(super) fn push(&mut self) -> u32 {
        let number = self.parents.len() as u32; // fewer than 2^32
        self.parents.push(number);
        number
    }

    /// The lowest number of the group.
    pub(super) fn root(&mut self, mut number: u32) -> u32 {
        while self.parents[number as usize] != number {
            let parent = self.parents[number as usize];
            self.parents[number as usize] = self.parents[parent as usize];
            number = parent;
        }
        number
    }

    /// Joins two groups.
    pub(super) fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.root(a), self.root(b));
        self.parents[a.max(b) as usize] = a.min(b);
    }
}
