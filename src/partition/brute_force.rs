//! Every object against every other.

use alloc::vec::Vec;

use super::roster::Roster;
use super::{Object, Pair, Partition, PartitionError};
use crate::geometry::Aabb;

/// No division of space: changes cost nothing, [`pairs`](Partition::pairs) takes O(n^2), a
/// [`query`](Partition::query) O(n). What the other partitions are tested against.
#[derive(Clone, Debug, Default)]
pub struct BruteForce {
    roster: Roster,
    pairs: Vec<Pair>,
}

impl BruteForce {
    /// Without objects.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }
}

impl Partition for BruteForce {
    fn insert(&mut self, id: u32, object: Object) -> Result<(), PartitionError> {
        self.roster.insert(id, object)
    }

    fn update(&mut self, id: u32, object: Object) -> Result<(), PartitionError> {
        self.roster.update(id, object).map(|_| ())
    }

    fn remove(&mut self, id: u32) -> Result<(), PartitionError> {
        self.roster.remove(id)
    }

    fn object(&self, id: u32) -> Option<Object> {
        self.roster.object(id)
    }

    fn len(&self) -> u32 {
        self.roster.len()
    }

    fn pairs(&mut self) -> &[Pair] {
        self.roster.settle();
        self.pairs.clear();
        // Listed once: the table may have a place for many more.
        let ids: Vec<_> = self.roster.ids().collect();
        for (at, &a) in ids.iter().enumerate() {
            let bounds = self.roster.bounds(a);
            let touching = |b: &u32| bounds.overlaps(self.roster.bounds(*b));
            let later = ids[at + 1..].iter().copied().filter(touching);
            self.pairs.extend(later.map(|b| [a, b]));
        }
        &self.pairs
    }

    fn query(&self, region: &Aabb, ids: &mut Vec<u32>) {
        ids.clear();
        ids.extend(self.roster.ids().filter(|&id| self.roster.bounds(id).overlaps(region)));
    }

    fn validate(&self) -> Result<(), &'static str> {
        self.roster.validate()
    }
}
