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
        let near = self.near.get_or_insert([item; N]);
        if let Some(place) = near.get_mut(self.len) {
            *place = item;
            self.len += 1;
            return;
        }
        if self.far.is_empty() {
            self.far.extend_from_slice(near);
        }
        self.far.push(item);
    }
}

impl<T, const N: usize> Deref for Few<T, N> {
    type Target = [T];
    #[inline]
    fn deref(&self) -> &[T] {
        match &self.near {
            Some(near) if self.far.is_empty() => &near[..self.len],
            _ => &self.far,
        }
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
