//! Which slots are taken, and by which generation.

use alloc::collections::BinaryHeap;
use alloc::vec::Vec;
use core::cmp::Reverse;

use super::{Column, Handle, slot_index};

/// A generation that is free and can never be taken again, so that no handle is ever reused.
const RETIRED: u32 = u32::MAX - 1;

/// Hands out slots, the lowest free one first.
///
/// The state is one generation a slot: odd while the slot is taken, even while it is free. The heap
/// of free slots is derived from it.
#[derive(Debug, Default)]
pub(crate) struct Slots {
    generations: Column<u32>,
    free: BinaryHeap<Reverse<u32>>,
}

impl Slots {
    /// Rebuilds the slots from their generations.
    #[must_use]
    pub(crate) fn from_generations(generations: Vec<u32>) -> Self {
        let free = (0u32..).zip(&generations);
        let free = free.filter(|&(_, &g)| g % 2 == 0 && g < RETIRED).map(|(i, _)| Reverse(i));
        Self { free: free.collect(), generations: generations.into() }
    }

    /// Whether every generation is one that inserting and removing can lead to.
    #[must_use]
    pub(crate) fn is_sound(&self) -> bool {
        self.generations.iter().all(|&generation| generation <= RETIRED)
    }

    /// One generation a slot.
    #[must_use]
    pub(crate) fn generations(&self) -> &Column<u32> {
        &self.generations
    }

    /// Whether slots were taken or freed since this was last asked.
    pub(crate) fn take_changed(&mut self) -> bool {
        self.generations.take_changed()
    }

    /// The number of slots, taken and free.
    #[must_use]
    pub(crate) fn len(&self) -> usize {
        self.generations.len()
    }

    /// Takes the lowest free slot, or a new one at the end. O(log free).
    pub(crate) fn insert(&mut self) -> Handle {
        let generations = self.generations.edit();
        let index = if let Some(Reverse(index)) = self.free.pop() {
            index
        } else {
            generations.push(0);
            slot_index(generations.len() - 1)
        };
        let generation = &mut generations[index as usize];
        *generation += 1;
        Handle { index, generation: *generation }
    }

    /// Frees a slot; `false` if the handle is stale. O(log free).
    pub(crate) fn remove(&mut self, handle: Handle) -> bool {
        if !self.contains(handle) {
            return false;
        }
        let generation = &mut self.generations.edit()[handle.slot()];
        *generation += 1;
        if *generation < RETIRED {
            self.free.push(Reverse(handle.index));
        }
        true
    }

    /// Whether the handle names a living object.
    #[must_use]
    pub(crate) fn contains(&self, handle: Handle) -> bool {
        handle.generation % 2 == 1
            && self.generations.get(handle.slot()) == Some(&handle.generation)
    }

    /// The handle of the slot's tenant.
    #[must_use]
    pub(crate) fn tenant(&self, index: u32) -> Option<Handle> {
        let generation = *self.generations.get(index as usize)?;
        (generation % 2 == 1).then_some(Handle { index, generation })
    }

    /// All living objects in order of their slots.
    pub(crate) fn iter(&self) -> impl Iterator<Item = Handle> + '_ {
        let all = (0u32..).zip(self.generations.iter());
        all.filter(|&(_, &g)| g % 2 == 1).map(|(index, &generation)| Handle { index, generation })
    }

    /// Whether another object fits when there may be `most` slots.
    #[must_use]
    pub(crate) fn has_room(&self, most: usize) -> bool {
        !self.free.is_empty() || self.len() < most
    }

    /// The number of living objects. O(slots).
    #[must_use]
    pub(crate) fn live(&self) -> usize {
        self.iter().count()
    }
}

impl Clone for Slots {
    fn clone(&self) -> Self {
        let Self { generations, free } = self;
        Self { generations: generations.clone(), free: free.clone() }
    }

    fn clone_from(&mut self, source: &Self) {
        let Self { generations, free } = source;
        self.generations.clone_from(generations);
        #[cfg(not(planted))]
        self.free.clone_from(free);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lowest_free_slot_is_taken_first() {
        let mut slots = Slots::default();
        let handles: Vec<_> = (0..4).map(|_| slots.insert()).collect();
        assert!(slots.remove(handles[2]) && slots.remove(handles[0]));
        assert!(!slots.remove(handles[0]), "a stale handle frees nothing");
        assert_eq!(slots.insert(), Handle::new(0, 3));
        assert_eq!(slots.insert(), Handle::new(2, 3));
        assert_eq!(slots.insert(), Handle::new(4, 1));
    }

    #[test]
    fn a_slot_that_ran_out_of_generations_is_retired() {
        let mut slots = Slots::from_generations(alloc::vec![u32::MAX - 3]);
        let last = slots.insert();
        assert_eq!(last.generation, u32::MAX - 2);
        assert!(slots.remove(last));
        assert_eq!(slots.insert(), Handle::new(1, 1));
    }
}
