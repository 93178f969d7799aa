//! The name of a slot and of its tenant.

use core::fmt;

use serde::{Deserialize, Serialize};

/// A slot's index and the generation of its tenant.
///
/// Generations of living objects are odd, so the handle `0v0` never names one.
#[derive(
    Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default, Serialize, Deserialize,
)]
pub struct Handle {
    /// The slot, counted from 0.
    pub index: u32,
    /// How often the slot changed between free and taken.
    pub generation: u32,
}

impl Handle {
    /// Makes a handle from its two parts, for instance ones that a game stored.
    #[must_use]
    pub const fn new(index: u32, generation: u32) -> Self {
        Self { index, generation }
    }

    /// The index as a subscript.
    #[must_use]
    pub const fn slot(self) -> usize {
        // u32 to usize is lossless: targets below 32 bits are refused in `lib.rs`.
        self.index as usize
    }
}

/// A subscript as an index. Whoever owns slots caps their number below 2^32.
#[inline]
pub(crate) const fn slot_index(slot: usize) -> u32 {
    debug_assert!(slot <= u32::MAX as usize, "more slots than indices");
    #[allow(clippy::cast_possible_truncation, reason = "capped by the owner of the slots")]
    let index = slot as u32;
    index
}

impl fmt::Display for Handle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}v{}", self.index, self.generation)
    }
}
