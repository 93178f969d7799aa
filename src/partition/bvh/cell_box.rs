//! Boxes of cells.

use super::cells::Frame;
use super::volume::Enclose;

/// A box along the axes, in cells of a [`Bvh`](super::Bvh): the volume that suits most meshes.
///
/// Six numbers in two times four lanes, of which the fourth stay 0: comparing two boxes is two
/// comparisons of registers.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[repr(C, align(16))]
pub struct CellBox {
    min: [i32; 4],
    max: [i32; 4],
}

impl CellBox {
    /// The box between two corners, `min` the lowest.
    pub(super) const fn new(min: [i32; 3], max: [i32; 3]) -> Self {
        let ([x, y, z], [u, v, w]) = (min, max);
        Self { min: [x, y, z, 0], max: [u, v, w, 0] }
    }

    pub(super) const fn min(&self) -> [i32; 3] {
        let [x, y, z, _] = self.min;
        [x, y, z]
    }

    pub(super) const fn max(&self) -> [i32; 3] {
        let [x, y, z, _] = self.max;
        [x, y, z]
    }

    /// The smallest box around both.
    #[inline]
    pub(super) fn union(&self, other: &Self) -> Self {
        let mut union = *self;
        for k in 0..4 {
            union.min[k] = union.min[k].min(other.min[k]);
            union.max[k] = union.max[k].max(other.max[k]);
        }
        union
    }

    /// The lengths of its edges: at most 2^28 for a box of points.
    pub(super) fn extents(&self) -> [i64; 3] {
        let (min, max) = (self.min(), self.max());
        [0, 1, 2].map(|k| i64::from(max[k]) - i64::from(min[k]))
    }

    /// Its centre, rounded down.
    pub(super) fn centre(&self) -> [i32; 3] {
        let (min, max) = (self.min(), self.max());
        // Within 0..=2^28.
        [0, 1, 2].map(|k| (min[k] + max[k]) >> 1)
    }

    /// Its eight corners; only one if they are all the same.
    pub(super) fn corners(&self) -> impl Iterator<Item = [i32; 3]> {
        let ends = [self.min(), self.max()];
        let count = if ends[0] == ends[1] { 1 } else { 8 };
        (0..count).map(move |c| [ends[c & 1][0], ends[c >> 1 & 1][1], ends[c >> 2][2]])
    }
}

impl Enclose for CellBox {
    #[inline]
    fn around(parts: &[CellBox]) -> Self {
        parts[1..].iter().fold(parts[0], |bounds, part| bounds.union(part))
    }

    fn contains(&self, cell: &CellBox) -> bool {
        self.union(cell) == *self
    }

    fn bounds(&self) -> CellBox {
        *self
    }

    #[inline]
    fn framed(&self, frame: &Frame) -> Self {
        let [min, max] = frame.outward(self.min, self.max);
        Self { min, max }
    }

    #[inline]
    fn overlaps(&self, other: &Self) -> bool {
        let mut apart = 0;
        for k in 0..4 {
            apart |= i32::from(self.min[k] > other.max[k]) | i32::from(other.min[k] > self.max[k]);
        }
        apart == 0
    }
}
