//! The grid that the volumes of a tree are rounded to.

use super::cell_box::CellBox;
use crate::geometry::{Aabb, Triangle};
use crate::math::Vec3;

/// No more than 2^28 cells along an axis, which leaves room for two trees in one 32-bit frame.
pub(super) const CELLS_BITS: u32 = 28;
pub(super) const CELLS_MAX: i32 = 1 << CELLS_BITS;

/// Cells as wide as a power of two, counted from the lowest corner of the mesh.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Cells {
    base: [i64; 3],
    shift: u32,
}

/// The way from the cells of one tree to those of another, which are at least as wide.
///
/// Coordinates of boxes are rounded outward; those of centres and axes down, for which radii grow
/// by `slack`.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    shift: u32,
    /// What lowest coordinates are moved by, and highest ones; 0 in the fourth lane.
    low: [i32; 4],
    high: [i32; 4],
    slack: i32,
}

impl Cells {
    /// The finest cells in which all these points are within `0..=CELLS_MAX`.
    pub(super) fn around(points: &[Vec3]) -> Self {
        let (base, span) = Aabb::around(points.iter().copied())
            .as_ref()
            .map_or(([0; 3], 0), |bounds| (bounds.min().raw(), bounds.span()));
        let shift = (u64::BITS - span.leading_zeros()).saturating_sub(CELLS_BITS);
        Self { base, shift }
    }

    /// The cell of a point inside: a cube, or the point itself where cells are single.
    #[inline]
    #[allow(clippy::cast_possible_truncation, reason = "at most CELLS_MAX")]
    pub(super) fn of_point(&self, point: Vec3) -> CellBox {
        let Self { base, shift } = *self;
        let mut cell = [0; 3];
        let mut over = [0; 3];
        for (k, c) in point.raw().into_iter().enumerate() {
            // Coordinates are within 2^60, so this is below 2^62, and below 2^(28 + shift).
            let along = c - base[k];
            cell[k] = (along >> shift) as i32;
            over[k] = if cfg!(planted) { cell[k] } else { -(-along >> shift) as i32 };
        }
        CellBox::new(cell, over)
    }

    /// The lowest and the highest corner of a box of cells, raw: less than a cell beyond 2^60.
    #[inline]
    pub(super) fn corners(&self, cells: &CellBox) -> [[i64; 3]; 2] {
        let Self { base, shift } = *self;
        // At most 2^28 cells of at most 2^34.
        [cells.min(), cells.max()]
            .map(|corner| [0, 1, 2].map(|k| base[k] + (i64::from(corner[k]) << shift)))
    }

    /// Whether a point lies in a box of cells. Exact.
    pub(super) fn holds(&self, cells: &CellBox, point: Vec3) -> bool {
        let Self { base, shift } = *self;
        let (min, max, point) = (cells.min(), cells.max(), point.raw());
        // At most 2^28 cells of at most 2^34.
        (0..3).all(|k| {
            let edges = i64::from(min[k]) << shift..=i64::from(max[k]) << shift;
            edges.contains(&(point[k] - base[k]))
        })
    }

    /// The smallest box around a triangle inside.
    pub(super) fn of_triangle(&self, triangle: &Triangle) -> CellBox {
        let [a, b, c] = triangle.corners().map(|corner| self.of_point(corner));
        a.union(&b).union(&c)
    }

    /// The smallest box around any other; what is far outside stays outside.
    pub(super) fn of_box(&self, bounds: &Aabb) -> CellBox {
        let Self { base, shift } = *self;
        let (min, max) = (bounds.min().raw(), bounds.max().raw());
        // The difference of any two coordinates fits; it is cut to just outside of 0..=CELLS_MAX.
        let cut = |cell: i128| cell.clamp(-1, i128::from(CELLS_MAX) + 1);
        let along = |c: i64, k: usize| i128::from(c) - i128::from(base[k]);
        let low = |k| to_cell(cut(along(min[k], k) >> shift));
        let high = |k| to_cell(cut(-(-along(max[k], k) >> shift)));
        CellBox::new([0, 1, 2].map(low), [0, 1, 2].map(high))
    }

    /// How wide a cell is: a power of two, raw.
    pub(super) const fn shift(&self) -> u32 {
        self.shift
    }

    /// Whether cells are at least as wide as others.
    pub(super) const fn is_coarser(&self, other: &Self) -> bool {
        self.shift >= other.shift
    }

