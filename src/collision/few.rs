//! Lists that are short almost always.

use alloc::vec::Vec;
use core::ops::Deref;

/// A list that needs no allocation up to `N` items.
#[derive(Clone, Debug)]
pub(super) struct Few<T, const N: usize> {
    /// Filled up with copies of the first one; none of none.
    near: Option<[T; N]>,
    len: usize,
    /// All items, once there are more than `N`.
    far: Vec<T>,
}

impl<T: Copy, const N: usize> Few<T, N> {
    #[inline]
    pub(super) const fn new() -> Self {
        Self { near: None, len: 0, far: Vec::new() }
    }

    #[inline]
    pub(super) fn push(&mut self, item: T) {
        match &mut self.near {
            Some(near) if self.len < N => near[self.len] = item,
            Some(_) => self.push_far(item),
            None => self.near = Some([item; N]),
        }
        self.len += 1;
    }

    #[cold]
    fn push_far(&mut self, item: T) {
        if self.far.is_empty() {
            self.far.extend(self.near.iter().flatten());
        }
        self.far.push(item);
    }
}

impl<T, const N: usize> Deref for Few<T, N> {
    type Target = [T];
    #[inline]
    fn deref(&self) -> &[T] {
        self.near.as_ref().and_then(|near| near.get(..self.len)).unwrap_or(&self.far)
    }
}

impl<T, const N: usize> From<[T; N]> for Few<T, N> {
    #[inline]
    fn from(items: [T; N]) -> Self {
        Self { near: Some(items), len: N, far: Vec::new() }
    }
}

impl<T: Copy, const N: usize> FromIterator<T> for Few<T, N> {
    #[inline]
    fn from_iter<I: IntoIterator<Item = T>>(items: I) -> Self {
        let mut few = Self::new();
        few.extend(items);
        few
    }
}

impl<T: Copy, const N: usize> Extend<T> for Few<T, N> {
    #[inline]
    fn extend<I: IntoIterator<Item = T>>(&mut self, items: I) {
        items.into_iter().for_each(|item| self.push(item));
    }
}
