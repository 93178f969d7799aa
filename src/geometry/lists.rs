//! Many short lists.

use alloc::vec;
use alloc::vec::Vec;

/// Many lists in one: list k is `items[starts[k]..starts[k + 1]]`.
///
/// All together have fewer than 2^32 items, which those who make them prove.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Lists {
    starts: Vec<u32>,
    items: Vec<u32>,
}

impl Lists {
    /// No list.
    pub(crate) fn new() -> Self {
        Self { starts: vec![0], items: Vec::new() }
    }

    /// Lists that begin where `starts` says: one more number than there are lists, ascending from
    /// 0 to the number of items.
    pub(crate) fn between(starts: Vec<u32>, items: Vec<u32>) -> Self {
        Self { starts, items }
    }

    /// Adds a list behind the others.
    #[expect(clippy::cast_possible_truncation, reason = "fewer than 2^32 items")]
    pub(crate) fn push(&mut self, list: impl IntoIterator<Item = u32>) {
        self.items.extend(list);
        self.starts.push(self.items.len() as u32);
    }

    /// List `k`, empty if there is none.
    #[inline]
    pub(crate) fn get(&self, k: usize) -> &[u32] {
        match self.starts.get(k..).unwrap_or_default() {
            [start, end, ..] => &self.items[*start as usize..*end as usize],
            _ => &[],
        }
    }

    /// How many lists there are.
    #[inline]
    pub(crate) fn len(&self) -> usize {
        self.starts.len() - 1
    }

    /// The lists, in order.
    pub(crate) fn iter(&self) -> impl ExactSizeIterator<Item = &[u32]> {
        self.starts.windows(2).map(|ends| &self.items[ends[0] as usize..ends[1] as usize])
    }
}
