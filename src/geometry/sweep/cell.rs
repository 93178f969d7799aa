//! Boxes of times and places.

use core::cmp::Ordering;

use crate::math::Unit;

/// A box in `[0, 1]^3` of t, u and v that halving has led to: along each axis from
/// `place / 2^level` to `(place + 1) / 2^level`.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct Cell {
    places: [u32; 3],
    levels: [u8; 3],
}

impl Cell {
    /// The level at which an axis is halved no more.
    pub(super) const LEVEL_MAX: u8 = 30;

    /// All of it.
    pub(super) const ALL: Self = Self { places: [0; 3], levels: [0; 3] };

    /// All places, from a time on for 2^-30: the last such for 1.
    pub(super) fn at(time: Unit) -> Self {
        let last = (1 << Self::LEVEL_MAX) - 1;
        let place = time.raw().cast_unsigned().min(last);
        Self { places: [place, 0, 0], levels: [Self::LEVEL_MAX, 0, 0] }
    }

    /// The lower or upper half along an axis that [has levels left](Self::levels_left).
    #[inline]
    pub(super) fn half(mut self, axis: usize, is_upper: bool) -> Self {
        self.levels[axis] += 1;
        self.places[axis] = 2 * self.places[axis] + u32::from(is_upper);
        self
    }

    /// The smallest box of halves that holds a range along an axis, from `first` to `last` of the
    /// 2^[levels left](Self::levels_left) parts of which 30 levels would be made: both below that.
    #[inline]
    #[allow(clippy::cast_possible_truncation, reason = "at most 30 levels")]
    pub(super) fn narrowed(mut self, axis: usize, [first, last]: [u32; 2]) -> Self {
        let below = u32::BITS - (first ^ last).leading_zeros();
        let deeper = self.levels_left(axis) - below;
        self.levels[axis] += deeper as u8;
        self.places[axis] = self.places[axis] << deeper | first >> below;
        self
    }

    /// How many levels are left.
    #[inline]
    pub(super) fn levels_left(&self, axis: usize) -> u32 {
        u32::from(Self::LEVEL_MAX - self.levels[axis])
    }

    /// The middle along an axis, in units of 2^-30, rounded down.
    #[inline]
    pub(super) fn middle(&self, axis: usize) -> i64 {
        i64::from(self.low(axis)) + ((1 << self.levels_left(axis)) >> 1)
    }

    #[inline]
    pub(super) fn levels(&self) -> [u32; 3] {
        self.levels.map(u32::from)
    }

    /// How much smaller its units are than those of what it is a part of: see
    /// [`Row::span`](super::row::Row::span).
    #[inline]
    pub(super) fn scale(&self) -> u32 {
        let [of_t, of_u, of_v] = self.levels();
        of_t + of_u.max(of_v)
    }

    /// Below 2^30.
    #[inline]
    pub(super) fn places(&self) -> [i64; 3] {
        self.places.map(i64::from)
    }

    /// Where it begins along an axis, in units of 2^-30.
    #[inline]
    pub(super) fn low(&self, axis: usize) -> u32 {
        self.places[axis] << (Self::LEVEL_MAX - self.levels[axis])
    }

    /// When it begins, in units of 2^-30.
    #[inline]
    pub(super) fn time(&self) -> u32 {
        self.low(0)
    }

    /// Whether it lasts until time 1.
    #[inline]
    pub(super) fn is_last(&self) -> bool {
        let end = self.places[0] + 1;
        if cfg!(planted) { false } else { end >> self.levels[0] == 1 }
    }

    /// Where `u + v` is least, compared with 1: no more of it than a corner is in the triangle if
    /// equal, and nothing if greater.
    #[inline]
    pub(super) fn reach(&self) -> Ordering {
        // Each is at most 2^30.
        (self.low(1) + self.low(2)).cmp(&(1 << Self::LEVEL_MAX))
    }
}
