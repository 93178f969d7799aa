//! Points in few bits, counted from the lowest corner of what they belong to.

use crate::geometry::Aabb;
use crate::math::Vec3;
use crate::math::wide::{round_shift, sub};

/// Cells as wide as a power of two of raw units, laid over a box from its lowest corner.
///
/// A point goes to the nearest corner of a cell. Only differences from the base are rounded, so
/// that what is derived is the same wherever the box is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Lattice {
    bounds: Aabb,
    shift: u32,
}

impl Lattice {
    /// The finest cells, single raw units at best, of which at most 2^`bits` are as long as the
    /// box, whose corners are within 2^60.
    pub(super) fn over(bounds: Aabb, bits: u32) -> Self {
        Self { bounds, shift: (u64::BITS - bounds.span().leading_zeros()).saturating_sub(bits) }
    }

    /// A point of the box in cells: exact where cells are raw units.
    pub(super) fn cell(&self, point: Vec3) -> [i64; 3] {
        // At most 2^61, and below 2^(bits + shift): rounding reaches 2^bits and no more.
        let along = sub(point.raw(), self.bounds.min().raw());
        if self.shift == 0 { along } else { along.map(|c| round_shift(c, self.shift)) }
    }

    /// The point of the box that is nearest to a cell.
    pub(super) fn point(&self, cell: [i64; 3]) -> Vec3 {
        let (min, max) = (self.bounds.min().raw(), self.bounds.max().raw());
        // The caller's cells are at most 2^bits: within 2^60 + 2^62.
        Vec3::from_raw([0, 1, 2].map(|k| (min[k] + (cell[k] << self.shift)).clamp(min[k], max[k])))
    }
}
