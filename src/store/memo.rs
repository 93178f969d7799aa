//! A derived value that is kept until its source changes.

/// A cache cell that fills through a shared reference.
///
/// Without `std` there is no lock to fill it under, so the value is computed at every call. A memo
/// can therefore never change a result, only the time it takes.
#[derive(Debug)]
pub(crate) struct Memo<T> {
    #[cfg(feature = "std")]
    cell: std::sync::OnceLock<T>,
    #[cfg(not(feature = "std"))]
    none: core::marker::PhantomData<T>,
}

impl<T: Copy> Memo<T> {
    /// The value kept, or `compute()`, which is then kept.
    #[cfg(feature = "std")]
    pub(crate) fn get_or(&self, compute: impl FnOnce() -> T) -> T {
        *self.cell.get_or_init(compute)
    }

    /// The value of `compute()`.
    #[cfg(not(feature = "std"))]
    #[allow(clippy::unused_self, reason = "there is nothing to fill")]
    pub(crate) fn get_or(&self, compute: impl FnOnce() -> T) -> T {
        compute()
    }

    /// Forgets the value: call this wherever the source changes.
    #[cfg(feature = "std")]
    pub(crate) fn clear(&mut self) {
        self.cell.take();
    }

    /// Nothing to forget.
    #[cfg(not(feature = "std"))]
    #[allow(clippy::unused_self, reason = "there is nothing to forget")]
    pub(crate) fn clear(&mut self) {}
}

impl<T> Default for Memo<T> {
    fn default() -> Self {
        Self {
            #[cfg(feature = "std")]
            cell: std::sync::OnceLock::new(),
            #[cfg(not(feature = "std"))]
            none: core::marker::PhantomData,
        }
    }
}
