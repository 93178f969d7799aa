//! Records that have handles.

use alloc::vec::Vec;

use super::{Column, Handle, Slots};

/// One record a slot; a free slot holds the default record, so that equal tables have equal bytes.
#[derive(Debug)]
pub(crate) struct Table<T> {
    slots: Slots,
    rows: Column<T>,
}

impl<T: Clone + Default + PartialEq> Table<T> {
    /// Rebuilds a table; `None` if a generation cannot be, the lengths differ or a free slot is not
    /// empty.
    #[must_use]
    pub(crate) fn from_parts(generations: Vec<u32>, rows: Vec<T>) -> Option<Self> {
        let table = Self { slots: Slots::from_generations(generations), rows: rows.into() };
        let vacant =
            |(index, row): (u32, &T)| table.slots.tenant(index).is_some() || *row == T::default();
        let good = table.slots.is_sound()
            && table.slots.len() == table.rows.len()
            && (0..).zip(&*table.rows).all(vacant);
        good.then_some(table)
    }

    /// The slots.
    #[must_use]
    pub(crate) fn slots(&self) -> &Slots {
        &self.slots
    }

    /// One record a slot, free slots included.
    #[must_use]
    pub(crate) fn rows(&self) -> &Column<T> {
        &self.rows
    }

    /// Stores a record in the lowest free slot. O(log free), or O(n) while a clone shares it.
    pub(crate) fn insert(&mut self, row: T) -> Handle {
        let handle = self.slots.insert();
        let rows = self.rows.edit();
        if handle.slot() == rows.len() {
            rows.push(row);
        } else {
            rows[handle.slot()] = row;
        }
        handle
    }

    /// Removes a record; `None` if the handle is stale.
    pub(crate) fn remove(&mut self, handle: Handle) -> Option<T> {
        let removed = self.slots.remove(handle);
        removed.then(|| core::mem::take(&mut self.rows.edit()[handle.slot()]))
    }

    /// The record of a living object.
    #[must_use]
    pub(crate) fn get(&self, handle: Handle) -> Option<&T> {
        self.slots.contains(handle).then(|| &self.rows[handle.slot()])
    }

    /// Replaces the record of a living object; a stale handle changes nothing.
    pub(crate) fn set(&mut self, handle: Handle, row: T) {
        if let Some(place) = self.get_mut(handle) {
            *place = row;
        }
    }

    /// Write access to the record of a living object.
    pub(crate) fn get_mut(&mut self, handle: Handle) -> Option<&mut T> {
        self.slots.contains(handle).then(|| &mut self.rows.edit()[handle.slot()])
    }

    /// Write access to something that nothing is derived from.
    pub(crate) fn adjust(&mut self, handle: Handle) -> Option<&mut T> {
        self.slots.contains(handle).then(|| &mut self.rows.adjust()[handle.slot()])
    }

    /// All living objects in order of their slots.
    pub(crate) fn iter(&self) -> impl Iterator<Item = (Handle, &T)> + '_ {
        self.slots.iter().map(|handle| (handle, &self.rows[handle.slot()]))
    }

    /// Whether anything was written since this was last asked.
    pub(crate) fn take_changed(&mut self) -> bool {
        // Both marks must be taken: no short circuit.
        self.slots.take_changed() | self.rows.take_changed()
    }
}

impl<T> Default for Table<T> {
    fn default() -> Self {
        Self { slots: Slots::default(), rows: Column::default() }
    }
}

impl<T: Clone> Clone for Table<T> {
    fn clone(&self) -> Self {
        let Self { slots, rows } = self;
        Self { slots: slots.clone(), rows: rows.clone() }
    }

    fn clone_from(&mut self, source: &Self) {
        let Self { slots, rows } = source;
        self.slots.clone_from(slots);
        self.rows.clone_from(rows);
    }
}
