//! Which particles hang together.

use alloc::vec::Vec;

/// A partition of slots: two are in one component when links lead from one to the other.
#[derive(Debug)]
pub(super) struct Components {
    /// Another member with a lower slot, or the slot itself.
    parent: Vec<u32>,
}

impl Components {
    /// Every slot alone.
    pub(super) fn new(slots: u32) -> Self {
        Self { parent: (0..slots).collect() }
    }

    /// The lowest slot of the component, its name. Shortens the way for the next time.
    pub(super) fn root(&mut self, slot: u32) -> u32 {
        let mut at = slot;
        while self.parent[at as usize] != at {
            let parent = self.parent[at as usize];
            self.parent[at as usize] = self.parent[parent as usize];
            at = parent;
        }
        at
    }

    /// Makes one component of two.
    pub(super) fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.root(a), self.root(b));
        self.parent[a.max(b) as usize] = a.min(b);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lowest_slot_names_the_component() {
        let mut components = Components::new(9);
        for (a, b) in [(8, 5), (2, 5), (7, 3), (4, 4)] {
            components.join(a, b);
        }
        let roots: Vec<_> = (0..9).map(|slot| components.root(slot)).collect();
        assert_eq!(roots, [0, 1, 2, 3, 4, 2, 6, 3, 2]);
    }
}
