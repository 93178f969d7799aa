//! Boxes of 32 bits, for the nodes of a tree.

use crate::geometry::Aabb;
use crate::math::Vec3;

/// A box in *coarse* numbers, half the size of an [`Aabb`].
///
/// A number becomes coarse by a function that never falls, so boxes that touch also touch when they
/// are coarse: what a tree of them finds is a superset. The converse does not hold.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Coarse {
    low: [i32; 3],
    high: [i32; 3],
}

/// Raw steps in a coarse one, as a power of two: 61 um, less than any motion that matters here.
const STEP: u32 = 10;

/// Up to 2^25 coarse steps (2 km) numbers are linear, beyond that they are floating.
const LINEAR: u32 = 25;

/// No coarse number is as large: one of `63 - STEP` bits becomes `28 << 24` plus 25 bits.
const BEYOND: i32 = 1 << 29;

/// A coarse number. Monotone: `e` counts octaves beyond the linear ones, each of 2^24 numbers.
fn coarse(raw: i64) -> i32 {
    let steps = raw >> STEP;
    let size = steps.unsigned_abs(); // at most 2^53, which is floored to 54 bits
    let e = (u64::BITS - size.leading_zeros()).saturating_sub(LINEAR);
    // At most 29 * 2^24 + 2^24, below 2^29.
    let code = (u64::from(e) << (LINEAR - 1)) + (size >> e);
    let code = i32::try_from(code).unwrap_or(BEYOND);
    if steps < 0 { -code } else { code }
}

impl Coarse {
    /// A box that touches nothing and adds nothing.
    pub(super) const NOTHING: Self = Self { low: [BEYOND; 3], high: [-BEYOND; 3] };

    /// A box seen from `origin`: the finest numbers are there.
    pub(super) fn new(bounds: &Aabb, origin: Vec3) -> Self {
        let from = |corner: Vec3| {
            let [corner, origin] = [corner.raw(), origin.raw()];
            // A region may lie anywhere, so that differences may not fit.
            [0, 1, 2].map(|k| coarse(corner[k].saturating_sub(origin[k])))
        };
        Self { low: from(bounds.min()), high: from(bounds.max()) }
    }

    /// Whether they touch.
    #[inline]
    pub(super) fn touches(&self, other: &Self) -> bool {
        // Negative where they are apart. Numbers are within +-2^29, so nothing wraps.
        let gap = |k: usize| (other.high[k] - self.low[k]) | (self.high[k] - other.low[k]);
        gap(0) | gap(1) | gap(2) >= 0
    }

    /// The smallest box around both.
    #[inline]
    pub(super) fn union(&self, other: &Self) -> Self {
        Self {
            low: [0, 1, 2].map(|k| self.low[k].min(other.low[k])),
            high: [0, 1, 2].map(|k| self.high[k].max(other.high[k])),
        }
    }

    /// Twice the middle, along each axis.
    #[inline]
    pub(super) fn middle(&self) -> [i32; 3] {
        [0, 1, 2].map(|k| self.low[k] + self.high[k])
    }

    /// The sum of its three edges, at most 3 * 2^30: what a tree keeps short.
    #[inline]
    pub(super) fn girth(&self) -> i64 {
        let edge = |k: usize| i64::from(self.high[k] - self.low[k]);
        edge(0) + edge(1) + edge(2)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Coarse numbers never fall, are odd up to flooring, and stay below `BEYOND`.
    #[test]
    fn coarse_numbers_are_monotone() {
        let powers = (0..63).map(|power| 1i64 << power);
        let near = powers.flat_map(|power| (-2..=2).map(move |step| power.saturating_add(step)));
        let mut numbers: alloc::vec::Vec<_> = near.flat_map(|n| [n, -n]).collect();
        numbers.extend([i64::MIN, i64::MAX]);
        numbers.sort_unstable();
        assert!(numbers.is_sorted_by_key(|&number| coarse(number)));
        assert!(coarse(i64::MAX) < BEYOND && coarse(i64::MIN) > -BEYOND);
        let linear = 1 << (STEP + LINEAR - 1);
        assert_eq!(coarse(linear), 1 << (LINEAR - 1), "linear as far as it is said to be");
        assert_eq!(coarse(linear + 1024) - coarse(linear), 1);
    }
}
