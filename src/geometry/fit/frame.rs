//! Where shapes are searched for.

use alloc::vec::Vec;

use crate::geometry::ConvexHull;
use crate::math::Vec3;
use crate::math::determinant::cross;
use crate::math::wide::{add, round_div_wide, round_shift, round_shift_wide, sub, to_i64};

/// A hull in small integers, whatever its size: units from the middle of its box, of which it
/// measures from 2^20 to 2^21 along its longest side.
pub(super) struct Frame {
    origin: [i64; 3],
    /// A unit is 2^this, raw.
    shift: i32,
    /// The vertices: components are at most 2^20 + 1, lengths below 2^21.
    pub(super) points: Vec<[i64; 3]>,
}

/// Bits behind the point of finer units.
pub(super) const FINE_BITS: u32 = 8;

/// Bits of the longest side.
const BITS: i32 = 21;

impl Frame {
    pub(super) fn of(hull: &ConvexHull) -> Self {
        let bounds = hull.bounds();
        let [low, high] = [bounds.min(), bounds.max()].map(Vec3::raw);
        let origin = [0, 1, 2].map(|k| low[k] + (high[k] - low[k]) / 2);
        // A span has from 1 to 41 bits.
        let shift = 64 - bounds.span().leading_zeros().cast_signed() - BITS;
        let mut frame = Self { origin, shift, points: Vec::new() };
        frame.points = hull.vertices().iter().map(|&vertex| frame.units(vertex)).collect();
        frame
    }

    /// A point of the hull.
    pub(super) fn units(&self, point: Vec3) -> [i64; 3] {
        sub(point.raw(), self.origin).map(|c| match self.shift {
            ..=0 => c << -self.shift,
            1.. => round_shift(c, self.shift.unsigned_abs()),
        })
    }

    /// The place in the world of a point in fine units, at most 2^32 from the middle.
    pub(super) fn place(&self, fine: [i64; 3]) -> Vec3 {
        let along = |c: i64| match self.shift - FINE_BITS.cast_signed() {
            left @ 0.. => c << left, // at most 12
            right => to_i64(round_shift_wide(c.into(), right.unsigned_abs())),
        };
        Vec3::from_raw(add(self.origin, fine.map(along)))
    }

    /// A unit, raw, at least 1.
    pub(super) fn unit(&self) -> i64 {
        1 << self.shift.max(0)
    }
}

/// The point that three planes have in common, `rows[i] . x = values[i]`, rounded to nearest;
/// `None` if there is not just one.
///
/// Rows have lengths of at most 2^46, two of them products of lengths of at most 2^69, and these
/// times three values at most 2^126: callers prove it.
pub(super) fn meet(rows: [[i64; 3]; 3], values: [i128; 3]) -> Option<[i128; 3]> {
    let [a, b, c] = rows;
    let crosses = [cross(b, c), cross(c, a), cross(a, b)];
    let volume: i128 = (0..3).map(|k| i128::from(a[k]) * crosses[0][k]).sum();
    (volume != 0).then(|| {
        [0, 1, 2].map(|k| {
            let sum: i128 = (0..3).map(|i| values[i] * crosses[i][k]).sum();
            round_div_wide(sum * volume.signum(), volume.abs())
        })
    })
}
