//! The objects of a partition by their ids, and which of them changed.

use alloc::vec::Vec;

use super::{ID_MAX, Object, Pair, PartitionError};
use crate::geometry::Aabb;
use crate::math::Vec3;

/// What every partition keeps: one slot an id.
///
/// An id is *stale* from when something about it changed until whoever divides space by it has
/// caught up.
#[derive(Clone, Debug, Default)]
pub(super) struct Roster {
    /// Of a free slot: whatever was there.
    bounds: Vec<Aabb>,
    centres: Vec<Vec3>,
    is_live: Vec<bool>,
    is_stale: Vec<bool>,
    /// Those marked in `is_stale`, in order of their changes; some may be gone.
    stale: Vec<u32>,
    len: u32,
}

impl Roster {
    /// The number of objects.
    #[inline]
    pub(super) fn len(&self) -> u32 {
        self.len
    }

    /// The number of slots: every id is below.
    #[inline]
    pub(super) fn slots(&self) -> usize {
        self.bounds.len()
    }

    /// Whether there is an object of this id.
    #[inline]
    pub(super) fn contains(&self, id: u32) -> bool {
        self.is_live.get(id as usize) == Some(&true)
    }

    /// The object of this id.
    pub(super) fn object(&self, id: u32) -> Option<Object> {
        self.contains(id).then(|| Object { bounds: *self.bounds(id), centre: *self.centre(id) })
    }

    /// The tight box of a living object.
    #[inline]
    pub(super) fn bounds(&self, id: u32) -> &Aabb {
        &self.bounds[id as usize]
    }

    /// The centre of a living object.
    #[inline]
    pub(super) fn centre(&self, id: u32) -> &Vec3 {
        &self.centres[id as usize]
    }

    /// All ids in order.
    pub(super) fn ids(&self) -> impl Iterator<Item = u32> + '_ {
        (0..).zip(&self.is_live).filter(|(_, live)| **live).map(|(id, _)| id)
    }

    /// Whether the tight boxes of two living objects touch. Branch-free, and wide registers can do
    /// two axes at a time.
    #[inline]
    pub(super) fn touch(&self, [a, b]: Pair) -> bool {
        let [a, b] = [self.bounds(a), self.bounds(b)];
        let [a, b] = [[a.min().raw(), a.max().raw()], [b.min().raw(), b.max().raw()]];
        // Negative where they are apart. Coordinates are within +-2^60, so nothing wraps.
        let gap = |k: usize| (b[1][k] - a[0][k]) | (a[1][k] - b[0][k]);
        gap(0) | gap(1) | gap(2) >= 0
    }

    /// Takes in an object, stale.
    pub(super) fn insert(&mut self, id: u32, object: Object) -> Result<(), PartitionError> {
        if id > ID_MAX {
            return Err(PartitionError::IdTooLarge);
        }
        if self.contains(id) {
            return Err(PartitionError::IdTaken);
        }
        object.check()?;
        let slots = self.slots().max(id as usize + 1);
        self.bounds.resize(slots, object.bounds);
        self.centres.resize(slots, object.centre);
        self.is_live.resize(slots, false);
        self.is_stale.resize(slots, false);
        self.set(id, object);
        self.is_live[id as usize] = true;
        self.len += 1;
        self.mark(id);
        Ok(())
    }

    /// Gives an object another box and centre; returns the box it had. Whether that makes it stale
    /// is for the caller to say.
    #[inline]
    pub(super) fn update(&mut self, id: u32, object: Object) -> Result<Aabb, PartitionError> {
        if !self.contains(id) {
            return Err(PartitionError::UnknownId);
        }
        object.check()?;
        let before = *self.bounds(id);
        self.set(id, object);
        Ok(before)
    }

    #[inline]
    fn set(&mut self, id: u32, object: Object) {
        self.bounds[id as usize] = object.bounds;
        self.centres[id as usize] = object.centre;
    }

    /// Takes out an object; its id is stale.
    pub(super) fn remove(&mut self, id: u32) -> Result<(), PartitionError> {
        if !self.contains(id) {
            return Err(PartitionError::UnknownId);
        }
        self.is_live[id as usize] = false;
        self.len -= 1;
        self.mark(id);
        Ok(())
    }

    /// Whether something about the id changed.
    #[inline]
    pub(super) fn is_stale(&self, id: u32) -> bool {
        self.is_stale[id as usize]
    }

    /// The ids about which something changed, those of removed objects among them.
    #[inline]
    pub(super) fn stale(&self) -> &[u32] {
        &self.stale
    }

    /// Says that the id is stale.
    #[inline]
    pub(super) fn mark(&mut self, id: u32) {
        let is_stale = &mut self.is_stale[id as usize];
        if !*is_stale {
            *is_stale = true;
            self.stale.push(id);
        }
    }

    /// Says that everything is stale.
    pub(super) fn mark_all(&mut self) {
        for id in self.ids().collect::<Vec<_>>() {
            self.mark(id);
        }
    }

    /// Says that nothing is stale any more.
    pub(super) fn settle(&mut self) {
        for id in self.stale.drain(..) {
            self.is_stale[id as usize] = false;
        }
    }

    /// Puts what a query found in order: `ids` holds the objects that are not stale and whose tight
    /// boxes touch the region; the stale ones that do are added.
    pub(super) fn complete(&self, region: &Aabb, ids: &mut Vec<u32>) {
        let stale = self.stale.iter().copied().filter(|&id| self.contains(id));
        ids.extend(stale.filter(|&id| self.bounds(id).overlaps(region)));
        ids.sort_unstable();
    }

    /// Checks that all tables agree.
    pub(super) fn validate(&self) -> Result<(), &'static str> {
        let Self { bounds, centres, is_live, is_stale, stale, len } = self;
        let slots = bounds.len();
        let lengths = [centres.len(), is_live.len(), is_stale.len()];
        if lengths != [slots; 3] {
            return Err("roster: tables of different lengths");
        }
        if self.ids().count() != *len as usize {
            return Err("roster: a wrong number of objects");
        }
        let mut listed = stale.clone();
        listed.sort_unstable();
        let marked = (0..).zip(is_stale).filter(|(_, stale)| **stale).map(|(id, _)| id);
        if !marked.eq(listed) {
            return Err("roster: a mark without one entry");
        }
        if !self.ids().filter_map(|id| self.object(id)).all(|object| object.check().is_ok()) {
            return Err("roster: a coordinate out of range");
        }
        Ok(())
    }
}
