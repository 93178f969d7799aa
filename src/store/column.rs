//! One array of seldom changed records.

use alloc::sync::Arc;
use alloc::vec::Vec;
use core::ops::Deref;

use super::Memo;

/// Records that change seldom: shared between clones, copied when one of them is edited.
///
/// A clone costs a reference count, so that a ring of saved worlds holds one copy of what did not
/// change. Every way to write drops the kept hash; [`edit`](Self::edit) also raises the mark that
/// tells the owner to rebuild what it derived.
#[derive(Clone, Debug)]
pub(crate) struct Column<T> {
    shared: Arc<Shared<T>>,
    changed: bool,
}

#[derive(Debug, Default)]
struct Shared<T> {
    items: Vec<T>,
    hash: Memo<u128>,
}

impl<T: Clone> Clone for Shared<T> {
    fn clone(&self) -> Self {
        // Cloned only to be edited: the hash would be wrong at once.
        Self { items: self.items.clone(), hash: Memo::default() }
    }
}

impl<T: Clone> Column<T> {
    /// Write access. O(1), or O(n) while a clone shares the records.
    pub(crate) fn edit(&mut self) -> &mut Vec<T> {
        self.changed = true;
        self.adjust()
    }

    /// Write access to what nothing is derived from but the hash: the mark is not raised.
    pub(crate) fn adjust(&mut self) -> &mut Vec<T> {
        let shared = Arc::make_mut(&mut self.shared);
        shared.hash.clear();
        &mut shared.items
    }

    /// Whether the records were edited since this was last asked.
    pub(crate) fn take_changed(&mut self) -> bool {
        core::mem::take(&mut self.changed)
    }

    /// The hash of the records: the kept one, or what `compute` makes of them.
    pub(crate) fn hash_or(&self, compute: impl FnOnce() -> u128) -> u128 {
        self.shared.hash.get_or(compute)
    }
}

impl<T> From<Vec<T>> for Column<T> {
    fn from(items: Vec<T>) -> Self {
        Self { shared: Arc::new(Shared { items, hash: Memo::default() }), changed: true }
    }
}

impl<T> Default for Column<T> {
    fn default() -> Self {
        Self::from(Vec::new())
    }
}

impl<T> Deref for Column<T> {
    type Target = [T];

    fn deref(&self) -> &[T] {
        &self.shared.items
    }
}
