//! Spheres in cells.

use super::cell_box::CellBox;
use super::cells::Frame;
use super::volume::{Enclose, root_up};
use crate::math::wide::to_i32;

/// A sphere, in cells of a [`Bvh`](super::Bvh). Its centre and radius are whole numbers of cells.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct CellSphere {
    centre: [i32; 3],
    /// At most half of the diagonal of 2^28 cells along each axis: below 2^28.
    radius: i32,
}

impl CellSphere {
    /// The square of the way from the centre to the farthest point of a box.
    ///
    /// Both are within 0..=2^28: at most 3 * 2^56.
    fn farthest_sq(centre: [i32; 3], part: &CellBox) -> u64 {
        let (min, max) = (part.min(), part.max());
        let along = |k: usize| centre[k].abs_diff(min[k]).max(centre[k].abs_diff(max[k]));
        [0, 1, 2].map(|k| u64::from(along(k)).pow(2)).into_iter().sum()
    }
}

impl Enclose for CellSphere {
    fn around(parts: &[CellBox]) -> Self {
        let centre = CellBox::around(parts).centre();
        let farthest = parts.iter().map(|part| Self::farthest_sq(centre, part)).max();
        Self { centre, radius: to_i32(root_up(farthest.unwrap_or(0))) }
    }

    fn contains(&self, cell: &CellBox) -> bool {
        Self::farthest_sq(self.centre, cell) <= u64::from(self.radius.unsigned_abs()).pow(2)
    }

    fn bounds(&self) -> CellBox {
        let Self { centre, radius } = *self;
        CellBox::new(centre.map(|c| c - radius), centre.map(|c| c + radius))
    }

    fn framed(&self, frame: &Frame) -> Self {
        Self { centre: frame.point(self.centre), radius: frame.radius(self.radius) }
    }

    #[inline]
    fn overlaps(&self, other: &Self) -> bool {
        // Centres are within 0..=2^28 and, framed, within -2^28 - 2..=2^29 + 2: squares below 2^60.
        let away = |k: usize| i64::from(self.centre[k]) - i64::from(other.centre[k]);
        let reach = i64::from(self.radius) + i64::from(other.radius);
        away(0).pow(2) + away(1).pow(2) + away(2).pow(2) <= reach.pow(2)
    }
}