    /// The way from finer cells to these, on which boxes grow by `reach` raw units to every side;
    /// `None` if the trees are too far apart for that.
    ///
    /// Only boxes grow: spheres and cylinders take no reach but 0.
    #[allow(clippy::cast_possible_truncation, reason = "cut to 2 CELLS_MAX")]
    pub(super) fn frame(&self, finer: &Self, reach: i64) -> Option<Frame> {
        // Up to 34; by 31 nothing is left of a cell already.
        let shift = (self.shift - finer.shift).min(i32::BITS - 1);
        let mut frame = Frame { shift, low: [0; 4], high: [0; 4], slack: 0 };
        let reach = reach.min(Triangle::COORDINATE_MAX);
        for k in 0..3 {
            // Both are within 2^60.
            let way = finer.base[k] - self.base[k];
            let (low, high) = ((way - reach) >> self.shift, -((-way - reach) >> self.shift));
            // Both trees are within 0..=CELLS_MAX of their own cells.
            if low.max(-high) > i64::from(CELLS_MAX) {
                return None;
            }
            // Boxes that reach farther than this reach everything.
            let beyond = 2 * i64::from(CELLS_MAX);
            (frame.low[k], frame.high[k]) = (low.max(-beyond) as i32, high.min(beyond) as i32);
        }
        // A centre loses less than 1 by the shift and less than 1 by the way, an end of a half
        // axis less than 1 more: less than 3 along each axis, 3 sqrt 3 < 6 in all.
        if frame.shift > 0 || frame.low != frame.high {
            frame.slack = 6;
        }
        Some(frame)
    }
}

impl Frame {
    /// By how many bits the new cells are wider.
    pub(super) const fn shift(&self) -> u32 {
        self.shift
    }

    /// A box, rounded outward: its lowest corner, then its highest.
    #[inline]
    pub(super) fn outward(&self, mut min: [i32; 4], mut max: [i32; 4]) -> [[i32; 4]; 2] {
        for k in 0..4 {
            // Within 0..=2^28 and moved by no more than 2^29.
            min[k] = (min[k] >> self.shift) + self.low[k];
            max[k] = self.high[k] - (-max[k] >> self.shift);
        }
        [min, max]
    }

    /// A point, rounded down.
    pub(super) fn point(&self, point: [i32; 3]) -> [i32; 3] {
        [0, 1, 2].map(|k| (point[k] >> self.shift) + self.low[k])
    }

    /// A difference, rounded down.
    pub(super) fn difference(&self, difference: [i32; 3]) -> [i32; 3] {
        difference.map(|c| c >> self.shift)
    }

    /// A radius, with what points lose by being rounded.
    pub(super) fn radius(&self, radius: i32) -> i32 {
        self.slack - (-radius >> self.shift)
    }
}

/// A number of cells that has been cut to what fits.
#[allow(clippy::cast_possible_truncation, reason = "cut by the caller")]
fn to_cell(cell: i128) -> i32 {
    cell as i32
}

#[cfg(test)]
mod tests {
    use super::super::volume::Enclose;
    use super::super::{CellCylinder, CellSphere};
    use super::*;
    use crate::math::Pcg;

    /// A volume in cells of its own meets whatever is around one of its points in wider cells.
    fn is_kept_by_frames<V: Enclose>() {
        let mut rng = Pcg::new(1, 0);
        for _ in 0..20_000 {
            let shift = rng.below(8);
            let coarse = Cells { base: [0; 3], shift: shift + rng.below(8) };
            let mut near = || i64::from(rng.below(16 << coarse.shift));
            let corner = [near(), near(), near()];
            let fine = Cells { base: corner, shift };
            let points = [(); 3].map(|()| Vec3::from_raw(corner.map(|c| c + near())));
            let volume = V::around(&points.map(|point| fine.of_point(point)));
            let framed = volume.framed(&coarse.frame(&fine, 0).expect("near"));
            for point in points {
                let around = V::around(&[coarse.of_point(point)]);
                assert!(around.overlaps(&framed), "{point:?} of {framed:?} is not near {around:?}");
            }
        }
    }

    #[test]
    fn frames_round_outward() {
        is_kept_by_frames::<CellBox>();
        is_kept_by_frames::<CellSphere>();
        is_kept_by_frames::<CellCylinder>();
    }

    #[test]
    fn cells_hold_their_points() {
        const MAX: i64 = Triangle::COORDINATE_MAX;
        for span in [0, 1, (1 << 28) - 1, 1 << 28, (1 << 28) + 1, (1 << 40) - 1, 2 * MAX] {
            let ends = [-MAX, span - MAX].map(|c| Vec3::from_raw([c; 3]));
            let cells = Cells::around(&ends);
            assert_eq!(cells.shift == 0, span < 1 << 28);
            for off in [0, 1, 7, span / 3, span - 1, span] {
                let point = Vec3::from_raw([off.clamp(0, span) - MAX; 3]);
                let cell = cells.of_point(point);
                assert!(cells.holds(&cell, point));
                let [low, high] = [cell.min()[0], cell.max()[0]];
                assert!(0 <= low && high <= CELLS_MAX && high - low <= 1, "{cell:?}");
                assert_eq!(
                    low == high,
                    (off.clamp(0, span) >> cells.shift) << cells.shift == off.clamp(0, span)
                );
            }
        }
    }
}
