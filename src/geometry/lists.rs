//! Many short lists.

use alloc::vec;
use alloc::vec::Vec;

/// Many lists in one: list k is `items[starts[k]..starts[k + 1]]`.
///
/// All together have fewer than 2^32 items, which those who make them prove.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub(crate) struct Lists {
    starts: Vec<u32>,
    items: Vec<u32>,
}

impl Lists {
    /// No list.
    pub(crate) fn new() -> Self {
        Self { starts: vec![0], items: Vec::new() }
    }

    /// For every vertex the other ends of its edges, sorted. Of each edge the ends are given, the
    /// lower one first, and edges sorted.
    ///
    /// In their order a vertex meets its lower neighbours first, then the higher ones, each in
    /// order: no list needs sorting. There are at most 6 * 2^23 items, two for each side of a face.
    pub(crate) fn neighbours(
        edges: impl Iterator<Item = [u32; 2]> + Clone,
        vertices: usize,
    ) -> Self {
        let mut starts = vec![0_u32; vertices + 1];
        for [a, b] in edges.clone() {
            starts[a as usize + 1] += 1;
            starts[b as usize + 1] += 1;
        }
        for k in 1..starts.len() {
            starts[k] += starts[k - 1];
        }
        let mut next = starts.clone();
        let mut items = vec![0; starts[vertices] as usize];
        for [a, b] in edges {
            for (vertex, neighbour) in [(a, b), (b, a)] {
                let place = &mut next[vertex as usize];
                items[*place as usize] = neighbour;
                *place += 1;
            }
        }
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
